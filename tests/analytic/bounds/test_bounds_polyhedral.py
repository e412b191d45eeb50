"""Bounds of the polyhedral ring beside what they are independent of, where both can be asked."""

from dataclasses import replace
from math import atan, radians

import numpy as np
import pytest

from analytic.bounds.polyhedral import contacts, flat, thin_ring, wedge
from analytic.bounds.polyhedral.contacts import RollerOnRing
from analytic.contact import pair_series
from analytic.contact.partial_slip import dundurs_beta
from analytic.polyhedral import expansion, wedging
from analytic.polyhedral.design import Clutch
from analytic.polyhedral.parts import Parts

ROLLER = RollerOnRing(d=0.01, d_e=0.08, j_D=6e-5, apothem=0.03145, E=210e9, nu=0.3)
PARTS = Parts(z=6, d_i=0.072, d_e=0.08, D_i=0.10006, d=0.01, b=0.03, e=0.009)


@pytest.mark.parametrize("E_1", [np.inf, 210e9, 70e9])
@pytest.mark.parametrize("E_2", [210e9, 100e9])
def test_materials_couple_as_dundurs_beta_and_the_meeting_curvature_say(E_1, E_2):
    bodies = {"E_1": E_1, "nu_1": 0.3, "E_2": E_2, "nu_2": 0.3, "assumption": "plane stress"}
    kappa = pair_series.meeting_curvature(R_1=0.005, R_2=0.04, **bodies)
    expected = 1e-4 * kappa * float(dundurs_beta(**bodies))
    found = ROLLER.coupled(1e-4, R_2=0.04, E_1=E_1, E_2=E_2)
    assert found == pytest.approx(expected, rel=1e-13, abs=1e-18)


def test_errors_of_contacts_grow_with_their_width():
    narrow, wide = ROLLER.reach(1e-6), ROLLER.reach(1e-4, 1e-4)
    assert narrow == pytest.approx(contacts.BLUNT, rel=1e-3)
    assert wide > narrow
    assert ROLLER.closure(1e-4, 1e-4) == pytest.approx(wide, rel=1e-13)
    low, high = ROLLER.on_ring(contacts.WIDTH, 1e-4)
    assert low < high < 0.005
    even = replace(ROLLER, j_D=0.0)
    assert even.on_ring(contacts.WIDTH, 1e-4, elastic=True)[1] == pytest.approx(even.reach(1e-4))
    assert ROLLER.bent(R_b=2e5, e=0.018) == pytest.approx(2 * ROLLER.bent(R_b=2e5, e=0.009))


@pytest.mark.parametrize("alpha", [None, radians(6.0)])
def test_statics_by_vectors_are_the_chain_s(alpha):
    steel = {"p_t": 30e6, "E": 210e9, "nu": 0.3, "mu": 0.08, "phi_1": atan(0.05), "alpha": alpha}
    apothem = PARTS.d_i / 2 * np.cos(np.pi / 6)
    parts = flat.FlatParts(z=6, d_i=0.072, D_i=0.10006, b=0.03, e=0.009, apothem=apothem, mu=0.08,
                           phi_1=atan(0.05), alpha=alpha)  # fmt: skip
    first = Clutch(PARTS, **steel, lever="d_i/2", gamma="radius", M_wanted=200.0)
    own = flat.first_design(parts, d_m=0.076, wall=0.004, j_D=PARTS.j_D, E=210e9)
    assert own.torque(30e6) == pytest.approx(first.M_t, rel=1e-12)
    assert own.pressure(200.0) == pytest.approx(first.p_required, rel=1e-12)
    whole = Clutch(PARTS, **steel, K=1.1)
    assert flat.filleted(parts, whole.p_1r).torque(30e6) == pytest.approx(whole.M_t, rel=1e-12)
    per_width = flat.roller_force(p=30e6, touch=whole.p_1r, d_i=0.072, z=6)
    assert per_width == pytest.approx(whole.F / 0.03, rel=1e-12)


def test_the_thin_ring_misses_lame_s_pressure_by_what_is_said():
    ring = {"d_i": 0.072, "d_e": 0.08, "j_D": 6e-5, "E": 210e9}
    thick = expansion.round_ring_pressure(**ring, nu=0.3, ends="plane stress")
    m = float(expansion.touching_pressure(**ring) / thick) - 1
    low, high = thin_ring.pressure_error(d_e=0.08, wall=0.004)
    assert (low + high) / 2 == pytest.approx(m, abs=1e-12)
    for wall in (1e-5, 1e-6):  # all errors go with the wall
        of_growth = thin_ring.growth_error(d_e=0.08, wall=wall, j_D=6e-5, E=210e9, nu=0.3)
        of_rim = thin_ring.rim_stress_error(d_e=0.08, wall=wall)
        for low, high in (of_growth, of_rim):
            assert abs(low + high) / 2 < 30 * wall
            assert high - low == pytest.approx(2 * thin_ring.SLACK, rel=1e-3)


def test_a_free_roller_is_missed_by_friction_s_limit_as_wedging_says():
    angle = {"alpha": 0.1, "mu": 0.08}
    clutch = {"z": 6, "D_i": 0.1}
    printed = wedging.largest_torque(N=1.0, mu=0.08, **clutch)
    m = float(printed / wedging.torque(N=1.0, alpha=0.1, **clutch)) - 1
    assert np.mean(wedge.torque_error(**angle)) == pytest.approx(m, rel=1e-12)
    assert np.mean(wedge.normal_force_error(**angle)) == pytest.approx(1 / (1 + m) - 1, rel=1e-12)
    low, high = wedge.half_planes(a=0.01, R=1.0, mu=0.1)
    assert high == -low == pytest.approx(0.0102)


def test_the_relative_radius_is_that_of_roller_and_ring():
    assert ROLLER.relative_radius == pytest.approx(5e-3 * 40e-3 / 45e-3)
    assert ROLLER.wall == pytest.approx(8.55e-3)

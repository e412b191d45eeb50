"""Bounds of polyhedral rings, loaded races and thick frames against independent models."""

import math
from dataclasses import replace
from math import atan, radians

import numpy as np
import pytest

from analytic.bounds.polyhedral import contacts, flat, thin_ring, wedge
from analytic.bounds.polyhedral.contacts import RollerOnRing
from analytic.bounds.ring import integrated_dent
from analytic.bounds.spring.thick_frame import added
from analytic.contact import pair_series
from analytic.contact.hertz_line_approach import approach_to_depth
from analytic.contact.partial_slip import dundurs_beta
from analytic.polyhedral import expansion, wedging
from analytic.polyhedral.design import PolyhedralClutch
from analytic.polyhedral.parts import PolyhedralParts
from analytic.ring import lame
from analytic.spring import frame

ROLLER = RollerOnRing(d=0.01, d_e=0.08, j_D=6e-5, apothem=0.03145, E=210e9, nu=0.3)
PARTS = PolyhedralParts(z=6, d_i=0.072, d_e=0.08, D_i=0.10006, d=0.01, b=0.03, e=0.009)


@pytest.mark.parametrize("E_1", [np.inf, 210e9, 70e9])
@pytest.mark.parametrize("E_2", [210e9, 100e9])
def test_materials_couple_by_dundurs_beta_and_the_relative_curvature(E_1, E_2):
    bodies = {"E_1": E_1, "nu_1": 0.3, "E_2": E_2, "nu_2": 0.3, "assumption": "plane stress"}
    kappa = pair_series.meeting_curvature(R_1=0.005, R_2=0.04, **bodies)
    expected = 1e-4 * kappa * float(dundurs_beta(**bodies))
    found = ROLLER.coupled(1e-4, R_2=0.04, E_1=E_1, E_2=E_2)
    assert found == pytest.approx(expected, rel=1e-13, abs=1e-18)


@pytest.mark.parametrize("alpha", [None, radians(6.0)])
def test_statics_by_vectors_are_the_chain_s(alpha):
    steel = {"p_t": 30e6, "E": 210e9, "nu": 0.3, "mu": 0.08, "phi_1": atan(0.05), "alpha": alpha}
    apothem = PARTS.d_i / 2 * np.cos(np.pi / 6)
    parts = flat.FlatParts(z=6, d_i=0.072, D_i=0.10006, b=0.03, e=0.009, apothem=apothem, mu=0.08,
                           phi_1=atan(0.05), alpha=alpha)  # fmt: skip
    first = PolyhedralClutch(PARTS, **steel, lever="d_i/2", gamma="radius", M_wanted=200.0)
    own = flat.first_design(parts, d_m=0.076, wall=0.004, j_D=PARTS.j_D, E=210e9)
    assert own.torque(30e6) == pytest.approx(first.M_t, rel=1e-12)
    assert own.pressure(200.0) == pytest.approx(first.p_required, rel=1e-12)
    whole = PolyhedralClutch(PARTS, **steel, K=1.1)
    assert flat.filleted(parts, whole.p_1r).torque(30e6) == pytest.approx(whole.M_t, rel=1e-12)
    per_width = flat.roller_force(p=30e6, touch=whole.p_1r, d_i=0.072, z=6)
    assert per_width == pytest.approx(whole.F / 0.03, rel=1e-12)


def test_the_thin_ring_misses_lame_s_pressure_by_the_stated_amount():
    ring = {"d_i": 0.072, "d_e": 0.08, "j_D": 6e-5, "E": 210e9}
    thick = expansion.round_ring_pressure(**ring, nu=0.3, ends="plane stress")
    m = float(expansion.touching_pressure(**ring) / thick) - 1
    low, high = thin_ring.pressure_error(d_e=0.08, wall=0.004)
    assert (low + high) / 2 == pytest.approx(m, abs=1e-12)
    for wall in (1e-5, 1e-6):  # all errors go with the wall
        of_growth = thin_ring.growth_error(d_e=0.08, wall=wall, j_D=6e-5, E=210e9, nu=0.3)
        of_rim = thin_ring.rim_stress_error(d_e=0.08, wall=wall)
        of_bore = thin_ring.bore_stress_error(d_e=0.08, wall=wall)
        for low, high in (of_growth, of_rim, of_bore):
            assert abs(low + high) / 2 < 30 * wall
            assert high - low == pytest.approx(2 * thin_ring.SLACK, rel=1e-3)


def test_the_thin_ring_misses_the_stress_of_lame_s_bore_by_the_stated_amount():
    ring = {"d_i": 0.056, "d_e": 0.08}
    sigma_t = expansion.hoop_stress(j_D=6e-5, d_m=0.068, E=210e9)
    p = expansion.round_ring_pressure(**ring, j_D=6e-5, E=210e9, nu=0.3, ends="plane stress")
    _, hoop = lame.stresses(0.028, r_i=0.028, r_o=0.04, p_i=p)
    low, high = thin_ring.bore_stress_error(d_e=0.08, wall=0.012)
    assert (low + high) / 2 == pytest.approx(float(sigma_t / hoop) - 1, abs=1e-12)


def test_the_friction_limit_misses_a_free_roller_as_wedging_predicts():
    angle = {"alpha": 0.1, "mu": 0.08}
    clutch = {"z": 6, "D_i": 0.1}
    printed = wedging.largest_torque(N=1.0, mu=0.08, **clutch)
    m = float(printed / wedging.torque(N=1.0, alpha=0.1, **clutch)) - 1
    assert np.mean(wedge.torque_error(**angle)) == pytest.approx(m, rel=1e-12)
    assert np.mean(wedge.normal_force_error(**angle)) == pytest.approx(1 / (1 + m) - 1, rel=1e-12)
    low, high = wedge.half_planes(a=0.01, R=1.0, mu=0.1)
    assert high == -low == pytest.approx(0.0102)


@pytest.mark.parametrize("depth", [0.3, 1.0, 20.0])
@pytest.mark.parametrize("nu", [0.0, 0.3])
def test_the_local_indentation_by_integration_is_that_in_closed_form(depth, nu):
    load = {"P": 2.0, "a": 0.7, "E": 3.0, "nu": nu}
    closed = approach_to_depth(depth, **load, assumption="plane stress")
    assert integrated_dent(depth, **load) == pytest.approx(float(closed), rel=1e-9)


SHAPE = {"n": 10, "L1": 11.6e-3, "radius": 0.45e-3, "alpha": math.radians(80)}


def by_frame(shape, *, b, wide):
    """Shares of the thin frame's flexibility that shear and curvature add."""
    k = [
        frame.stiffness(**shape, b=b, h=0.056, E=206e9, nu=0.3, theory=theory, plane_strain=wide)
        for theory in ("bending", "shear", "thick")
    ]
    return k[0] / k[1] - 1, k[0] / k[2] - k[0] / k[1]


@pytest.mark.parametrize("wide", [False, True])
@pytest.mark.parametrize("change", [{}, {"alpha": math.radians(45), "n": 5}, {"L1": 0.03}])
def test_shear_is_the_frame_s_and_curvature_up_to_the_next_power_of_thickness(wide, change):
    shape, off, shares = SHAPE | change, [], []
    for b in (1e-4, 5e-5):
        shear, curvature = by_frame(shape, b=b, wide=wide)
        found = added(**shape, b=b, nu=0.3, wide=wide)
        assert found.shear == pytest.approx(shear, rel=1e-8)
        off.append(found.curvature - curvature)
        shares.append(curvature)
    assert abs(off[0]) < 0.03 * abs(shares[0])
    assert off[0] / off[1] == pytest.approx(16, rel=0.05)  # (b/R)^4


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


def test_the_relative_radius_is_that_of_roller_and_ring():
    assert ROLLER.relative_radius == pytest.approx(5e-3 * 40e-3 / 45e-3)
    assert ROLLER.wall == pytest.approx(8.55e-3)


def test_the_standard_uncertainty_of_the_largest_stress_is_half_of_its_bound():
    without = ROLLER.fillet_blur(0.0, 1e-4)
    assert without == pytest.approx(contacts.PEAK_STRESS / 2)
    whole = ROLLER.fillet_blur(1.0, 1e-4) - without
    assert whole == pytest.approx(ROLLER.reach(1e-4) / 2)
    assert ROLLER.fillet_blur(0.4, 1e-4) == pytest.approx(without + 0.4 * whole)

"""Locked and driven rings: closure of the gap, balance of torques, locking of the ring."""

import numpy as np
import pytest
from scipy.optimize import brentq

from analytic.contact.hertz_line_approach import approach_to_centre
from analytic.polyhedral.bore_pressure import rim_displacement
from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.hub_force import hub_force
from analytic.polyhedral.locking import Roller, RollerContact, locked
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.sector import Sector

STEEL = {"E": 210e3, "nu": 0.3, "assumption": "plane stress"}
DRIVE = {"grip": 0.08, "D_i": 100.06, "e": 9.0, "tan_phi": 0.05}


def driven(z=6, *, d_e=80.0, d_i=72.0, rho=2.0, E_roller=np.inf, **change):
    roller = Roller(d=10.0, j_D=0.06, E=E_roller, nu=0.3 if np.isfinite(E_roller) else 0.0)
    ring = Sector(z=z, d_e=d_e, d_i=d_i, rho=rho)
    return Driven(RollerContact(ring, roller, 210e3, 0.3, "plane stress"), **DRIVE | change)


@pytest.mark.parametrize(("z", "E_roller"), [(6, np.inf), (24, 210e3)])
def test_the_pressure_of_the_force_of_a_pressure_is_that_pressure(z, E_roller):
    hub = driven(z, e=4.0 if z == 24 else 9.0, E_roller=E_roller, grip=0.04)
    for p in (35.0, 60.0):
        assert hub.pressure(hub.force(p)) == pytest.approx(p, rel=1e-10)
        assert hub.required_pressure(hub.force(p)) == pytest.approx(p, rel=1e-10)


def test_up_to_the_largest_pressure_that_a_ring_holds_its_force_is_found():
    """The force rises to where the pressure does not any more: there it locks."""
    hub = driven(grip=0.36)
    N = brentq(lambda N: 1.0 if hub.rises(N) else -1.0, 10.0, 1e5)
    most = hub.pressure(N)
    assert hub.force(most * (1 - 1e-7)) == pytest.approx(N, rel=0.01)
    assert hub.force(most * (1 + 1e-7)) == np.inf
    assert hub.required_pressure(1.5 * N) == pytest.approx(most, rel=1e-9)
    assert hub.required_pressure(0.5 * N) == hub.pressure(0.5 * N) < most


RING = {"d_e": 80.0, "d_i": 72.0, "rho": 2.0}
ROLLER = Roller(d=10.0, j_D=0.06)


@pytest.mark.parametrize("roller", [ROLLER, Roller(d=10.0, j_D=0.06, E=70e3, nu=0.33)])
def test_growth_indentation_and_compression_close_the_gap(roller):
    ring = Sector(z=6, **RING)
    state = locked(sector=ring, roller=roller, p=30.0, **STEEL)
    grown = float(rim_displacement(0.0, sector=ring, p=30.0, **STEEL).real[0])
    dent = float(roller_load(sector=ring, a=state.a).rim_displacement(0.0, **STEEL)[0])
    E_star = 210e3 if np.isinf(roller.E) else 1 / (1 / 210e3 + 1 / roller.E)
    R = 1 / (2 / 10.0 + 2 / 80.0)
    assert state.a == pytest.approx(np.sqrt(4 * state.N * R / (np.pi * E_star)), rel=1e-12)
    squeeze = 0.0
    if np.isfinite(roller.E):
        outer = np.sqrt(4 * state.N / (1 / 5.0 - 1 / 50.03) / (np.pi * roller.E))
        ends = approach_to_centre(P=state.N, a=[state.a, outer], R=5.0, E_plane=roller.E)
        squeeze = float(ends.sum())
        assert state.a_race == pytest.approx(outer, rel=1e-12)
    assert (state.a_race > 0) == np.isfinite(roller.E)
    assert grown + state.N * dent - squeeze == pytest.approx(0.03, rel=1e-9)


def test_growth_and_indentation_close_the_gap_just_above_the_touching_pressure():
    """The force is below the start value of Newton's method."""
    ring = Sector(z=6, **RING)
    touch = locked(sector=ring, roller=ROLLER, p=30.0, **STEEL).touch
    state = locked(sector=ring, roller=ROLLER, p=1.0002 * touch, **STEEL)
    grown = float(rim_displacement(0.0, sector=ring, p=1.0002 * touch, **STEEL).real[0])
    dent = float(roller_load(sector=ring, a=state.a).rim_displacement(0.0, **STEEL)[0])
    assert -state.N * dent == pytest.approx(grown - 0.03, rel=1e-8)


@pytest.mark.parametrize("z", [3, 6, 24])
def test_the_efficiency_is_the_slope_of_the_force_over_the_sides_share(z):
    ring = Sector(z=z, **RING)
    forces = [locked(sector=ring, roller=ROLLER, p=p, **STEEL).N for p in (29.9, 30.1)]
    slope = (forces[1] - forces[0]) / 0.2
    state = locked(sector=ring, roller=ROLLER, p=30.0, **STEEL)
    assert state.efficiency == pytest.approx(slope / (72 * np.sin(np.pi / z)), rel=2e-4)
    assert 0 < state.efficiency < 1


def test_sensitivities_are_the_slopes_under_another_closure(monkeypatch):
    hub = driven()
    N, p = hub.force(30.0), 30.0
    by_force, by_pressure = hub.force_sensitivity(N), hub.pressure_sensitivity(N)
    right = RollerContact.closure
    monkeypatch.setattr(RollerContact, "closure", lambda self, n: 1.0001 * right(self, n))
    assert 1 - hub.force(30.0) / N == pytest.approx(1e-4 * by_force, rel=2e-3)
    assert hub.pressure(N) / p - 1 == pytest.approx(1e-4 * by_pressure, rel=1e-6)


def test_the_driven_ring_is_the_locked_ring_under_the_equivalent_hub():
    hub = driven()
    N = hub.force(30.0)
    normal = hub.kappa * N / np.hypot(1, 0.05)
    push = hub_force(sector=hub.contact.sector, e=9.0, normal=normal, along=-0.05 * normal)
    state = locked(sector=hub.contact.sector, roller=hub.contact.roller, p=30.0, hub=push, **STEEL)
    assert pytest.approx(N, rel=1e-9) == state.N

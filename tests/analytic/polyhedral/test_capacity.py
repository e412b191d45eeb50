"""The driven ring: its balance by vectors, pressure and force as inverses, and where it locks."""

import numpy as np
import pytest
from scipy.optimize import brentq

from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.hub_force import hub_force
from analytic.polyhedral.locking import Roller, RollerContact, locked
from analytic.polyhedral.sector import Sector

STEEL = {"E": 210e3, "nu": 0.3, "assumption": "plane stress"}
DRIVE = {"grip": 0.08, "D_i": 100.06, "e": 9.0, "tan_phi": 0.05}


def driven(z=6, *, d_e=80.0, d_i=72.0, rho=2.0, E_roller=np.inf, **change):
    roller = Roller(d=10.0, j_D=0.06, E=E_roller, nu=0.3 if np.isfinite(E_roller) else 0.0)
    ring = Sector(z=z, d_e=d_e, d_i=d_i, rho=rho)
    return Driven(RollerContact(ring, roller, 210e3, 0.3, "plane stress"), **DRIVE | change)


@pytest.mark.parametrize("tan_phi", [0.0, 0.05, 0.5])
@pytest.mark.parametrize("e", [2.0, 9.0, 15.0])
def test_hub_and_rollers_are_in_balance_about_the_axis(e, tan_phi):
    hub = driven(e=e, tan_phi=tan_phi)
    at = np.array([hub.contact.sector.apothem, e])
    force = np.array([1, -tan_phi]) / np.hypot(1, tan_phi)  # leans towards the flat's middle
    moment = abs(at[0] * force[1] - at[1] * force[0])
    assert hub.kappa * moment == pytest.approx(0.08 * 100.06 / 2, rel=1e-12)


@pytest.mark.parametrize("z", [3, 6, 24])
@pytest.mark.parametrize("E_roller", [np.inf, 210e3])
def test_the_pressure_of_the_force_of_a_pressure_is_that_pressure(z, E_roller):
    hub = driven(z, e=4.0 if z == 24 else 9.0, E_roller=E_roller, grip=0.04)
    for p in (35.0, 60.0):
        assert hub.pressure(hub.force(p)) == pytest.approx(p, rel=1e-10)
        assert hub.required_pressure(hub.force(p)) == pytest.approx(p, rel=1e-10)


def test_the_driven_ring_is_the_locked_ring_under_the_hub_that_goes_with_it():
    hub = driven()
    N = hub.force(30.0)
    normal = hub.kappa * N / np.hypot(1, 0.05)
    push = hub_force(sector=hub.contact.sector, e=9.0, normal=normal, along=-0.05 * normal)
    state = locked(sector=hub.contact.sector, roller=hub.contact.roller, p=30.0, hub=push, **STEEL)
    assert pytest.approx(N, rel=1e-9) == state.N


def test_without_grip_it_is_the_locked_ring_alone():
    hub = driven(grip=1e-12)
    alone = locked(sector=hub.contact.sector, roller=hub.contact.roller, p=30.0, **STEEL)
    assert hub.force(30.0) == pytest.approx(alone.N, rel=1e-9)


def test_rollers_are_not_touched_below_the_touching_pressure():
    hub = driven()
    touch = 0.03 / hub.contact.growth
    assert hub.force(touch) == hub.force(0.5 * touch) == 0.0
    assert 0 < hub.force(1.0001 * touch) < 0.01 * hub.force(2 * touch)


def test_elastic_rollers_carry_less_and_stiff_ones_as_much_as_rigid_ones():
    soft, steel, stiff, rigid = (
        driven(E_roller=E).force(30.0) for E in (70e3, 210e3, 210e12, np.inf)
    )
    assert soft < steel < stiff == pytest.approx(rigid, rel=1e-6)


def test_many_rollers_take_what_a_rigid_housing_does():
    """With the ring's limit of the locked ring, 2 d_i d_e/((1 - nu) d_e² + (1 + nu) d_i²)."""
    limit = 2 * 72 * 80 / (0.7 * 80**2 + 1.3 * 72**2)
    lacking = []
    for z in (100, 200, 400):
        hub = driven(z, grip=1e-12, e=0.2)
        slope = (hub.force(30.5) - hub.force(29.5)) / 1.0
        lacking.append(1 - slope / (72 * np.sin(np.pi / z)) / limit)
    assert 0 < lacking[2] < lacking[1] < lacking[0] < 0.05
    assert lacking[1] / lacking[2] == pytest.approx(2, rel=0.2)  # the dents' part falls as 1/z


def test_sensitivities_are_the_slopes_under_another_closure(monkeypatch):
    hub = driven()
    N, p = hub.force(30.0), 30.0
    by_force, by_pressure = hub.force_sensitivity(N), hub.pressure_sensitivity(N)
    right = RollerContact.closure
    monkeypatch.setattr(RollerContact, "closure", lambda self, n: 1.0001 * right(self, n))
    assert 1 - hub.force(30.0) / N == pytest.approx(1e-4 * by_force, rel=2e-3)
    assert hub.pressure(N) / p - 1 == pytest.approx(1e-4 * by_pressure, rel=1e-6)


def test_a_hub_that_lifts_faster_than_the_ring_gives_way_leaves_no_limit():
    hub = driven(grip=0.6)
    assert hub.force(30.0) == np.inf
    assert not hub.rises(1000.0)
    assert hub.required_pressure(1000.0) > hub.pressure(1000.0)
    assert hub.force(10.0) == 0.0  # not touched


def test_up_to_the_largest_pressure_that_a_ring_holds_its_force_is_found():
    """The force rises to where the pressure does not any more: there it locks."""
    hub = driven(grip=0.36)
    N = brentq(lambda N: 1.0 if hub.rises(N) else -1.0, 10.0, 1e5)
    most = hub.pressure(N)
    assert hub.force(most * (1 - 1e-7)) == pytest.approx(N, rel=0.01)
    assert hub.force(most * (1 + 1e-7)) == np.inf
    assert hub.required_pressure(1.5 * N) == pytest.approx(most, rel=1e-9)
    assert hub.required_pressure(0.5 * N) == hub.pressure(0.5 * N) < most


@pytest.mark.parametrize("E_roller", [np.inf, 210e3])
def test_it_does_not_notice_units(E_roller):
    mm = driven(E_roller=E_roller)
    ring = Sector(z=6, d_e=0.08, d_i=0.072, rho=0.002)
    roller = Roller(d=0.01, j_D=6e-5, E=E_roller * 1e6, nu=mm.contact.roller.nu)
    contact = RollerContact(ring, roller, 210e9, 0.3, "plane stress")
    si = Driven(contact, grip=0.08, D_i=0.10006, e=0.009, tan_phi=0.05)
    assert si.kappa == pytest.approx(mm.kappa, rel=1e-12)
    assert si.force(30e6) == pytest.approx(mm.force(30.0) * 1e3, rel=1e-7)
    assert si.pressure(2e5) == pytest.approx(mm.pressure(200.0) * 1e6, rel=1e-7)
    assert si.force_sensitivity(2e5) == pytest.approx(mm.force_sensitivity(200.0), rel=1e-6)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"grip": 0.0}, "the grip of the rollers must be positive"),
        ({"D_i": -1.0}, "the race's diameter D_i must be positive"),
        ({"tan_phi": -0.1}, "the hub's friction must be finite and not negative"),
    ],
)
def test_a_drive_that_cannot_be_is_refused(change, message):
    with pytest.raises(ValueError, match=message):
        driven(**change)


def test_wrong_forces_and_pressures_are_named():
    with pytest.raises(ValueError, match="the roller's force N must be positive"):
        driven().pressure(0.0)
    with pytest.raises(ValueError, match="the pressure p must be positive"):
        driven().force(-1.0)
    with pytest.raises(ValueError, match="presses a roller of d=10 m flat"):
        driven(E_roller=210e3).pressure(1e6)

"""Point forces of the hub: free walls, reciprocity with pressure and rollers, a force's limits."""

import numpy as np
import pytest

from analytic.polyhedral.bore_pressure import pressed
from analytic.polyhedral.hub_force import hub_force
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.sector import Sector

RING = {"d_e": 80.0, "d_i": 72.0, "rho": 2.0}
PLACES = [(3, 9.0), (6, 9.0), (6, 17.3), (12, 8.0), (24, 2.0)]  # 17.3 mm: on the fillet


def bore_move(field, zeta, nu=0.3):
    """Displacement u + iv at zeta for E = 1."""
    phi, dphi, psi = field(zeta)
    return (1 + nu) * ((3 - nu) / (1 + nu) * phi - zeta * dphi.conj() - psi.conj())


def work(ring, e, normal, along, field):
    """Of the hub's forces on one flat, half at +e and half at -e, on the ring under `field`."""
    s = np.array([e])
    push = ring.normal(s) * (normal + 1j * along)
    return float((bore_move(field, ring.bore(s)) * push.conj()).real[0])


@pytest.mark.parametrize(("normal", "along"), [(1.0, 0.0), (0.0, 1.0), (1.0, -0.4)])
@pytest.mark.parametrize(("z", "e"), PLACES)
def test_hub_and_rollers_do_the_same_work_on_each_other(z, e, normal, along):
    ring = Sector(z=z, **RING)
    a = 0.3
    turn = np.arange(1, 41) * np.pi / 41
    share = np.sin(turn) ** 2 * 2 / 41
    hub = hub_force(sector=ring, e=e, normal=normal, along=along)
    rollers = -float(share @ hub.rim_displacement(a * np.cos(turn) / 40).real)
    theirs = work(ring, e, normal, along, roller_load(sector=ring, a=a))
    assert theirs == pytest.approx(rollers, rel=1e-7)


@pytest.mark.parametrize(("z", "e"), PLACES)
def test_the_bore_is_free_but_for_the_forces_and_the_rim_is_free(z, e):
    ring = Sector(z=z, **RING)
    hub = hub_force(sector=ring, e=e, normal=2.0, along=0.7)
    s = np.concatenate([np.linspace(0, e - 0.01, 200), np.linspace(e + 0.01, ring.half_bore, 200)])
    zeta = ring.bore(s)
    force = hub(zeta).force(zeta)
    before, after = force[:200], force[200:]
    assert np.ptp(before.real) + np.ptp(before.imag) < 1e-7
    assert np.ptp(after.real) + np.ptp(after.imag) < 1e-7
    push = complex(ring.normal(np.array([e]))[0]) * (2.0 + 0.7j) / 2
    assert after[0] - before[0] == pytest.approx(-1j * push, abs=1e-7)
    rim = 40 * np.exp(1j * np.linspace(0, np.pi / z, 50))
    assert np.abs(hub(rim).force(rim)).max() < 1e-12


def test_a_force_spread_evenly_over_the_bore_is_a_pressure():
    ring = Sector(z=6, **RING)
    nodes, w = np.polynomial.legendre.leggauss(24)
    total = np.zeros(3)
    theta = np.array([0.0, 0.2, np.pi / 6])
    for low, high in ((0, ring.straight), (ring.straight, ring.half_bore)):
        for x, share in zip(nodes, w * (high - low) / 2, strict=True):
            e = (low + high) / 2 + (high - low) / 2 * x
            hub = hub_force(sector=ring, e=e, normal=2 * share)
            total += hub.rim_displacement(theta).real
    np.testing.assert_allclose(total, pressed(ring).rim_displacement(theta).real, rtol=1e-6)


def test_in_the_corner_itself_only_the_radial_part_is_left():
    ring = Sector(z=6, **RING)
    theta = [0.0, np.pi / 6]
    corner = hub_force(sector=ring, e=ring.half_bore, normal=1.0)
    beside = hub_force(sector=ring, e=ring.half_bore - 1e-3, normal=1.0)
    both = hub_force(sector=ring, e=ring.half_bore, normal=1.0, along=5.0)
    u = corner.rim_displacement(theta).real
    np.testing.assert_allclose(beside.rim_displacement(theta).real, u, rtol=1e-4)
    np.testing.assert_allclose(both.rim_displacement(theta).real, u, rtol=1e-9)
    assert both.resultant == pytest.approx(np.sqrt(26))


@pytest.mark.parametrize("e", [-1.0, 0.0, 18.1, np.nan])
def test_forces_off_the_flat_are_refused(e):
    with pytest.raises(ValueError, match=r"lever e must be|pushes between mid-flat and corner"):
        hub_force(sector=Sector(z=6, **RING), e=e, normal=1.0)

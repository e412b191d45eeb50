"""Forces of the hub, stresses and slopes of the walls, loads in the sections."""

import numpy as np
import pytest

from analytic.polyhedral.bore_pressure import pressed
from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.cut_loads import cut_loads
from analytic.polyhedral.fillet_stress import driven_fillet_stress, loaded_fillet_stress
from analytic.polyhedral.hub_force import hub_force
from analytic.polyhedral.locking import Roller, RollerContact
from analytic.polyhedral.rim_slope import rim_slope, steepest
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.sector import Sector
from analytic.polyhedral.wall_stress import bore_stress, rim_stress

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


HEXAGON = Sector(z=6, **RING)


def pushed(ring):
    return hub_force(sector=ring, e=9.0, normal=1.0)


@pytest.mark.parametrize("load", [pressed, pushed])
def test_the_rims_stress_and_slope_are_the_differences_of_its_displacement(load):
    field = load(HEXAGON)
    theta, h = np.linspace(0.05, 0.5, 7), 1e-5
    u = field.rim_displacement(theta)
    d_u = (field.rim_displacement(theta + h) - field.rim_displacement(theta - h)) / (2 * h)
    stretch = (u.real + d_u.imag) / 40  # times E'
    stress = rim_stress(theta, sector=HEXAGON, field=field)
    np.testing.assert_allclose(stress, stretch, rtol=1e-7)
    slope = rim_slope(theta, sector=HEXAGON, field=field)
    np.testing.assert_allclose(slope, d_u.real / 40, rtol=1e-6)


@pytest.mark.parametrize("nu", [0.0, 0.3])
def test_the_bores_stress_is_the_stretch_of_its_points(nu):
    s, h = np.array([3.0, 16.0, 17.5, 17.9]), 1e-5

    def move(at):
        return bore_move(pressed(HEXAGON), HEXAGON.bore(at), nu)

    tangent = 1j * HEXAGON.normal(s)
    stretch = ((move(s + h) - move(s - h)) / (2 * h) * tangent.conj()).real
    stress = bore_stress(s, sector=HEXAGON, field=pressed(HEXAGON), p=1.0)
    np.testing.assert_allclose(stretch, stress + nu, rtol=1e-5)  # sigma_t - nu (-p)


@pytest.mark.parametrize("z", [3, 6, 12, 48])
def test_the_cuts_balance_the_pressure(z):
    ring = Sector(z=z, **RING)
    mid, corner = cut_loads(sector=ring, field=pressed(ring))
    assert mid.force == pytest.approx(ring.apothem, rel=1e-8)
    assert corner.force == pytest.approx(36.0, rel=1e-8)
    turned = (36.0**2 - ring.apothem**2) / 2  # of the pressure, about the centre
    assert corner.moment - mid.moment == pytest.approx(turned, abs=1e-7 * mid.moment)


CONTACT = RollerContact(HEXAGON, Roller(d=10.0, j_D=0.06), 210e3, 0.3, "plane stress")


@pytest.mark.parametrize("tan_phi", [0.0, 0.05, 0.6])
def test_the_hub_force_balances_the_torque_of_the_rollers(tan_phi):
    N, p = 150.0, 30.0
    hub = Driven(CONTACT, grip=0.08, D_i=100.06, e=9.0, tan_phi=tan_phi)
    phi, at = np.arctan(tan_phi), np.array([HEXAGON.apothem, 9.0])
    leaning = np.array([np.cos(phi), -np.sin(phi)])  # off the flat's normal, to its middle
    R = 0.08 * N * 100.06 / 2 / (at[1] * leaning[0] - at[0] * leaning[1])
    normal, along = R * leaning
    push = hub_force(sector=HEXAGON, e=9.0, normal=normal, along=along)
    expected = loaded_fillet_stress(HEXAGON, p=p, hub=push, N=N, a=CONTACT.half_width(N))
    assert driven_fillet_stress(hub, N, p) == pytest.approx(expected, rel=1e-12)
    assert driven_fillet_stress(hub, 0.0, p) == loaded_fillet_stress(HEXAGON, p=p)


def test_the_steepest_place_is_steeper_than_any_other():
    slope, theta = steepest(sector=HEXAGON, field=pressed(HEXAGON))
    everywhere = rim_slope(np.linspace(0, np.pi / 6, 5001), sector=HEXAGON, field=pressed(HEXAGON))
    assert slope == pytest.approx(np.abs(everywhere).max(), rel=1e-6)
    assert 0 < theta < np.pi / 6

"""Stress and slope on the walls, loads in the cuts: against strains, statics and Lamé."""

import numpy as np
import pytest

from analytic.polyhedral.bore_pressure import pressed
from analytic.polyhedral.cut_loads import cut_loads
from analytic.polyhedral.hub_force import hub_force
from analytic.polyhedral.rim_slope import rim_slope, steepest
from analytic.polyhedral.roller_load import roller_load
from analytic.polyhedral.sector import Sector
from analytic.polyhedral.wall_stress import (
    bore_stress,
    corner_stress_factor,
    largest_fillet_stress,
    rim_stress,
)
from analytic.ring import lame

HEXAGON = Sector(z=6, d_e=80.0, d_i=72.0, rho=2.0)


def pushed(ring):
    return hub_force(sector=ring, e=9.0, normal=1.0)


@pytest.mark.parametrize("load", [pressed, pushed])
def test_the_rims_stress_is_its_stretch(load):
    field = load(HEXAGON)
    theta, h = np.linspace(0.05, 0.5, 7), 1e-5
    u = field.rim_displacement(theta)
    d_u = (field.rim_displacement(theta + h) - field.rim_displacement(theta - h)) / (2 * h)
    stretch = (u.real + d_u.imag) / 40  # times E'
    stress = rim_stress(theta, sector=HEXAGON, field=field)
    np.testing.assert_allclose(stress, stretch, rtol=1e-7)


@pytest.mark.parametrize("load", [pressed, pushed])
def test_the_slope_is_the_difference_quotient_of_the_radial_displacement(load):
    field = load(HEXAGON)
    theta, h = np.linspace(0.05, 0.5, 7), 1e-5
    u = [field.rim_displacement(theta + step).real for step in (h, -h)]
    slope = rim_slope(theta, sector=HEXAGON, field=field)
    np.testing.assert_allclose(slope, (u[0] - u[1]) / (2 * h) / 40, rtol=1e-6)


def test_the_steepest_place_is_steeper_than_any_other():
    slope, theta = steepest(sector=HEXAGON, field=pressed(HEXAGON))
    everywhere = rim_slope(np.linspace(0, np.pi / 6, 5001), sector=HEXAGON, field=pressed(HEXAGON))
    assert slope == pytest.approx(np.abs(everywhere).max(), rel=1e-6)
    assert 0 < theta < np.pi / 6


@pytest.mark.parametrize("nu", [0.0, 0.3])
def test_the_bores_stress_is_the_stretch_of_its_points(nu):
    s, h = np.array([3.0, 16.0, 17.5, 17.9]), 1e-5

    def move(at):
        zeta = HEXAGON.bore(at)
        phi, dphi, psi = pressed(HEXAGON)(zeta)
        return (1 + nu) * ((3 - nu) / (1 + nu) * phi - zeta * dphi.conj() - psi.conj())

    tangent = 1j * HEXAGON.normal(s)
    stretch = ((move(s + h) - move(s - h)) / (2 * h) * tangent.conj()).real
    stress = bore_stress(s, sector=HEXAGON, field=pressed(HEXAGON), p=1.0)
    np.testing.assert_allclose(stretch, stress + nu, rtol=1e-5)  # sigma_t - nu (-p)


def test_a_round_bore_has_lames_stress():
    ring = Sector(z=6, d_e=80.0, d_i=60.0, rho=30 * (1 - 1e-10))
    stress, _ = largest_fillet_stress(sector=ring)
    _, exact = lame.stresses(30.0, r_i=30.0, r_o=40.0, p_i=1.0)
    assert stress == pytest.approx(float(exact), rel=1e-8)
    factor = corner_stress_factor(sector=ring, nu=0.3, assumption="plane stress")
    growth = lame.radial_displacement(
        40.0, r_i=30.0, r_o=40.0, p_i=1.0, E=1.0, nu=0.3, ends="plane stress")  # fmt: skip
    p = 0.5 / float(growth)  # j_D = 1, d_m = 70, E = 1
    assert factor == pytest.approx(float(exact) * p * 70, rel=1e-8)


def test_the_corner_s_factor_is_told_where_the_middle_of_the_flat_reaches_the_rollers():
    """Of E = 1 and j_D = 1: there, where it bulges most, the rim has grown by 1/2."""
    stress, _ = largest_fillet_stress(sector=HEXAGON)
    p = 0.5 / float(pressed(HEXAGON).rim_displacement([0.0]).real[0])
    factor = corner_stress_factor(sector=HEXAGON, nu=0.3, assumption="plane stress")
    assert factor == pytest.approx(stress * p * 76.0, rel=1e-12)  # over j_D/d_m


@pytest.mark.parametrize("z", [3, 6, 12, 48])
def test_the_cuts_balance_the_pressure(z):
    ring = Sector(z=z, d_e=80.0, d_i=72.0, rho=2.0)
    mid, corner = cut_loads(sector=ring, field=pressed(ring))
    assert mid.force == pytest.approx(ring.apothem, rel=1e-8)
    assert corner.force == pytest.approx(36.0, rel=1e-8)
    turned = (36.0**2 - ring.apothem**2) / 2  # of the pressure, about the centre
    assert corner.moment - mid.moment == pytest.approx(turned, abs=1e-7 * mid.moment)


@pytest.mark.parametrize(("normal", "along"), [(1.0, 0.0), (0.0, 1.0)])
def test_the_cuts_balance_the_hub(normal, along):
    hub = hub_force(sector=HEXAGON, e=9.0, normal=normal, along=along)
    mid, corner = cut_loads(sector=HEXAGON, field=hub)
    across, up = normal / 2, along / 2  # along x and y, on the half sector
    assert corner.force * np.sin(np.pi / 6) == pytest.approx(across, abs=1e-8)
    assert corner.force * np.cos(np.pi / 6) - mid.force == pytest.approx(-up, abs=1e-8)
    turned = HEXAGON.apothem * up - 9.0 * across
    assert corner.moment - mid.moment == pytest.approx(-turned, abs=1e-6)


def test_the_bending_moment_of_a_uniform_tension_vanishes_in_the_middle_of_the_cut():
    round_ring = Sector(z=6, d_e=80.0, d_i=79.2, rho=39.6 * (1 - 1e-10))
    mid, _ = cut_loads(sector=round_ring, field=pressed(round_ring))
    assert abs(mid.bending(39.8)) < 2e-3 * mid.force * 0.4


def test_stresses_of_rollers_and_pressure_add_up():
    rollers = roller_load(sector=HEXAGON, a=0.1)
    stress = bore_stress([0.0, HEXAGON.half_bore], sector=HEXAGON, field=rollers)
    assert stress[0] > 0 > stress[1]  # a ring pressed from outside above its flat
    with pytest.raises(ValueError, match="arc lengths reach from 0 to"):
        bore_stress(19.0, sector=HEXAGON, field=rollers)


def test_stresses_under_the_loads_themselves_are_refused():
    with pytest.raises(ValueError, match=r"points may reach to 0\.999 of the loaded outside"):
        roller_load(sector=HEXAGON, a=0.1)(np.array([40.0 + 0j]))
    with pytest.raises(ValueError, match="infinite at the hub's point force itself"):
        bore_stress(9.0, sector=HEXAGON, field=hub_force(sector=HEXAGON, e=9.0, normal=1.0))

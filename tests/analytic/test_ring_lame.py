"""Lamé's ring and the rotating ring: hand values, balance, Hooke's law, energy."""

import numpy as np
import pytest

from analytic.ring import lame, rotating

WALL = {"r_i": 1.0, "r_o": 2.0}


@pytest.mark.parametrize("ends", ["plane stress", "plane strain", "closed ends"])
def test_displacement_obeys_hooke_s_law(ends):
    """u/r is the hoop strain of the stresses, du/dr the radial one (central difference)."""
    E, nu, load = 3.0, 0.3, {**WALL, "p_i": 2.0, "p_o": 0.7}
    r, step = np.array([1.2, 1.5, 1.8]), 1e-5
    radial, hoop = lame.stresses(r, **load)
    axial = lame.axial_stress(nu=nu, ends=ends, **load)

    def u(r):
        return lame.radial_displacement(r, E=E, nu=nu, ends=ends, **load)

    np.testing.assert_allclose(u(r) / r, (hoop - nu * (radial + axial)) / E, rtol=1e-13)
    slope = (u(r + step) - u(r - step)) / (2 * step)  # error of order step^2 = 1e-10
    np.testing.assert_allclose(slope, (radial - nu * (hoop + axial)) / E, rtol=1e-8)


def test_axial_stress_of_each_end_condition():
    load = {**WALL, "p_i": 3.0, "p_o": 0.0}
    axial = {e: float(lame.axial_stress(nu=0.25, ends=e, **load)) for e in lame.Ends.__args__}
    assert axial["plane stress"] == 0
    # closed ends carry p_i pi r_i^2 on the wall's area: 3 * 1 / (4 - 1)
    assert axial["closed ends"] == pytest.approx(1.0, rel=1e-15)
    # no axial strain: nu (sigma_r + sigma_t) = 2 nu A
    assert axial["plane strain"] == pytest.approx(0.5, rel=1e-15)


@pytest.mark.parametrize("ends", ["plane stress", "plane strain"])
def test_strain_energy_is_half_the_work_of_both_pressures(ends):
    material, load = {"E": 2.0, "nu": 0.3, "ends": ends}, {**WALL, "p_i": 3.0, "p_o": 1.0}
    u_i, u_o = lame.radial_displacement([1.0, 2.0], **load, **material)
    work = 2 * np.pi * (3.0 * 1.0 * u_i - 1.0 * 2.0 * u_o) / 2
    assert lame.strain_energy(**load, **material) == pytest.approx(work, rel=1e-13)


RACE = {"r_i": 19.44e-3, "r_o": 26.23e-3, "rho": 7850.0, "omega": 200 * np.pi, "nu": 0.3}


def test_eq_8_as_printed_is_the_bore_s_growth_in_plane_stress():
    """Huang 2018, Eq. 8, with n = 6000 r/min, in the order of terms of the paper."""
    R_e, R_ed, nu, rho, n, E = 19.44e-3, 26.23e-3, 0.3, 7850.0, 6000.0, 206e9
    printed = (
        R_e / E * (3 + nu) * rho / 4 * (np.pi * n / 30) ** 2
        * (R_ed**2 + R_e**2 * ((1 - nu) / (3 + nu)))
    )  # fmt: skip
    u = rotating.radial_displacement(R_e, E=E, assumption="plane stress", **RACE)
    assert float(u) == pytest.approx(printed, rel=1e-14)


@pytest.mark.parametrize("assumption", ["plane stress", "plane strain"])
def test_stresses_balance_the_body_force_and_obey_hooke(assumption):
    r, step, E, nu = np.array([20e-3, 22e-3, 25e-3]), 1e-7, 206e9, 0.3
    E_plane, nu_plane = (E, nu) if assumption == "plane stress" else (E / 0.91, 0.3 / 0.7)

    def state(r):
        u = rotating.radial_displacement(r, E=E, assumption=assumption, **RACE)
        return (*rotating.stresses(r, assumption=assumption, **RACE), u)

    (radial, hoop, u), up, down = state(r), state(r + step), state(r - step)
    slope, stretch = (up[0] - down[0]) / (2 * step), (up[2] - down[2]) / (2 * step)
    force = RACE["rho"] * RACE["omega"] ** 2 * r
    np.testing.assert_allclose(slope + (radial - hoop) / r, -force, rtol=1e-6)
    np.testing.assert_allclose(u / r, (hoop - nu_plane * radial) / E_plane, rtol=1e-13)
    np.testing.assert_allclose(stretch, (radial - nu_plane * hoop) / E_plane, rtol=1e-6)


@pytest.mark.parametrize("assumption", ["plane stress", "plane strain"])
def test_the_strain_energy_is_that_of_the_stresses(assumption):
    E = 206e9
    E_plane, nu_plane = (E, 0.3) if assumption == "plane stress" else (E / 0.91, 0.3 / 0.7)
    x, w = np.polynomial.legendre.leggauss(30)
    r = 22.835e-3 + 3.395e-3 * x
    radial, hoop = rotating.stresses(r, assumption=assumption, **RACE)
    density = (radial**2 + hoop**2 - 2 * nu_plane * radial * hoop) / (2 * E_plane)
    by_stress = 3.395e-3 * (w @ (density * 2 * np.pi * r))
    energy = rotating.strain_energy(E=E, assumption=assumption, **RACE)
    assert energy == pytest.approx(by_stress, rel=1e-12)

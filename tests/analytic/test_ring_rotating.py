"""The rotating ring against facts that owe nothing to this code."""

import numpy as np
import pytest

from analytic.ring import rotating

RACE = {"r_i": 19.44e-3, "r_o": 26.23e-3, "rho": 7850.0, "omega": 200 * np.pi, "nu": 0.3}


def test_eq_8_as_printed_is_the_bore_s_growth_in_plane_stress():
    """Huang 2018, Eq. 8, with n = 6000 r/min, in the paper's own order of terms."""
    R_e, R_ed, nu, rho, n, E = 19.44e-3, 26.23e-3, 0.3, 7850.0, 6000.0, 206e9
    printed = (
        R_e / E * (3 + nu) * rho / 4 * (np.pi * n / 30) ** 2
        * (R_ed**2 + R_e**2 * ((1 - nu) / (3 + nu)))
    )  # fmt: skip
    u = rotating.radial_displacement(R_e, E=E, assumption="plane stress", **RACE)
    assert float(u) == pytest.approx(printed, rel=1e-14)


def test_both_walls_are_free():
    radial, _ = rotating.stresses([19.44e-3, 26.23e-3], assumption="plane strain", **RACE)
    np.testing.assert_allclose(radial, 0.0, atol=1e-9 * 7850 * (200 * np.pi * 26.23e-3) ** 2)


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


def test_half_a_ring_hangs_on_its_two_cuts():
    """The body force on half a ring, 2 rho omega² (r_o³ - r_i³)/3, is what the cuts carry."""
    x, w = np.polynomial.legendre.leggauss(30)
    r = 22.835e-3 + 3.395e-3 * x
    _, hoop = rotating.stresses(r, assumption="plane stress", **RACE)
    carried = 2 * 3.395e-3 * (w @ hoop)
    body = RACE["rho"] * RACE["omega"] ** 2 * 2 / 3 * (26.23e-3**3 - 19.44e-3**3)
    assert carried == pytest.approx(body, rel=1e-12)


def test_a_thin_ring_bears_rho_v_squared():
    ring = {"r_i": 1.0, "r_o": 1.0001, "rho": 3.0, "omega": 2.0, "nu": 0.3}
    _, hoop = rotating.stresses(1.0, assumption="plane stress", **ring)
    assert float(hoop) == pytest.approx(12.0, rel=2e-4)  # of the order of the wall


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


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"rho": 0.0}, "density must be positive"),
        ({"omega": np.nan}, "angular speed must be positive"),
        ({"r_i": 0.03}, "0 < r_i < r_o"),
        ({"nu": 0.5}, "Poisson's ratio"),
    ],
)
def test_a_ring_without_sense_is_refused(wrong, said):
    with pytest.raises(ValueError, match=said):
        rotating.stresses(0.02, assumption="plane stress", **RACE | wrong)


def test_a_radius_outside_the_wall_is_refused():
    with pytest.raises(ValueError, match="r must lie in the wall"):
        rotating.stresses(0.03, assumption="plane stress", **RACE)

"""Discs beyond Hertz: kernel and rim, series of two discs, stresses, the clamped race, edges."""

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

from analytic.contact import (
    clamped_race,
    disc_series,
    hertz_line,
    pair_series,
)
from analytic.contact.disc import disc_in_contact, disc_under_load
from analytic.contact.edge import edge_exponent
from analytic.ring import lame


def kernel(x, t):
    """Of R = E' = 1, as the module's docstring states it."""
    y, y_t = np.sqrt(1 - x**2), np.sqrt(1 - t**2)
    return 2 / np.pi * (np.log(abs(x - t)) - np.log(y + y_t) + y * y_t)


def rim(solved, x):
    """Height of the rim at x after loading, by quadrature over the solved pressure."""

    def part(t):
        return float(solved.pressure(t)) * kernel(x, t)

    at = [x] if abs(x) < solved.a else None
    moved, _ = quad(part, -solved.a, solved.a, points=at, epsabs=1e-13, limit=200)
    return np.sqrt(1 - x**2) + moved


@pytest.mark.parametrize("a", [0.05, 0.8])
def test_the_rim_lies_on_the_flat_where_it_is_pressed_and_below_it_elsewhere(a):
    solved = disc_in_contact(a=a, R=1.0, E_plane=1.0)
    inside = [rim(solved, x) for x in np.array([0.0, 0.35, 0.7, 0.95]) * a]
    np.testing.assert_allclose(inside, 1 - solved.approach, rtol=1e-10)
    gaps = [1 - solved.approach - rim(solved, x) for x in np.array([1.02, 1.1, 1.2]) * a]
    assert 0 < gaps[0] < gaps[1] < gaps[2]
    assert np.all(solved.pressure(np.linspace(-a, a, 101)[1:-1]) > 0)


@pytest.mark.parametrize("quantity", ["pressure", "width", "moment width", "approach"])
def test_the_first_correction_leaves_an_error_of_fourth_order(quantity):
    def left(a):
        solved = disc_in_contact(a=a, R=1.0, E_plane=1.0)
        load = {"P": solved.P, "R": 1.0, "E_star": 1.0}
        series = disc_series.approach(P=solved.P, a=a, R=1.0, E_plane=1.0)
        return {
            "pressure": solved.p_0 / hertz_line.peak_pressure(**load) - 1
            - disc_series.pressure_excess(a=a, R=1.0),
            "width": a / hertz_line.half_width(**load) - 1 - disc_series.width_excess(a=a, R=1.0),
            "moment width": solved.moment_width / hertz_line.half_width(**load) - 1
            - disc_series.moment_width_excess(a=a, R=1.0),
            "approach": (solved.approach - series) / solved.P,
        }[quantity]  # fmt: skip

    assert float(np.log2(left(0.2) / left(0.1))) == pytest.approx(4.0, abs=0.1)


@pytest.mark.parametrize("ratio", [1.1, 5.0])
def test_the_race_under_uniform_pressure_is_lame_s(ratio):
    """The rim's pressure that keeps it in place, from Lamé's displacements."""
    load = {"r_i": 1.0, "r_o": ratio, "E": 2.0, "nu": 0.3, "ends": "plane strain"}
    inner = lame.radial_displacement([1.0, ratio], p_i=1.0, p_o=0.0, **load)
    outer = lame.radial_displacement([1.0, ratio], p_i=0.0, p_o=1.0, **load)
    held = inner[0] - inner[1] / outer[1] * outer[0]
    E_plane, nu_plane = 2.0 / 0.91, 0.3 / 0.7
    assert clamped_race._uniform(ratio, nu_plane) == pytest.approx(E_plane * held / 2, rel=1e-12)


def bore_under_a_wave(n: int, ratio: float, nu: float) -> float:
    """E U_n/2 at r = 1 under sigma_r = -cos(n theta), rim clamped: Runge-Kutta through the wall.

    The state is U, V, sigma_r, tau of u = U cos(n theta), v = V sin(n theta); E = 1, plane stress.
    """

    def slope(r, state):
        U, V, S, T = state
        hoop = nu * S + (U + n * V) / r
        dU = (1 - nu**2) * S - nu * (U + n * V) / r
        dV = 2 * (1 + nu) * T + (n * U + V) / r
        return [dU, dV, -(n * T + S - hoop) / r, (n * hoop - 2 * T) / r]

    def rim(start):
        return solve_ivp(slope, (1.0, ratio), start, rtol=1e-11, atol=1e-12).y[:2, -1]

    free = rim([0.0, 0.0, -1.0, 0.0])
    moved = (
        np.column_stack([rim([1.0, 0.0, -1.0, 0.0]), rim([0.0, 1.0, -1.0, 0.0])]) - free[:, None]
    )
    return float(np.linalg.solve(moved, -free)[0]) / 2


@pytest.mark.parametrize(("ratio", "nu"), [(1.2, 0.3), (2.5, 0.0)])
def test_every_harmonic_of_the_clamped_race_is_what_its_differential_equations_give(ratio, nu):
    assert clamped_race._first(ratio, nu) == pytest.approx(
        bore_under_a_wave(1, ratio, nu), rel=1e-8
    )
    n = np.array([2.0, 5.0])
    expected = [bore_under_a_wave(int(k), ratio, nu) for k in n]
    assert clamped_race._higher(n, ratio, nu) == pytest.approx(expected, rel=1e-7)


# Discs by Fourier modes in plane stress, both directions coupled: R_1, R_2, E_1, nu_1, E_2, nu_2;
# Hertz's half-width, excess of the peak pressure, excess of the moments' half-width. Four digits.
SOLVED = [
    ((1, 2.76, 1, 0.3, 1, 0.3), 0.2022, 4.145e-3, -5.381e-3),
    ((1, 2.76, 1, 0.3, 2.5, 0.3), 0.1003, 1.537e-3, -2.003e-3),
    ((2, 1, 1, 0.1, 4, 0.4), 0.0993, -6.64e-3, 5.73e-3),
    ((1, 3, 20, 0, 1, 0), 0.0992, -1.505e-2, 1.370e-2),
]
PRINTED = 1e-5  # of the excess, and of a_H: half a digit of 2000


def given(discs, a):
    names = ("R_1", "R_2", "E_1", "nu_1", "E_2", "nu_2")
    return dict(zip(names, discs, strict=True)) | {"a": a, "assumption": "plane stress"}


def test_the_series_of_two_discs_meets_an_independent_solver():
    for discs, a, *solved in SOLVED:
        series = pair_series.excess(**given(discs, a))
        allowed = pair_series.left_out(**given(discs, a)) + PRINTED
        for one, other in zip(series, solved, strict=True):
            assert abs(one.total - other) < allowed


@pytest.mark.parametrize("angle", [np.pi / 2, 2.2, 3.0])
def test_wedge_and_half_plane_open_equally(angle):
    # the loaded face of a wedge deflects by (sin 2pa + p sin 2a)/(sin² pa - p² sin² a), which is
    # 2 cot(p pi) for the half-plane
    def sum_of_both(p):
        wedge = (np.sin(2 * p * angle) + p * np.sin(2 * angle)) / (
            np.sin(p * angle) ** 2 - (p * np.sin(angle)) ** 2
        )
        return wedge + 2 / np.tan(p * np.pi)

    exact = brentq(sum_of_both, 0.5 + 1e-12, 0.95)
    assert edge_exponent(angle) == pytest.approx(exact - 1, abs=1e-10)


@pytest.mark.parametrize("P", [1e-12, 1e-3, 0.1])
def test_load_and_half_width_give_the_same_disc(P):
    loaded = disc_under_load(P=P, R=2.0, E_plane=3.0)
    np.testing.assert_allclose(loaded.P, P, rtol=1e-11)
    assert disc_in_contact(a=loaded.a, R=2.0, E_plane=3.0).p_0 == loaded.p_0

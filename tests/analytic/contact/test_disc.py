"""The disc between flats: its kernel against uniform compression, its solution against the rim."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import disc, disc_series, hertz_line, hertz_line_approach

WIDTHS = np.array([0.05, 0.1, 0.2])  # a/R


def kernel(x, t):
    """Of R = E' = 1, as the module's docstring states it."""
    y, y_t = np.sqrt(1 - x**2), np.sqrt(1 - t**2)
    return 2 / np.pi * (np.log(abs(x - t)) - np.log(y + y_t) + y * y_t)


@pytest.mark.parametrize("x", [0.0, 0.3, 0.8])
@pytest.mark.parametrize(
    ("load", "sinking"),
    [
        pytest.param(lambda _: 1.0, lambda y: -y, id="uniform stress -1"),
        # phi = z³, psi = z³ - 3z: phi + z phi'* + psi* = 2 cos 3t on |z| = 1, so no force along x,
        # q = -6 sin 3t / sin t, and 2G v = (kappa + 1) Im phi, (kappa + 1)/2G = 4/E'
        pytest.param(lambda x: 6 - 24 * x**2, lambda y: 4 * (3 * y - 4 * y**3), id="cubic phi"),
    ],
)
def test_the_kernel_moves_the_rim_as_plane_elasticity_does_under_loads_all_over_it(
    load, sinking, x
):
    v, _ = quad(lambda t: load(t) * kernel(x, t), -1, 1, points=[x], epsabs=1e-12, limit=200)
    assert v == pytest.approx(sinking(np.sqrt(1 - x**2)), rel=1e-9)


def rim(solved, x):
    """Height of the rim at x after loading, by quadrature over the solved pressure."""

    def part(t):
        return float(solved.pressure(t)) * kernel(x, t)

    at = [x] if abs(x) < solved.a else None
    moved, _ = quad(part, -solved.a, solved.a, points=at, epsabs=1e-13, limit=200)
    return np.sqrt(1 - x**2) + moved


@pytest.mark.parametrize("a", [0.05, 0.3, 0.8])
def test_the_rim_lies_on_the_flat_where_it_is_pressed_and_below_it_elsewhere(a):
    solved = disc.disc_in_contact(a=a, R=1.0, E_plane=1.0)
    inside = [rim(solved, x) for x in np.array([0.0, 0.35, 0.7, 0.95]) * a]
    np.testing.assert_allclose(inside, 1 - solved.approach, rtol=1e-10)
    gaps = [1 - solved.approach - rim(solved, x) for x in np.array([1.02, 1.1, 1.2]) * a]
    assert 0 < gaps[0] < gaps[1] < gaps[2]
    assert np.all(solved.pressure(np.linspace(-a, a, 101)[1:-1]) > 0)


def test_the_pressure_carries_the_load_and_has_its_peak_in_the_middle():
    solved = disc.disc_in_contact(a=0.6, R=2.0, E_plane=7.0)
    total, _ = quad(lambda x: float(solved.pressure(x)), -0.6, 0.6)
    assert total == pytest.approx(solved.P, rel=1e-9)
    assert float(solved.pressure(0.0)) == pytest.approx(solved.p_0, rel=1e-13)
    assert solved.pressure([0.6, 1.0]).tolist() == [0.0, 0.0]


@pytest.mark.parametrize("P", [1e-12, 1e-3, 0.1])
def test_load_and_half_width_ask_for_the_same_disc(P):
    loaded = disc.disc_under_load(P=P, R=2.0, E_plane=3.0)
    np.testing.assert_allclose(loaded.P, P, rtol=1e-11)
    assert disc.disc_in_contact(a=loaded.a, R=2.0, E_plane=3.0).p_0 == loaded.p_0


def test_the_series_converges_geometrically():
    """Ratio (R/a + sqrt(R²/a² - 1))^-2 per term at a = 0.9 R, as the nearest singularity has it."""
    b = np.abs(disc.disc_in_contact(a=0.9, R=1.0, E_plane=1.0).coefficients)
    expected = (1 / 0.9 + np.sqrt(1 / 0.81 - 1)) ** -2
    assert (b[24] / b[12]) ** (1 / 12) == pytest.approx(expected, rel=0.1)
    assert b[-1] < 1e-14 * b[0]


def hertz_of(solved):
    load = {"P": solved.P, "R": 1.0, "E_star": 1.0}
    return float(hertz_line.peak_pressure(**load)), float(hertz_line.half_width(**load))


@pytest.mark.parametrize("quantity", ["pressure", "width", "approach"])
def test_the_first_correction_leaves_an_error_of_fourth_order(quantity):
    left = []
    for a in WIDTHS:
        solved = disc.disc_in_contact(a=a, R=1.0, E_plane=1.0)
        p_hertz, a_hertz = hertz_of(solved)
        left.append(
            {
                "pressure": solved.p_0 / p_hertz - 1 - disc_series.pressure_excess(a=a, R=1.0),
                "width": a / a_hertz - 1 - disc_series.width_excess(a=a, R=1.0),
                "approach": (
                    solved.approach - disc_series.approach(P=solved.P, a=a, R=1.0, E_plane=1.0)
                )
                / solved.P,
            }[quantity]
        )
    orders = np.log2(np.abs(left[1:]) / np.abs(left[:-1]))
    np.testing.assert_allclose(orders, 4.0, atol=0.1)


def test_hertz_s_width_in_the_logarithm_changes_the_next_term_of_the_approach():
    """+9/16 (a/R)², as the docstring says: -1/16 + 2 * 5/16."""
    solved = disc.disc_in_contact(a=0.01, R=1.0, E_plane=1.0)
    _, a_hertz = hertz_of(solved)
    leading = hertz_line_approach.approach_to_centre(P=solved.P, a=a_hertz, R=1.0, E_plane=1.0)
    rest = (solved.approach - leading) * np.pi / solved.P / 0.01**2
    assert rest == pytest.approx(9 / 16, rel=1e-3)


@pytest.mark.parametrize(
    ("function", "change", "message"),
    [
        (disc.disc_in_contact, {"a": 0.95}, "may reach 0.9 R, got a=0.95 m, R=1 m"),
        (disc.disc_in_contact, {"a": np.nan}, "half-width must be positive"),
        (disc.disc_in_contact, {"a": 0.1, "E_plane": np.inf}, "modulus"),
        (disc.disc_under_load, {"P": 10.0}, "the load may flatten up to a = 0.9 R"),
        (disc.disc_under_load, {"P": 0.0}, "load per length"),
        (disc.disc_under_load, {"P": 1.0, "R": -1.0}, "radius"),
        (disc_series.pressure_excess, {"a": 1.0}, "below the radius"),
    ],
)
def test_input_that_makes_no_sense_is_refused(function, change, message):
    body = {"R": 1.0} if function is disc_series.pressure_excess else {"R": 1.0, "E_plane": 1.0}
    with pytest.raises(ValueError, match=message):
        function(**body | change)


def test_positions_that_are_no_numbers_are_refused():
    with pytest.raises(ValueError, match="position must be finite"):
        disc.disc_in_contact(a=0.1, R=1.0, E_plane=1.0).pressure(np.nan)

"""Crowns against their limits, exact arithmetic and the displacements that they answer."""

from decimal import Decimal, localcontext

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from analytic.contact import crown, hertz_line

STEEL = {"length": 9e-3, "E_star": 206e9 / (2 * 0.91)}  # the paper's roller
DESIGN = {"load": 3400.0, **STEEL}
PAPER = {"K_1": 2.1507, "K_2": 0.6763, "z_m": 12.1e-6, **DESIGN}  # Eq. 21
UNIT = {"load": np.pi, "length": 2.0, "E_star": 0.5}  # W/(pi l E*) = 1, y from -1 to 1


def to_sixty_digits(t, m):
    """-ln(1 - (1 - exp(-m)) t²)."""
    with localcontext() as context:
        context.prec = 60
        t, m = Decimal(t), Decimal(m)
        return float(-(1 - (1 - (-m).exp()) * t * t).ln())


@pytest.mark.parametrize("m", [1e-14, 1e-6, 0.1, 1.0, 10.0, 700.0, 5000.0])
@pytest.mark.parametrize("t", [1e-9, 0.1, 0.7, 0.72, 0.95, 1 - 1e-6, 1 - 1e-12, 1 - 2**-52])
def test_the_drop_keeps_its_digits_for_any_depth_and_place(m, t):
    z = crown.logarithmic(t, K_1=1.0, K_2=1.0, z_m=m, **UNIT)
    assert float(z) == pytest.approx(to_sixty_digits(t, m), rel=2e-15)


@given(
    K_1=st.floats(0.1, 10), K_2=st.floats(0.01, 1), z_m=st.floats(1e-9, 1e-2), side=st.booleans()
)
def test_the_drop_at_the_ends_is_z_m_and_nowhere_more(K_1, K_2, z_m, side):
    y = np.linspace(0, 1, 101) * (4.5e-3 if side else -4.5e-3)
    z = crown.logarithmic(y, K_1=K_1, K_2=K_2, z_m=z_m, **DESIGN)
    assert z[0] == 0
    assert z[-1] == z_m
    assert np.all(np.diff(z) >= 0)


def test_the_crown_is_symmetric():
    y = np.linspace(0, 4.5e-3, 50)
    for profile, parameters in (
        (crown.logarithmic, PAPER),
        (crown.lundberg, DESIGN),
        (crown.johns_gohar, {"half_width": 1e-4, **DESIGN}),
    ):
        np.testing.assert_array_equal(profile(y, **parameters), profile(-y, **parameters))


def test_a_deep_crown_over_the_whole_length_is_lundbergs():
    y = np.linspace(-0.999, 0.999, 41)
    deep = crown.logarithmic(y, K_1=1.0, K_2=1.0, z_m=1e3, **UNIT)
    np.testing.assert_allclose(deep, crown.lundberg(y, **UNIT), rtol=1e-14)


def test_a_shallow_crown_is_a_parabola():
    """With m = z_m/A the next term is -m t² (1 - t²)/2 of it."""
    t, m = np.linspace(0.1, 0.9, 9), 1e-4
    z = crown.logarithmic(t, K_1=1.0, K_2=1.0, z_m=m, **UNIT)
    np.testing.assert_allclose(z / (m * t**2) - 1, -m / 2 * (1 - t**2), rtol=2e-4)


@pytest.mark.parametrize("z_m", [1e-9, 5e-6, 25e-6, 1e-3])
@pytest.mark.parametrize("K_2", [0.4, 0.7, 1.0])
def test_the_straight_middle_depends_on_k_2_alone(K_2, z_m):
    """The paper says (Sec. 4.1) that it "is only determined by z_m"."""
    half = float(crown.straight_length(K_2=K_2, length=9e-3)) / 2
    assert half == pytest.approx((1 - K_2) * 4.5e-3, abs=1e-18)
    within, beyond = crown.logarithmic(
        [half * (1 - 1e-12), half + 1e-5], **PAPER | {"K_2": K_2, "z_m": z_m}
    )
    assert float(within) == 0
    assert float(beyond) > 0


def test_k_1_multiplies_the_design_load_and_the_papers_modulus_is_twice_e_star():
    y = np.linspace(0, 4.4e-3, 9)
    twice = crown.logarithmic(y, **PAPER | {"K_1": 2 * PAPER["K_1"], "load": DESIGN["load"] / 2})
    np.testing.assert_allclose(twice, crown.logarithmic(y, **PAPER), rtol=1e-14)
    E_prime = 206e9 / (1 - 0.3**2)
    A = 2 * PAPER["K_1"] * 3400 / (np.pi * 9e-3 * E_prime)  # as printed
    t = (y[-1] - 4.5e-3) / (PAPER["K_2"] * 4.5e-3) + 1
    expected = -A * np.log(1 - (1 - np.exp(-PAPER["z_m"] / A)) * t**2)
    assert float(crown.logarithmic(y[-1], **PAPER)) == pytest.approx(expected, rel=1e-13)


def line_load_displacement(y, *, length, half_width):
    """Displacement on the axis of a uniform line load, in units of W/(pi l E*), by quadrature.

    Hertz's ellipse across: 2/pi int sqrt(1 - x²) [asinh((l/2 - y)/(b x)) + asinh(...)] dx, with
    x = s², which takes the logarithm out of the corner.
    """

    def across(s):
        x = s**2
        arms = np.arcsinh(
            [(length / 2 - y) / (half_width * x), (length / 2 + y) / (half_width * x)]
        )
        return 2 * 2 / np.pi * np.sqrt(1 - x**2) * arms.sum() * 2 * s

    return quad(across, 0, 1, epsabs=1e-12)[0]


def test_johns_and_gohars_constant_is_the_uniform_loads_own_end():
    """At the end the drop is what the end sinks less than the middle, but for (b/l)²."""
    b = 0.01
    middle, end = (line_load_displacement(y, length=2.0, half_width=b) for y in (0.0, 1.0))
    z = crown.johns_gohar(1.0, half_width=b, **UNIT)
    assert float(z) == pytest.approx(middle - end, rel=2e-5)
    assert pytest.approx(0.3033, abs=5e-5) == crown.END


def test_lundbergs_drop_is_what_a_uniform_load_needs_away_from_the_ends():
    b, y = 0.01, 0.8
    middle, there = (line_load_displacement(at, length=2.0, half_width=b) for at in (0.0, y))
    assert float(crown.lundberg(y, **UNIT)) == pytest.approx(middle - there, rel=1e-3)


def test_johns_and_gohar_leave_lundberg_only_near_the_ends():
    b = float(hertz_line.half_width(P=3400 / 9e-3, R=2.952e-3, E_star=STEEL["E_star"]))
    inside, near = np.array([0.0, 2e-3]), 4.49e-3
    parameters = {"half_width": b, **DESIGN}
    np.testing.assert_allclose(
        crown.johns_gohar(inside, **parameters), crown.lundberg(inside, **DESIGN), rtol=0.02
    )
    ends = crown.lundberg(near, **DESIGN) / crown.johns_gohar(near, **parameters)
    assert 1.1 < float(ends) < 2
    assert np.isinf(crown.lundberg(4.5e-3, **DESIGN))


def test_as_printed_the_straight_middle_is_crowned_and_one_end_is_not_like_the_other():
    """Eq. 1 without the maximum and the bars: t² grows again where t has passed zero."""

    def printed(y):
        A = PAPER["K_1"] * 3400 / (np.pi * 9e-3 * STEEL["E_star"])
        t = (y - 4.5e-3) / (PAPER["K_2"] * 4.5e-3) + 1
        return -A * np.log(1 - (1 - np.exp(-PAPER["z_m"] / A)) * t**2)

    crowned = np.linspace(1.5e-3, 4.49e-3, 20)  # beyond the straight part on the side of +y
    np.testing.assert_allclose(printed(crowned), crown.logarithmic(crowned, **PAPER), rtol=1e-11)
    assert printed(0.0) > 1e-7  # t = 1 - 1/K_2: a crown in the middle of the straight part
    assert float(crown.logarithmic(0.0, **PAPER)) == 0
    t_at_other_end = 1 - 2 / PAPER["K_2"]
    assert t_at_other_end < -1.9
    with np.errstate(invalid="ignore"):
        assert np.isnan(printed(-4.5e-3))  # t² > 1, and the logarithm's argument negative


def test_with_eq_5s_coordinate_from_the_end_the_logarithm_fails():
    """Eq. 5 puts (j - 0.5) l/n for y: at the far end its bracket is near 1 + 1/K_2."""
    n, length, K_2 = 50, 9e-3, PAPER["K_2"]
    y = (np.arange(1, n + 1) - 0.5) * length / n
    t = (y - length / 2) / (K_2 * length / 2) + 1
    assert t[-1] == pytest.approx(1 + 1 / K_2, abs=2 / (K_2 * n))
    A = PAPER["K_1"] * 3400 / (np.pi * length * STEEL["E_star"])
    argument = 1 - (1 - np.exp(-PAPER["z_m"] / A)) * t**2
    assert np.sum(argument < 0) >= n // 4
    centres = crown.slice_centres(length=length, slices=n)  # from mid-length: all in order
    assert np.all(np.isfinite(crown.logarithmic(centres, **PAPER)))


def test_slice_centres_fill_the_length_symmetrically():
    centres = crown.slice_centres(length=9e-3, slices=7)
    np.testing.assert_allclose(centres, -centres[::-1], atol=1e-18)
    np.testing.assert_allclose(np.diff(centres), 9e-3 / 7, rtol=1e-12)
    assert centres[0] == pytest.approx(-4.5e-3 + 9e-3 / 14, rel=1e-12)


def test_parameters_and_places_broadcast():
    y, K_1 = np.linspace(-4.5e-3, 4.5e-3, 11), np.array([1.0, 2.0, 5.0])
    z = crown.logarithmic(y, **PAPER | {"K_1": K_1[:, None]})
    assert z.shape == (3, 11)
    for row, k in zip(z, K_1, strict=True):
        np.testing.assert_array_equal(row, crown.logarithmic(y, **PAPER | {"K_1": k}))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"K_2": 0.0}, r"K_2, .* must lie in \(0, 1\], got 0.0"),
        ({"K_2": 1.01}, r"K_2, .* must lie in \(0, 1\], got 1.01"),
        ({"K_2": np.nan}, r"K_2, .* must lie in \(0, 1\], got nan"),
        ({"K_1": 0.0}, "K_1 must be positive and finite, got 0.0$"),
        ({"z_m": 0.0}, "z_m at the ends must be positive and finite, got 0.0 m"),
        ({"z_m": np.inf}, "z_m at the ends must be positive and finite, got inf m"),
        ({"load": -1.0}, "load must be positive and finite, got -1.0 N"),
        ({"length": 0.0}, "length must be positive and finite, got 0.0 m"),
        ({"E_star": np.nan}, "contact modulus must be positive and finite, got nan Pa"),
        ({"y": 4.6e-3}, r"must lie on the roller, \|y\| <= l/2, got y=0.0046 m, l=0.009 m"),
        ({"y": np.nan}, "position must be finite, got nan m"),
    ],
)
def test_crowns_that_make_no_sense_are_refused(change, message):
    parameters = {"y": 0.0, **PAPER, **change}
    with pytest.raises(ValueError, match=message):
        crown.logarithmic(parameters.pop("y"), **parameters)


def test_a_contact_wider_than_the_roller_is_long_is_refused():
    with pytest.raises(ValueError, match=r"half-width must be below the length, got b=0.01 m"):
        crown.johns_gohar(0.0, half_width=0.01, **DESIGN)
    with pytest.raises(ValueError, match="slices must be at least 1, got 0"):
        crown.slice_centres(length=1.0, slices=0)


@pytest.mark.parametrize(
    "profile",
    [
        lambda k, s: crown.lundberg(4e-3 * k, **metric(k, s)),
        lambda k, s: crown.johns_gohar(4e-3 * k, half_width=1e-4 * k, **metric(k, s)),
        lambda k, s: crown.logarithmic(
            4e-3 * k, K_1=2.0, K_2=0.7, z_m=1e-5 * k, **metric(k, s)),
    ],
    ids=["Lundberg", "Johns and Gohar", "logarithmic"],
)  # fmt: skip
def test_drops_are_dimensionally_homogeneous(profile):
    assert float(profile(1e3, 1e-6)) == pytest.approx(1e3 * float(profile(1.0, 1.0)), rel=1e-12)


def metric(k, s):
    return {"load": 3400 * s * k**2, "length": 9e-3 * k, "E_star": 1.13e11 * s}

"""Crowns: exact arithmetic, design loads, a second implementation, and the mean drop."""

import math
from decimal import Decimal, localcontext

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from analytic.contact import crown, crown_again
from analytic.contact.crown_mean import mean_drop, z_m_share

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


@pytest.mark.parametrize("m", [1e-14, 0.1, 10.0, 5000.0])
@pytest.mark.parametrize("t", [1e-9, 0.7, 0.72, 1 - 1e-6, 1 - 2**-52])
def test_the_drop_keeps_its_digits_for_any_depth_and_place(m, t):
    z = crown.logarithmic(t, K_1=1.0, K_2=1.0, z_m=m, **UNIT)
    assert float(z) == pytest.approx(to_sixty_digits(t, m), rel=2e-15)


@settings(deadline=None)
@given(
    K_1=st.floats(0.1, 10), K_2=st.floats(0.01, 1), z_m=st.floats(1e-9, 1e-2), side=st.booleans()
)
def test_the_drop_at_the_ends_is_z_m_and_nowhere_more(K_1, K_2, z_m, side):
    y = np.linspace(0, 1, 101) * (4.5e-3 if side else -4.5e-3)
    z = crown.logarithmic(y, K_1=K_1, K_2=K_2, z_m=z_m, **DESIGN)
    assert z[0] == 0
    assert z[-1] == z_m
    assert np.all(np.diff(z) >= 0)


def test_k_1_multiplies_the_design_load_and_the_papers_modulus_is_twice_e_star():
    y = np.linspace(0, 4.4e-3, 9)
    twice = crown.logarithmic(y, **PAPER | {"K_1": 2 * PAPER["K_1"], "load": DESIGN["load"] / 2})
    np.testing.assert_allclose(twice, crown.logarithmic(y, **PAPER), rtol=1e-14)
    E_prime = 206e9 / (1 - 0.3**2)
    A = 2 * PAPER["K_1"] * 3400 / (np.pi * 9e-3 * E_prime)  # as printed
    t = (y[-1] - 4.5e-3) / (PAPER["K_2"] * 4.5e-3) + 1
    expected = -A * np.log(1 - (1 - np.exp(-PAPER["z_m"] / A)) * t**2)
    assert float(crown.logarithmic(y[-1], **PAPER)) == pytest.approx(expected, rel=1e-13)


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


SAME = 1e-12  # of the drop, and as much of A, in which logarithms near 1 are rounded
CROWNS = ((1, 0.7, 10e-6), (2.1507, 0.6763, 12.1e-6), (0.4, 0.08, 3e-7), (1, 1, 1e-3))
y = np.linspace(-4.5e-3, 4.5e-3, 4001)


def scale(load):
    return load / (np.pi * STEEL["length"] * STEEL["E_star"])


def same(one, other, A):
    return np.all(np.abs(one - other) <= SAME * (np.abs(one) + A))


@pytest.mark.parametrize("load", [1.0, 3407.0])
@pytest.mark.parametrize("design", CROWNS, ids=str)
def test_both_writings_of_eq_1_agree(design, load):
    K_1, K_2, z_m = design
    A = K_1 * scale(load)
    law = {"K_1": K_1, "K_2": K_2, "z_m": min(z_m, 500 * A), "load": load, **STEEL}
    # at the very end z_m alone is left of the reference's argument of the logarithm
    inner = (np.abs(y) < 0.999 * 4.5e-3) | (law["z_m"] <= 15 * A)
    written = crown.logarithmic(y, **law)[inner]
    assert same(crown_again.logarithmic(**law)(y)[inner], written, A)


@pytest.mark.parametrize("load", [1.0, 3407.0, 30e3])
def test_johns_and_gohar_s_constant_is_the_one_that_they_print(load):
    A, law = scale(load), {"load": load, "half_width": 0.13e-3, **STEEL}
    written, again = crown.johns_gohar(y, **law), crown_again.johns_gohar(**law)(y)
    assert abs(crown.END - 0.3033) <= 5e-5
    assert np.abs(again - written).max() <= 5e-5 / 0.3033 * A  # the logarithm of the constant
    assert same(again[y == 0], written[y == 0], A)


@pytest.mark.parametrize("z_m", [1e-3, 1.0, 30.0, 800.0])
def test_the_mean_drop_is_that_of_the_profile(z_m):
    y = 1 - np.linspace(0, 1, 200_001) ** 4  # close to the end
    z = crown.logarithmic(y, K_1=1.0, K_2=0.6, z_m=z_m, load=np.pi, length=2.0, E_star=0.5)
    assert mean_drop(1.0, 0.6, z_m) == pytest.approx(float(np.trapezoid(-z, y)), rel=1e-6)


@pytest.mark.parametrize("z_m", [1e-3, 1.0, 12.0])
def test_the_share_of_z_m_is_the_slope_of_the_mean(z_m):
    h = 1e-4
    slope = math.log(mean_drop(1.0, 1.0, z_m * (1 + h)) / mean_drop(1.0, 1.0, z_m * (1 - h)))
    assert z_m_share(1.0, z_m) == pytest.approx(slope / (2 * h), rel=1e-4)

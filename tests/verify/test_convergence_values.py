"""Orders and slopes of convergence at values calculated by hand, and at ties."""

import math

import pytest

from verify.judging.convergence import (
    fit_order,
    observed_order,
    order_from_iteration,
    slope_of_ratio,
    unresolved_multiple,
)

LN2 = math.log(2)


@pytest.mark.parametrize("sign", [1, -1])
def test_the_larger_step_makes_the_multiple_of_the_spread(sign):
    for step, multiple in ((0.5e-10, 1.0), (0.75e-10, 2.0), (1e-10, 3.0), (4e-10, 3.0)):
        assert unresolved_multiple(sign * step, 0.0, 1.0) == pytest.approx(multiple, rel=1e-12)
        assert unresolved_multiple(0.0, sign * step, 1.0) == pytest.approx(multiple, rel=1e-12)
    assert unresolved_multiple(0.0, 0.0, 0.0) == 1.0  # zeros of no scale


# Orders: on halved meshes the ratio of differences is 2^p.


@pytest.mark.parametrize(
    ("exponent", "order"), [(59, 59.0), (61, 60.0), (-19, -19.0), (-21, -20.0)]
)
def test_orders_are_found_from_minus_20_to_60(exponent, order):
    assert observed_order(2.0**exponent, 2.0, 2.0) == pytest.approx(order, abs=1e-9)


@pytest.mark.parametrize("r32", [4.0, math.sqrt(2)])
def test_a_series_in_the_logarithm_has_order_zero(r32):
    """Its differences are ln r32 and ln r21 = ln 2; orders within 1e-9 of zero count as zero."""
    assert abs(observed_order(math.log(r32) / LN2, 2.0, r32)) < 9e-10


# What iteration takes from an order. On meshes 8, 2, 1 the ratio of differences is X^2 + X with
# X = 2^p, and its logarithm has the slope ln 2 (2 X + 1)/(X + 1).


@pytest.mark.parametrize("p", [-1.0, 0.0, 2.0])
def test_slope_of_the_ratio_by_hand(p):
    X = 2.0**p
    assert slope_of_ratio(p, 2.0, 4.0) == pytest.approx(LN2 * (2 * X + 1) / (X + 1), rel=1e-12)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(("p", "share"), [(0.99e-6, 0), (1e-6, 1)])
def test_orders_below_1e_6_have_the_slope_of_zero(p, share, sign):
    """From there on p (b^2 - a^2)/12 = p (ln 2)^2/4 is added, 1.2e-7: round-off is 1e-9."""
    slope = 1.5 * LN2 + share * sign * p * LN2**2 / 4
    assert slope_of_ratio(sign * p, 2.0, 4.0) == pytest.approx(slope, abs=5e-9)


@pytest.mark.parametrize(
    ("u", "least"),
    # X = 2 as computed, 6 = 2^2 + 2; (6 - 2 u)/(1 + 2 u) = X^2 + X at worst
    [(2 / 3, 0.0), (13 / 6, -2.0)],
)
def test_the_slope_where_the_order_is_least_counts_on_uneven_meshes(u, least):
    X = 2.0**least
    by_hand = math.log(6 / (X**2 + X)) / (LN2 * (2 * X + 1) / (X + 1))
    assert order_from_iteration((8, 2, 1), (7.0, 1.0, 0.0), u) == pytest.approx(by_hand, rel=1e-9)


# The order of errors. With the sizes below the middles of the meshes, sqrt(h h'), are 3, 2 and 1.


def test_scatter_of_the_slopes_by_hand():
    """Slopes of 2 + d (1, -2, 1) have the line 2, the residual |d| sqrt 6, and 7/3 at zero."""
    d = -0.01
    h, errors = (3.6, 2.5, 1.6, 0.625), [1.0]
    for slope, coarse, fine in zip((2 + d, 2 - 2 * d, 2 + d), h[:-1], h[1:], strict=True):
        errors.append(errors[-1] * (fine / coarse) ** slope)
    fit = fit_order(h, errors)
    assert fit.order == pytest.approx(2.0, abs=1e-12)
    assert (fit.parts[0], fit.u) == pytest.approx((abs(d) * math.sqrt(14),) * 2, rel=1e-9)


def test_round_off_is_that_of_the_largest_logarithm_over_the_least_refinement():
    h = (1.0, 1 / 4, 1 / 8, 1 / 64)  # ratios 4, 2 and 8; logarithms up to 2 ln 64 = 12 ln 2
    assert fit_order(h, [x**2 for x in h]).parts[2] == pytest.approx(60e-15, rel=1e-9, abs=0)

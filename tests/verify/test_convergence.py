"""Grid convergence on series v = v0 + c h^p, whose limit, order and error are known by hand.

With v_k = v0 + c h_k^p the finest value is off by e = c h1^p and the last difference is
|v1 - v2| = |e| (r^p - 1). So the index F |v1 - v2|/(r^p - 1) is F |e|, whatever the ratios.
"""

import math
from itertools import accumulate

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from verify.judging.convergence import fit_order, grid_convergence

fixed = settings(deadline=None, derandomize=True, max_examples=40)

EVEN, CLOSE = (1.0, 0.5, 0.25), (1.0, 0.9, 0.3)


def power_law(h, *, v0, c, p):
    return [v0 + c * x**p for x in h]


def test_published_example_of_reattachment_length():
    """Celik et al. 2008, the printed column phi = reattachment length, monotonic convergence.

    Cells 18000, 8000, 4500 in the plane: r21 = sqrt(18000/8000) = 1.5, r32 = sqrt(8000/4500) =
    4/3. The element's order is taken as 2, from which 1.53 differs by less than 0.5: F = 1.25,
    as in the paper, and p = min(1.53, 2) is the observed order that the paper uses as well.
    (A formal order of 1.5 would cap p and give 2.24 % instead of the 2.17 % from p = 1.53.)
    """
    h = [cells**-0.5 for cells in (4500, 8000, 18000)]
    found = grid_convergence(h, (5.863, 5.972, 6.063), formal=2, scale=6.063)
    assert found.order == pytest.approx(1.53, abs=0.005)  # printed 1.53
    # extrapolated by hand with p = 1.5340: 6.063 + 0.091/(1.5^1.5340 - 1) = 6.1685, as printed
    assert found.extrapolated == pytest.approx(6.1685, abs=0.0005)
    assert found.gci / 6.063 == pytest.approx(0.0217, abs=0.00005)  # printed 2.2 %


# What p and F are: observed order 2 on halved meshes, e = 0.3/16, |v1 - v2| = 3 e.

E2 = 0.3 / 16  # c h1^2


@pytest.mark.parametrize(
    ("formal", "gci"),
    [
        pytest.param(2.0, 1.25 * E2, id="orders agree"),
        pytest.param(2.525, (1.25 + 3) / 2 * E2, id="half an order below: the mean factor"),
        pytest.param(1.475, (1.25 + 3) / 2 * 3 * E2 / (2**1.475 - 1), id="half an order above"),
    ],
)
def test_index_takes_the_smaller_order_and_the_factor_of_their_distance(formal, gci):
    values = power_law(EVEN, v0=5.0, c=0.3, p=2)
    found = grid_convergence(EVEN, values, formal=formal, scale=5.0)
    assert found.gci == pytest.approx(gci, rel=1e-9)
    assert found.order == pytest.approx(2.0, abs=1e-6)


def test_observed_order_decides_alone_where_theory_gives_none():
    values = power_law(EVEN, v0=5.0, c=0.3, p=2)
    found = grid_convergence(EVEN, values, formal=None, scale=5.0)
    assert found.order == pytest.approx(2.0, abs=1e-6)
    assert found.gci == pytest.approx(3 * 0.3 * (1 - 1 / 16), rel=1e-9)  # 3 (max - min)


# Series without an order: GCI = 3 (max - min of the last three).


@pytest.mark.parametrize(
    ("values", "u_it", "behaviour", "spread"),
    [
        pytest.param((1.0, 0.8, 0.9), 0.0, "oscillating", 0.2, id="turns back"),
        pytest.param((1.5, 1.1, 1.0), 0.00101, "noisy", 0.5, id="u_it above 1 % of |v3 - v2|"),
        pytest.param((1.0, 2.0, 3.0), 0.0, "slow", 2.0, id="equal steps: order 0, a logarithm"),
        pytest.param((1.0, 2.0, 2.9), 0.0, "slow", 1.9, id="order log2(1/0.9) = 0.15"),
        pytest.param((9e6, 1.0, 1.2, 1.1), 0.0, "oscillating", 0.2, id="only the last three count"),
    ],
)
def test_without_an_order_three_times_the_spread_is_uncertain(values, u_it, behaviour, spread):
    h = [2.0**-k for k in range(len(values))]
    found = grid_convergence(h, values, formal=2, scale=1.0, u_it=u_it)
    assert found.behaviour == behaviour
    assert found.gci == pytest.approx(3 * spread, rel=1e-12)
    assert found.order is None
    assert found.extrapolated is None
    assert found.converges


def test_iteration_error_of_one_per_cent_of_the_last_difference_leaves_the_order():
    found = grid_convergence(EVEN, (1.0, 1.4, 1.5), formal=2, scale=1.0, u_it=0.00099)
    assert found.order == pytest.approx(2.0, abs=1e-6)  # 0.4/0.1 = 2^2
    assert found.gci == pytest.approx(1.25 * 0.1 / 3, rel=1e-9)


# Series that do not converge.


@pytest.mark.parametrize(
    ("h", "values"),
    [
        pytest.param(EVEN, (1.3, 1.2, 1.0), id="growing steps"),
        pytest.param(EVEN, (1.0, 1.1, 0.9), id="growing oscillation"),
        pytest.param(EVEN, (1.0, 1.0, 1.3), id="nothing, then a step"),
        pytest.param(EVEN, (1.0, 1.0 + 1e-9, 1.0 + 3e-9), id="growing steps, however small"),
        pytest.param(CLOSE, (1.0, 0.9**-0.2, 0.3**-0.2), id="v = h^-0.2, very uneven"),
    ],
)
def test_growing_differences_diverge(h, values):
    found = grid_convergence(h, values, formal=2, scale=1.0)
    assert found.behaviour == "diverging"
    assert not found.converges
    assert found.gci == math.inf
    assert found.order is None


@pytest.mark.parametrize(
    ("u_it", "behaviour"),
    # Two differences, each of two values, carry at most 4 u_it; the steps grow by 0.1.
    [(0.0, "diverging"), (0.024, "diverging"), (0.026, "noisy")],
)
def test_growth_within_the_iteration_error_is_noise(u_it, behaviour):
    found = grid_convergence(EVEN, (0.0, 0.9, 1.9), formal=2, scale=1.0, u_it=u_it)
    assert found.behaviour == behaviour


@pytest.mark.parametrize("count", [0, 2])
def test_fewer_than_three_values_show_no_convergence(count):
    found = grid_convergence(EVEN[:count], (1.0, 1.1)[:count], formal=2, scale=1.0)
    assert (found.behaviour, found.gci, found.converges) == ("short", math.inf, False)


# Round-off: no order from a last difference below 5e-10 of the scale.


@pytest.mark.parametrize(
    ("values", "residual", "gci"),
    [
        pytest.param((1.0, 1.0 + 3e-11, 1.0 - 1e-11), 0.0, 4e-11, id="max - min"),
        pytest.param((1.0, 1.0, 1.0 + 7.5e-11), 0.0, 15e-11, id="nearly 1e-10: twice as much"),
        pytest.param((1.0, 1.0, 1.0 + 2e-10), 0.0, 6e-10, id="above 1e-10: three times"),
        pytest.param((1.0, 1.0 + 4e-10, 1.0), 0.0, 12e-10, id="which turns back"),
        pytest.param((1.0, 1.0, 1.0), 0.0, 1e-12, id="equal: 1e-12 of the scale"),
        pytest.param((1.0, 1.0, 1.0), 1e-9, 1e-9, id="the solver's bound where larger"),
        pytest.param((1.0, 1.0 + 5e-11, 1.0), 1e-11, 5e-11, id="the solver's bound is smaller"),
    ],
)
def test_differences_below_round_off_give_no_order(values, residual, gci):
    found = grid_convergence(EVEN, values, formal=2, scale=1.0, residual=residual)
    assert found.behaviour == "round-off"
    assert found.order is None
    assert found.gci == pytest.approx(gci, abs=1e-15)  # 4 eps of the values
    assert found.converges


@pytest.mark.parametrize(
    ("step", "behaviour"), [(4.95e-10, "round-off"), (5.05e-10, "oscillating")]
)
def test_round_off_ends_at_5e_10_of_the_scale(step, behaviour):
    for scale in (1.0, 1e9):
        values = (0.0, step * scale, 0.0)
        assert grid_convergence(EVEN, values, formal=2, scale=scale).behaviour == behaviour


def test_the_index_never_falls_below_1e_12_of_the_scale_or_the_solver_s_bound():
    values = power_law(EVEN, v0=0.0, c=1.0, p=2)
    assert grid_convergence(EVEN, values, formal=2, scale=1e12).gci >= 1.0
    assert grid_convergence(EVEN, values, formal=2, scale=1.0, residual=0.5).gci >= 0.5
    found = grid_convergence(EVEN, (0.0, 0.0, 0.0), formal=1, scale=0.0)
    assert (found.behaviour, found.gci) == ("round-off", 0.0)


@pytest.mark.parametrize(
    ("h", "values", "message"),
    [
        pytest.param((1.0, 0.5), (1.0, 2.0, 3.0), "2 mesh sizes for 3 values", id="lengths"),
        pytest.param((1.0, 1.0, 0.5), (1.0, 2.0, 3.0), "decrease", id="a mesh twice"),
        pytest.param((1.0, 0.5, 0.0), (1.0, 2.0, 3.0), "positive", id="no size"),
        pytest.param((math.inf, 0.5, 0.2), (1.0, 2.0, 3.0), "positive", id="size infinite"),
        pytest.param(EVEN, (1.0, 2.0, math.nan), "no number", id="value NaN"),
    ],
)
def test_what_is_no_series_is_refused(h, values, message):
    with pytest.raises(ValueError, match=message):
        grid_convergence(h, values, formal=2, scale=1.0)


# The same for all power laws: e is the error on the finest mesh, r21 and r32 any ratios.

orders = st.floats(0.6, 6)
ratios = st.floats(1.2, 4)
errors = st.builds(lambda sign, e: sign * e, st.sampled_from([1, -1]), st.floats(1e-3, 10))
limits = st.floats(-10, 10)


@st.composite
def power_laws(draw):
    """h, values, v0, e, p, r21: a power law with the error e on its finest mesh."""
    p, r21, r32, e, v0 = (draw(s) for s in (orders, ratios, ratios, errors, limits))
    h = (r32 * r21, r21, 1.0)
    return h, [v0 + e * x**p for x in h], v0, e, p, r21


@fixed
@given(power_laws(), st.floats(0.5, 8))
def test_every_index_is_the_error_times_what_the_rules_say(law, formal):
    h, values, _, e, p, r = law
    found = grid_convergence(h, values, formal=formal, scale=1.0)
    F = min(max(1.25 + 1.75 * (abs(p - formal) - 0.5) / 0.05, 1.25), 3.0)
    by_hand = F * abs(e) * (r**p - 1) / (r ** min(p, formal) - 1)
    assert found.gci == pytest.approx(by_hand, rel=1e-6)


any_values = st.floats(-1e3, 1e3).filter(lambda v: v == 0 or abs(v) > 1e-6)
triples = st.tuples(any_values, any_values, any_values)


@fixed
@given(triples, ratios, ratios, orders, st.floats(0, 0.1), st.integers(-100, 100))
def test_units_of_the_values_change_the_index_alone(values, r21, r32, formal, u_it, power):
    h, unit = (r32 * r21, r21, 1.0), 2.0**power  # a power of two scales without rounding
    here = grid_convergence(h, values, formal=formal, scale=1e3, u_it=u_it)
    there = grid_convergence(
        h, [unit * v for v in values], formal=formal, scale=1e3 * unit, u_it=u_it * unit
    )
    assert there.behaviour == here.behaviour
    assert there.order == here.order
    assert there.gci == unit * here.gci


@pytest.mark.parametrize("last", [1e-16, -1e-16])
@pytest.mark.parametrize("h", [EVEN, CLOSE])
def test_a_series_in_the_logarithm_of_the_size_has_one_verdict(h, last):
    """Its differences neither grow nor shrink: the limit of divergence is met exactly."""
    values = [-math.log(x) for x in h]
    found = grid_convergence(h, [*values[:2], values[2] + last * 4], formal=2, scale=1.0)
    assert found.behaviour == "slow"


# The order of errors against an exact value.

HALVED = (0.5, 0.25, 0.125, 0.0625)


@fixed
@given(
    p=st.floats(1, 5),
    first=st.floats(1.3, 2.5),
    more=st.lists(st.floats(1.3, 2.5), min_size=2, max_size=4),
    share=st.floats(-0.5, 0.5),
    step=st.sampled_from([1, 2]),
)
def test_a_next_term_of_half_the_leading_one_stays_within_the_uncertainty(
    p, first, more, share, step
):
    """Errors h^p (1 + a h^step), where a h^step is at most a half on the coarsest mesh."""
    h = list(accumulate([1.0, first, *more], lambda size, ratio: size / ratio))
    fit = fit_order(h, [x**p * (1 + share * x**step) for x in h])
    assert abs(fit.order - p) <= 2 * fit.u + 1e-12  # + round-off, as above


@pytest.mark.parametrize(
    ("h", "errors", "message"),
    [
        (HALVED[:3], (4.0, 2.0, 1.0), "four positive errors"),
        (HALVED, (4.0, 2.0, 1.0, 0.0), "four positive errors"),
        (HALVED, (4.0, 2.0, 1.0, math.nan), "no number"),
        (HALVED[::-1], (4.0, 2.0, 1.0, 0.5), "decrease"),
    ],
)
def test_what_has_no_order_is_refused(h, errors, message):
    with pytest.raises(ValueError, match=message):
        fit_order(h, errors)

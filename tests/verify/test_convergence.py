"""Grid convergence of series v = v0 + c h^p, with limit, order and error known by hand.

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
        pytest.param(None, 3 * 0.3 * (1 - 1 / 16), id="no order in theory: 3 (max - min)"),
    ],
)
def test_index_takes_the_smaller_order_and_the_factor_of_their_distance(formal, gci):
    values = power_law(EVEN, v0=5.0, c=0.3, p=2)
    found = grid_convergence(EVEN, values, formal=formal, scale=5.0)
    assert found.gci == pytest.approx(gci, rel=1e-9)
    assert found.order == pytest.approx(2.0, abs=1e-6)


@st.composite
def power_laws(draw):
    """h, values, e, p, r21: a power law with the error e on its finest mesh, of any ratios."""
    ratios = st.floats(1.2, 4)
    p, r21, r32, v0 = (draw(s) for s in (st.floats(0.6, 6), ratios, ratios, st.floats(-10, 10)))
    e = draw(st.sampled_from([1, -1])) * draw(st.floats(1e-3, 10))
    h = (r32 * r21, r21, 1.0)
    return h, [v0 + e * x**p for x in h], e, p, r21


@fixed
@given(power_laws(), st.floats(0.5, 8))
def test_every_index_is_the_error_times_the_factor_of_the_rules(law, formal):
    h, values, e, p, r = law
    found = grid_convergence(h, values, formal=formal, scale=1.0)
    F = min(max(1.25 + 1.75 * (abs(p - formal) - 0.5) / 0.05, 1.25), 3.0)
    by_hand = F * abs(e) * (r**p - 1) / (r ** min(p, formal) - 1)
    assert found.gci == pytest.approx(by_hand, rel=1e-6)


@pytest.mark.parametrize(
    ("behaviour", "values", "more", "gci"),
    [
        # three times the spread of the last three
        ("oscillating", (1.0, 0.8, 0.9), {}, 3 * 0.2),
        ("oscillating", (9e6, 1.0, 1.2, 1.1), {"h": (2.0, *EVEN)}, 3 * 0.2),
        ("slow", (1.0, 2.0, 3.0), {}, 3 * 2.0),  # equal steps: order 0, a logarithm
        ("slow", (1.0, 2.0, 2.9), {}, 3 * 1.9),  # order log2(1/0.9) = 0.15
        # u_it above 1 % of |v3 - v2|
        ("noisy", (1.5, 1.1, 1.0), {"u_it": 0.00101}, 3 * 0.5),
        ("monotone", (1.0, 1.4, 1.5), {"u_it": 0.00099}, 1.25 * 0.1 / 3),  # 0.4/0.1 = 2^2
        # growing differences
        ("diverging", (1.3, 1.2, 1.0), {}, math.inf),
        ("diverging", (1.0, 1.1, 0.9), {}, math.inf),
        ("diverging", (1.0, 1.0, 1.3), {}, math.inf),
        ("diverging", (1.0, 1.0 + 1e-9, 1.0 + 3e-9), {}, math.inf),  # however small
        ("diverging", (1.0, 0.9**-0.2, 0.3**-0.2), {"h": CLOSE}, math.inf),  # v = h^-0.2
        # two differences, each of two values, carry at most 4 u_it; the steps grow by 0.1
        ("diverging", (0.0, 0.9, 1.9), {"u_it": 0.024}, math.inf),
        ("noisy", (0.0, 0.9, 1.9), {"u_it": 0.026}, 3 * 1.9),
        # steps may grow by the round-off of both, half a unit of each at this scale
        ("slow", (0.0, 3.0, 7.0), {"scale": 5e9}, 3 * 7.0),
        ("diverging", (0.0, 3.0, 7.25), {"scale": 5e9}, math.inf),
        # the last step was to be ln 1.01/ln 2 = 0.0144 of what it is, which 4 u_it = 0.02 may hide
        ("oscillating", (0.0, 0.0, 1.0), {"h": (2.02, 2.0, 1.0), "u_it": 0.005}, 3.0),
        # fewer than three values
        ("short", (), {"h": ()}, math.inf),
        ("short", (1.0, 1.1), {"h": (1.0, 0.5)}, math.inf),
        # no order from a last difference below 5e-10 of the scale: of 1e-10 the spread and more
        ("round-off", (1.0, 1.0 + 3e-11, 1.0 - 1e-11), {}, 4e-11),
        ("round-off", (1.0, 1.0, 1.0 + 7.5e-11), {}, 15e-11),
        ("round-off", (1.0, 1.0, 1.0 + 2e-10), {}, 6e-10),
        ("round-off", (1.0, 1.0 + 4e-10, 1.0), {}, 12e-10),
        ("round-off", (0.0, 4.95e-1, 0.0), {"scale": 1e9}, 3 * 4.95e-1),
        ("oscillating", (0.0, 5.05e-1, 0.0), {"scale": 1e9}, 3 * 5.05e-1),
        # iteration is named where either step is more than round-off, one unit at this scale
        ("noisy", (0.0, 1.0, 1.0), {"scale": 1e10, "u_it": 1.0}, 3.0),
        ("round-off", (0.0, 0.75, 0.75), {"scale": 1e10, "u_it": 1.0}, 2 * 0.75),
        ("noisy", (0.0, -2.0, -2.0), {"scale": 1e10, "u_it": 1.0}, 3 * 2.0),
        ("noisy", (0.0, 0.0, -2.0), {"scale": 1e10, "u_it": 1.0}, 3 * 2.0),
        # never below 1e-12 of the scale or the solver's bound
        ("round-off", (1.0, 1.0, 1.0), {}, 1e-12),
        ("round-off", (1.0, 1.0, 1.0), {"residual": 1e-9}, 1e-9),
        ("round-off", (1.0, 1.0 + 5e-11, 1.0), {"residual": 1e-11}, 5e-11),
        ("round-off", (0.0, 0.0, 0.0), {"scale": 0.0}, 0.0),
        ("monotone", (1.0, 0.25, 0.0625), {"residual": 0.5}, 0.5),
    ],
)
def test_behaviour_and_index_of_a_series(behaviour, values, more, gci):
    found = grid_convergence(**({"h": EVEN, "values": values, "formal": 2, "scale": 1.0} | more))
    assert found.behaviour == behaviour
    assert found.gci == pytest.approx(gci, rel=1e-9, abs=1e-15)  # 4 eps of the values
    assert found.converges == (gci < math.inf)
    assert (found.order is None) == (behaviour != "monotone")


@pytest.mark.parametrize("last", [1e-16, -1e-16])
@pytest.mark.parametrize("h", [EVEN, CLOSE])
def test_a_series_in_the_logarithm_of_the_size_has_one_verdict(h, last):
    """Its differences neither grow nor shrink: the limit of divergence is met exactly."""
    values = [-math.log(x) for x in h]
    found = grid_convergence(h, [*values[:2], values[2] + last * 4], formal=2, scale=1.0)
    assert found.behaviour == "slow"


@fixed
@given(
    p=st.floats(1, 5),
    first=st.floats(1.3, 2.5),
    more=st.lists(st.floats(1.3, 2.5), min_size=2, max_size=4),
    share=st.floats(-0.5, 0.5),
    step=st.sampled_from([1, 2]),
)
def test_a_next_term_of_half_the_leading_one_stays_within_the_uncertainty_of_an_order(
    p, first, more, share, step
):
    """Errors h^p (1 + a h^step), where a h^step is at most a half on the coarsest mesh."""
    h = list(accumulate([1.0, first, *more], lambda size, ratio: size / ratio))
    fit = fit_order(h, [x**p * (1 + share * x**step) for x in h])
    assert abs(fit.order - p) <= 2 * fit.u + 1e-12  # + round-off


@pytest.mark.parametrize(
    ("h", "values", "message"),
    [
        ((1.0, 0.5), (4.0, 2.0, 1.0, 0.5), "got 2 sizes and 4 values"),
        ((1.0, 1.0, 0.5, 0.1), (4.0, 2.0, 1.0, 0.5), "decreasing"),
        ((1.0, 0.5, 0.1, 0.0), (4.0, 2.0, 1.0, 0.5), "positive"),
        ((math.inf, 0.5, 0.2, 0.1), (4.0, 2.0, 1.0, 0.5), "positive"),
        ((1.0, 0.5, 0.2, 0.1), (4.0, 2.0, 1.0, math.nan), "must be finite"),
    ],
)
def test_what_is_no_series_is_refused(h, values, message):
    with pytest.raises(ValueError, match=message):
        grid_convergence(h, values, formal=2, scale=1.0)
    with pytest.raises(ValueError, match=message):
        fit_order(h, values)
    for errors in ((4.0, 2.0, 1.0), (4.0, 2.0, 1.0, 0.0), (4.0, 2.0, 1.0, -1.0)):
        with pytest.raises(ValueError, match="four positive errors"):
            fit_order((0.5, 0.25, 0.125, 0.0625)[: len(errors)], errors)

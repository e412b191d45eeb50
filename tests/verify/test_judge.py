"""Verdicts at, just inside and just outside of every limit.

Limits are set with powers of two, for which sums and quotients carry no round-off: a row at its
limit is exactly at it.
"""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from verify.core.results import Status
from verify.judging import judge

fixed = settings(deadline=None, derandomize=True, max_examples=30)

NAN, INF = math.nan, math.inf
BAD = [pytest.param(x, id=str(x)) for x in (NAN, INF)]
U = 2.0**-10
HAIR = 2.0**-40  # 1e-12, far above the round-off of numbers near 1


def test_uncertainties_add_in_squares_and_count_twice():
    assert judge.expanded(3.0, 4.0, 12.0) == 26.0  # 2 sqrt(9 + 16 + 144)
    assert judge.expanded(0.5) == 1.0


# Differences: |d| <= U, and detects = (U + |d|)/scale <= demand.


@pytest.mark.parametrize("sign", [1, -1], ids=["above", "below"])
@pytest.mark.parametrize(
    ("d", "status"),
    [
        pytest.param(0.0, Status.PASS, id="no difference"),
        pytest.param(U, Status.PASS, id="exactly U"),
        pytest.param(U + HAIR, Status.FAIL, id="a hair more than U"),
    ],
)
def test_a_difference_passes_up_to_its_tolerance(d, status, sign):
    verdict = judge.difference(1.0 + sign * d, 1.0, U=U, scale=1.0)
    assert verdict.status is status
    assert verdict.difference == sign * d
    assert verdict.tolerance == U
    assert verdict.detects == U + d


@pytest.mark.parametrize(
    ("demand", "status"),
    [
        pytest.param(3 * 2.0**-12, Status.PASS, id="exactly what is demanded"),
        pytest.param(3 * 2.0**-12 - HAIR, Status.FAIL, id="a hair more is demanded"),
    ],
)
def test_a_row_that_detects_less_than_demanded_is_not_sharp(demand, status):
    # U + |d| = (2^-10 + 2^-11) of a scale of 2: 3 2^-12
    verdict = judge.difference(1.0 - U / 2, 1.0, U=U, scale=2.0, demand=demand)
    assert verdict.detects == 3 * 2.0**-12
    assert verdict.status is status
    assert verdict.reason.startswith("not sharp") == (status is Status.FAIL)


@pytest.mark.parametrize("scale", [0.0, -1.0, NAN, INF])
def test_a_scale_must_be_a_positive_number(scale):
    with pytest.raises(ValueError, match="scale"):
        judge.difference(1.0, 1.0, U=0.001, scale=scale)


@fixed
@given(
    r=st.floats(-10, 10),
    scale=st.floats(0.1, 10),
    U=st.floats(1e-6, 0.1),
    share=st.floats(-1, 1),
)
def test_detects_is_the_smallest_change_of_the_scale_that_surely_turns_the_row_red(
    r, scale, U, share
):
    value = r + share * U

    def passes(change):
        v = value + change * scale
        return judge.difference(v, r, U=U, scale=scale, demand=INF).status is Status.PASS

    detects = judge.difference(value, r, U=U, scale=scale, demand=INF).detects
    # 1e-6 of 1e-6 at least, beside which the round-off of numbers up to 10 is nothing
    assert not passes(detects * (1 + 1e-6))
    assert not passes(-detects * (1 + 1e-6))
    less = detects * (1 - 1e-6)
    assert passes(less) or passes(-less)


# Approximations: m = formula/reference - 1 inside the interval narrowed by U_m.


@pytest.mark.parametrize(
    ("low", "high", "status"),
    [
        pytest.param(-U, 0.5, Status.PASS, id="exactly U_m above the lower end"),
        pytest.param(-U + HAIR, 0.5, Status.FAIL, id="a hair less above the lower end"),
        pytest.param(-0.5, U, Status.PASS, id="exactly U_m below the upper end"),
        pytest.param(-0.5, U - HAIR, Status.FAIL, id="a hair less below the upper end"),
        pytest.param(-U, U, Status.PASS, id="just wide enough"),
        pytest.param(0.1, 0.5, Status.FAIL, id="below the interval"),
        pytest.param(-0.5, -0.1, Status.FAIL, id="above the interval"),
        pytest.param(0.5, -0.5, Status.FAIL, id="no interval at all"),
    ],
)
def test_a_model_error_is_inside_its_interval_by_its_uncertainty(low, high, status):
    # m = 0 and U_m = U/|reference| = 2^-10
    verdict = judge.approximation(4.0, 4.0, U=4 * U, interval=(low, high), demand=INF)
    assert verdict.status is status
    assert verdict.difference == 0.0
    assert verdict.tolerance == 4 * U


def test_an_approximation_without_interval_is_shown_as_measured():
    verdict = judge.approximation(1.03, 1.0, U=0.001, interval=None)
    assert verdict.status is Status.SHOWN
    assert verdict.reason.startswith("measured: +3.00%")
    assert verdict.detects is None


@fixed
@given(
    reference=st.sampled_from([1e-9, -3.0, 7e5]),
    quotient=st.floats(0.5, 2),
    low=st.floats(0.005, 0.1),
    high=st.floats(0.005, 0.1),
    share=st.floats(0, 0.2),
)
def test_detects_of_an_approximation_is_a_relative_change_of_the_formula(
    reference, quotient, low, high, share
):
    """Whether U_m moves with the formula or not changes `detects` by a share of U/|reference|."""
    u = share * min(low, high) / 2  # relative; U_m = u quotient stays well inside the interval
    interval = (quotient - 1 - low, quotient - 1 + high)

    def judged(change):
        return judge.approximation(
            reference * quotient * (1 + change), reference, U=u * abs(reference), demand=INF,
            interval=interval,
        )  # fmt: skip

    assert judged(0.0).status is Status.PASS
    detects = judged(0.0).detects
    margin = 1e-6 + 2 * u
    assert judged(detects * (1 + margin)).status is Status.FAIL
    assert judged(-detects * (1 + margin)).status is Status.FAIL
    less = detects * (1 - margin)
    assert Status.PASS in (judged(less).status, judged(-less).status)


# Facts: held, not held, undecided.


@pytest.mark.parametrize(
    ("margin", "status", "reason"),
    [
        pytest.param(U + HAIR, Status.PASS, "held", id="held"),
        pytest.param(U, Status.FAIL, "undecided", id="exactly U is not held"),
        pytest.param(0.0, Status.FAIL, "undecided", id="undecided"),
        pytest.param(-U, Status.FAIL, "undecided", id="exactly -U is undecided"),
        pytest.param(-U - HAIR, Status.FAIL, "not held", id="not held"),
    ],
)
def test_a_fact_is_held_beyond_its_uncertainty(margin, status, reason):
    verdict = judge.fact(margin, U)
    assert verdict.status is status
    assert verdict.reason.startswith(reason)
    assert (verdict.difference, verdict.tolerance) == (margin, U)


# Balances.


@pytest.mark.parametrize("sign", [1, -1], ids=["above", "below"])
@pytest.mark.parametrize(
    ("residual", "status"),
    [(0.0, Status.PASS), (2.0**-20, Status.PASS), (2.0**-20 + 2.0**-50, Status.FAIL)],
    ids=["none", "exactly the bound", "a hair more"],
)
def test_a_balance_holds_up_to_its_bound_of_the_scale(residual, status, sign):
    verdict = judge.exact(sign * residual, bound=2.0**-22, scale=4.0)
    assert verdict.status is status
    assert verdict.tolerance == 2.0**-20
    assert verdict.detects == 2.0**-22 + residual / 4


# Nothing that is no number passes.


@pytest.mark.parametrize("x", BAD)
@pytest.mark.parametrize(
    "judged",
    [
        pytest.param(lambda x: judge.difference(x, 1.0, U=0.001, scale=1.0), id="value"),
        pytest.param(lambda x: judge.difference(1.0, x, U=0.001, scale=1.0), id="reference"),
        pytest.param(lambda x: judge.difference(1.0, 1.0, U=x, scale=1.0), id="U"),
        pytest.param(
            lambda x: judge.approximation(x, 1.0, U=0.001, interval=(-0.01, 0.01)), id="formula"
        ),
        pytest.param(
            lambda x: judge.approximation(1.0, 1.0, U=x, interval=(-0.01, 0.01)),
            id="U of an approximation",
        ),
        pytest.param(lambda x: judge.approximation(x, 1.0, U=0.001, interval=None), id="shown"),
        pytest.param(lambda x: judge.fact(x, 0.001), id="margin"),
        pytest.param(lambda x: judge.fact(1.0, abs(x)), id="U of a margin"),
        pytest.param(lambda x: judge.exact(x, bound=1e-9, scale=1.0), id="residual"),
        pytest.param(
            lambda x: judge.asymptotic(judge.LimitFit(x, 1e-3, 1.0, 2.0, 0.1), q=2, scale=1.0),
            id="limit",
        ),
        pytest.param(
            lambda x: judge.asymptotic(judge.LimitFit(0.0, 1e-3, 1.0, x, 0.1), q=2, scale=1.0),
            id="exponent",
        ),
    ],
)
def test_what_is_no_number_never_passes(judged, x):
    try:
        verdict = judged(x)
    except ValueError:
        return
    assert verdict.status is Status.FAIL
    assert verdict.reason


# Limits: d = d0 + c eps^q.

EPS = np.geomspace(0.1, 0.01, 6)


def by_hand(eps, *, c, q, u):
    """What errors u of any signs do to d0 and q, by the normal equations of d = d0 + c eps^q."""
    J = np.column_stack([np.ones_like(eps), eps**q, c * eps**q * np.log(eps)])
    return u * np.abs(np.linalg.inv(J.T @ J) @ J.T).sum(axis=1)[[0, 2]]


@pytest.mark.parametrize(("q", "c"), [(0.5, 0.3), (1.0, -7.0), (2.0, 0.3)])
def test_a_limit_gives_its_constants_back(q, c):
    u = 1e-6 * abs(c) * EPS[0] ** q  # relative to the largest difference
    fit = judge.fit_limit(EPS, c * EPS**q, np.full(EPS.shape, u))
    # The fit stops at 1e-8 of its parameters; d0 weighs that with the largest difference.
    assert fit.d0 == pytest.approx(0.0, abs=1e-7 * abs(c) * EPS[0] ** q)
    assert fit.q == pytest.approx(q, rel=1e-6)
    assert fit.c == pytest.approx(c, rel=1e-5)  # q's 1e-6 times ln 0.01
    verdict = judge.asymptotic(fit, q=q, scale=1.0)
    assert verdict.status is Status.PASS
    assert verdict.difference == fit.d0
    assert verdict.tolerance == fit.U0
    assert verdict.detects == pytest.approx(fit.U0 + abs(fit.d0))


@pytest.mark.parametrize(("q", "n", "u"), [(0.5, 4, 1e-3), (1.0, 9, 1e-6), (2.0, 6, 1e-6)])
def test_uncertainties_of_a_limit_are_those_of_least_squares(q, n, u):
    """Smooth differences, as finite elements give them: nothing but the stated u counts."""
    eps = np.geomspace(1.0, 0.1, n)
    fit = judge.fit_limit(eps, 0.3 * eps**q, np.full(n, u))
    expected = tuple(2 * by_hand(eps, c=0.3, q=q, u=u))  # k = 2
    assert (fit.U0, fit.U_q) == pytest.approx(expected, rel=0.01)


def test_a_less_certain_point_counts_less():
    eps = np.geomspace(1.0, 0.1, 5)
    d = 0.3 * eps
    d[-1] += 0.01  # one wrong point that says so itself
    vague = judge.fit_limit(eps, d, [1e-6] * 4 + [0.01])
    assert vague.d0 == pytest.approx(0.0, abs=1e-6)
    assert judge.asymptotic(vague, q=1, scale=1.0).status is Status.PASS


@pytest.mark.parametrize(
    ("fit", "status"),
    [
        pytest.param(judge.LimitFit(U, U, 1.0, 2.0, 0.5), Status.PASS, id="d0 = U0"),
        pytest.param(judge.LimitFit(-U - HAIR, U, 1.0, 2.0, 0.5), Status.FAIL, id="d0 beyond U0"),
        pytest.param(judge.LimitFit(0.0, U, 1.0, 2.5, 0.5), Status.PASS, id="q off by U_q"),
        pytest.param(judge.LimitFit(0.0, U, 1.0, 2.5 + HAIR, 0.5), Status.FAIL, id="q too large"),
        pytest.param(judge.LimitFit(0.0, U, 1.0, 1.5 - HAIR, 0.5), Status.FAIL, id="q too small"),
        pytest.param(judge.LimitFit(0.0, 2.0**-6, 1.0, 2.0, 0.5), Status.FAIL, id="not sharp"),
    ],
)  # fmt: skip
def test_a_limit_passes_up_to_its_uncertainties(fit, status):
    assert judge.asymptotic(fit, q=2, scale=1.0).status is status


def test_a_limit_is_sharp_relative_to_its_scale():
    fit = judge.LimitFit(0.0, 2.0**-6, 1.0, 2.0, 0.5)
    assert judge.asymptotic(fit, q=2, scale=1.0).reason.startswith("not sharp")
    assert judge.asymptotic(fit, q=2, scale=4.0).detects == 2.0**-8
    away = judge.LimitFit(-(2.0**-7), 2.0**-6, 1.0, 2.0, 0.5)  # (U0 + |d0|)/scale
    assert judge.asymptotic(away, q=2, scale=4.0).detects == 3 * 2.0**-9


@pytest.mark.parametrize("u", [0.0, 1e-6])
def test_differences_that_are_all_zero_have_no_exponent(u):
    with pytest.raises(ValueError, match="zero"):
        judge.fit_limit(EPS, np.zeros(6), np.full(6, u))


@pytest.mark.parametrize(
    "eps",
    [
        pytest.param([1.0, 0.3, 0.1], id="three points"),
        pytest.param([1.0, 0.5, 0.2, 0.101], id="less than a decade"),
        pytest.param([1.0, 0.5, 0.1, 0.0], id="the limit itself"),
        pytest.param([1.0, 0.5, 0.1, -0.1], id="negative"),
        pytest.param([1.0, 0.5, 0.1, NAN], id="NaN"),
        pytest.param([INF, 0.5, 0.1, 0.05], id="infinite"),
    ],
)
def test_a_limit_needs_four_points_over_a_decade(eps):
    with pytest.raises(ValueError, match="four points over a decade"):
        judge.fit_limit(eps, [0.1 * abs(x) for x in eps], [1e-6] * len(eps))


# Coefficients: d = c eps^2 + e eps^4.


@pytest.mark.parametrize("c", [0.25, -0.1875])
def test_a_coefficient_is_given_back_with_what_the_points_add_up_to(c):
    """All points off by one u: a line of constants through x^2 and x^4, by the normal equations."""
    eps, u = np.array([0.015, 0.03, 0.06, 0.1, 0.15]), 1e-6
    A = np.column_stack([eps**2, eps**4])
    weights = np.linalg.solve(A.T @ A, A.T)[0]
    found, U = judge.quadratic_coefficient(eps, c * eps**2 + 0.7 * eps**4, np.full(5, u))
    assert found == pytest.approx(c, rel=1e-10)
    assert pytest.approx(2 * u * np.abs(weights).sum(), rel=1e-9) == U
    worst = c * eps**2 + u * np.sign(weights)
    off, _ = judge.quadratic_coefficient(eps, worst, np.full(5, u))
    assert abs(off - c) == pytest.approx(U / 2, rel=1e-6)


def test_a_vague_point_hardly_moves_a_coefficient():
    eps = np.array([0.02, 0.05, 0.1, 0.15])
    d = 0.25 * eps**2
    d[0] += 1e-3
    found, _ = judge.quadratic_coefficient(eps, d, [1e-2, 1e-7, 1e-7, 1e-7])
    assert found == pytest.approx(0.25, rel=1e-6)


@pytest.mark.parametrize(
    ("eps", "d", "u"),
    [
        pytest.param([0.1, 0.2], [0.1, 0.2], [1e-6] * 2, id="two points"),
        pytest.param([0.1, 0.2, 0.3], [0.1, NAN, 0.2], [1e-6] * 3, id="NaN"),
        pytest.param([0.1, 0.2, 0.3], [0.1, 0.2, 0.3], [1e-6, INF, 1e-6], id="did not converge"),
        pytest.param([0.1, 0.2, 0.3], [0.1, 0.2, 0.3], [1e-6, 0.0, 1e-6], id="no uncertainty"),
    ],
)
def test_a_coefficient_needs_three_finite_points(eps, d, u):
    with pytest.raises(ValueError, match="three finite points"):
        judge.quadratic_coefficient(eps, d, u)


@fixed
@given(st.floats(-1, 1), st.floats(0, 1), st.floats(1e-3, 10))
def test_a_balance_detects_what_turns_it_red(share, bound, scale):
    residual = share * bound * scale
    assume(abs(residual) <= bound * scale)
    detects = judge.exact(residual, bound=bound, scale=scale).detects
    more = detects * scale * (1 + 1e-9) + 1e-300
    for change in (more, -more):
        assert judge.exact(residual + change, bound=bound, scale=scale).status is Status.FAIL


def test_the_reason_of_an_approximation_is_in_percent():
    verdict = judge.approximation(1.05, 1.0, U=0.002, interval=(-0.01, 0.01))
    assert verdict.reason == "model error +5.000 % ± 0.2 % is not inside [-1.000 %, +1.000 %]"
    shown = judge.approximation(1.05, 1.0, U=0.002, interval=None)
    assert shown.reason == "measured: +5.00% ± 0.2 %"

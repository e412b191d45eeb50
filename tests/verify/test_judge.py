"""Verdicts at, just inside and just outside every limit.

Limits are set with powers of two, for which sums and quotients carry no round-off: a row at its
limit is exactly at it.
"""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.verify.test_checks import context, power_law
from verify.core.results import Status
from verify.judging import convergence, judge
from verify.judging.checks import Accepted, Approximation
from verify.judging.convergence import fit_order, grid_convergence

fixed = settings(deadline=None, derandomize=True, max_examples=30)

NAN, INF = math.nan, math.inf
U = 2.0**-10
HAIR = 2.0**-40  # 1e-12, far above the round-off of numbers near 1
SIGNS = pytest.mark.parametrize("sign", [1, -1], ids=["above", "below"])


def test_uncertainties_add_in_squares_and_count_twice():
    assert judge.expanded(3.0, 4.0, 12.0) == 26.0  # 2 sqrt(9 + 16 + 144)


# Differences: |d| <= U, and detects = (U + |d|)/scale <= demand.


@SIGNS
@pytest.mark.parametrize(
    ("d", "status"), [(0.0, Status.PASS), (U, Status.PASS), (U + HAIR, Status.FAIL)]
)
def test_a_difference_passes_up_to_its_tolerance(d, status, sign):
    verdict = judge.difference(1.0 + sign * d, 1.0, U=U, scale=1.0)
    assert verdict.status is status
    assert (verdict.difference, verdict.tolerance, verdict.detects) == (sign * d, U, U + d)


@pytest.mark.parametrize(
    ("demand", "status"), [(3 * 2.0**-12, Status.PASS), (3 * 2.0**-12 - HAIR, Status.FAIL)]
)
def test_a_row_that_detects_less_than_demanded_of_its_positive_scale_is_not_sharp(demand, status):
    # U + |d| = (2^-10 + 2^-11) of a scale of 2: 3 2^-12
    verdict = judge.difference(1.0 - U / 2, 1.0, U=U, scale=2.0, demand=demand)
    assert verdict.detects == 3 * 2.0**-12
    assert verdict.status is status
    assert verdict.reason.startswith("insufficient sensitivity") == (status is Status.FAIL)
    for scale in (0.0, -1.0, NAN, INF):
        with pytest.raises(ValueError, match="scale"):
            judge.difference(1.0, 1.0, U=0.001, scale=scale)


@fixed
@given(
    r=st.floats(-10, 10), scale=st.floats(0.1, 10), U=st.floats(1e-6, 0.1), share=st.floats(-1, 1)
)
def test_detects_is_the_smallest_change_of_the_scale_that_certainly_fails_the_row(
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


# Approximations: m = formula/reference - 1 inside the interval narrowed by
# U_m = |formula/reference| U/|reference|.


@pytest.mark.parametrize(
    ("low", "high", "status"),
    [
        (-U, 0.5, Status.PASS), (-0.5, U, Status.PASS), (-U, U, Status.PASS),
        (-U + HAIR, 0.5, Status.FAIL), (-0.5, U - HAIR, Status.FAIL),
        (0.1, 0.5, Status.FAIL), (-0.5, -0.1, Status.FAIL), (0.5, -0.5, Status.FAIL),
    ],
)  # fmt: skip
def test_a_model_error_is_inside_its_interval_by_its_uncertainty(low, high, status):
    # m = 0 and U_m = U/|reference| = 2^-10
    verdict = judge.approximation(4.0, 4.0, U=4 * U, interval=(low, high), demand=INF)
    assert verdict.status is status
    assert (verdict.difference, verdict.tolerance) == (0.0, 4 * U)


@pytest.mark.parametrize(
    ("formula", "reference", "m"), [(1, 1, 0.0), (-1, -1, 0.0), (-1, 1, -2.0), (1, -1, -2.0)]
)
@pytest.mark.parametrize(("half", "status"), [(0.02, Status.PASS), (0.005, Status.FAIL)])
def test_an_interval_is_narrowed_whatever_the_signs(formula, reference, m, half, status):
    interval = (m - half, m + half)
    verdict = judge.approximation(formula, reference, U=0.01, interval=interval, demand=INF)
    assert verdict.status is status


def test_a_formula_of_the_other_sign_is_judged_by_its_size_and_zero_is_refused():
    """R = -1 in [-1.5, -0.5] with u = 0.01: larger by 1.5/1.01 - 1, smaller by 1 - 0.5/0.99."""
    found = judge.approximation(-1.0, 1.0, U=0.01, interval=(-2.5, -1.5), demand=0.6)
    assert found.status is Status.PASS
    assert found.detects == pytest.approx(1 - 0.5 / 0.99)
    sharp = judge.approximation(-1.0, 1.0, U=0.01, interval=(-2.5, -1.5), demand=0.001)
    assert sharp.status is Status.FAIL
    zero = judge.approximation(0.0, 1.0, U=0.01, interval=(-1.5, 0.5))
    assert (zero.status, zero.detects) == (Status.FAIL, None)
    assert zero.reason.startswith("the formula gives zero")


def test_a_reference_decides_as_long_as_it_is_more_than_its_uncertainty_with_a_reason():
    for U, status, reason in (
        (0.75, Status.PASS, ""), (1.0, Status.FAIL, "as large as its value"),
    ):  # fmt: skip
        verdict = judge.approximation(1.0, 1.0, U=U, interval=(-1.0, 1.0), demand=INF)
        assert verdict.status is status
        assert reason in verdict.reason
    verdict = judge.approximation(1.05, 1.0, U=0.002, interval=(-0.01, 0.01))
    assert verdict.reason == "model error +5.000 % ± 0.2 % is not inside [-1.000 %, +1.000 %]"
    shown = judge.approximation(1.05, 1.0, U=0.002, interval=None)  # as measured
    assert (shown.status, shown.detects) == (Status.SHOWN, None)
    assert shown.reason == "measured model error: +5.00 ± 0.2 %"


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


@SIGNS
def test_a_negative_reference_is_a_scale_by_its_size(sign):
    claim = Approximation(
        name="near", symbol="v", unit="1", analytic="f", fem="v", formal=2, source="made up",
        interval=lambda _q, _v: (-0.005, 0.005),
    )  # fmt: skip
    values = [sign * x for x in power_law(2.0, 1e-3)]
    row, _ = claim.rows(context(values, analytic={"f": sign * 2.0}))
    assert (row.status, row.scale) == (Status.PASS, pytest.approx(2.0, rel=1e-4))


# Facts, balances and figures that are accepted


@pytest.mark.parametrize(
    ("margin", "reason"),
    [(U + HAIR, "confirmed"), (U, "undecided"), (-U, "undecided"), (-U - HAIR, "not confirmed")],
)
def test_a_fact_is_held_beyond_its_uncertainty(margin, reason):
    verdict = judge.fact(margin, U)
    assert verdict.status is (Status.PASS if reason == "confirmed" else Status.FAIL)
    assert verdict.reason.startswith(reason)
    assert (verdict.difference, verdict.tolerance) == (margin, U)


@SIGNS
@pytest.mark.parametrize(
    ("residual", "status"),
    [(0.0, Status.PASS), (2.0**-20, Status.PASS), (2.0**-20 + 2.0**-50, Status.FAIL)],
)
def test_a_balance_holds_up_to_its_bound_of_the_scale(residual, status, sign):
    verdict = judge.exact(sign * residual, bound=2.0**-22, scale=4.0)
    assert verdict.status is status
    assert (verdict.tolerance, verdict.detects) == (2.0**-20, 2.0**-22 + residual / 4)


@pytest.mark.parametrize(
    ("margin", "more", "is_paper", "status"),
    [
        (0.1, {}, True, Status.PASS), (-0.1, {}, True, Status.FAIL),
        (0.1, {"fitted": "L is fitted"}, True, Status.CALIBRATED),
        (-0.1, {"fitted": "L is fitted"}, True, Status.FAIL),
        (0.1, {}, False, Status.SHOWN), (-0.1, {}, False, Status.SHOWN),
    ],
)  # fmt: skip
def test_an_acceptance_figure_is_judged_on_the_paper_s_numbers_alone(
    margin, more, is_paper, status
):
    check = Accepted(
        name="near", symbol="m", unit="1", margin=lambda _c: (margin, 1e-6, "by 3 %"), **more
    )
    (row,) = check.rows(context((), sizes=(), is_paper=is_paper))
    assert row.status is status
    assert "by 3 %" in row.reason
    assert row.reason.startswith("by 3 %") == (not is_paper)


def limit(d0=0.0, U0=U, q=2.0, c=1.0):
    return judge.LimitFit(d0, U0, c, q, 0.5)


@pytest.mark.parametrize("x", [NAN, INF])
@pytest.mark.parametrize(
    "judged",
    [
        lambda x: judge.difference(x, 1.0, U=0.001, scale=1.0),
        lambda x: judge.difference(1.0, x, U=0.001, scale=1.0),
        lambda x: judge.difference(1.0, 1.0, U=x, scale=1.0),
        lambda x: judge.approximation(x, 1.0, U=0.001, interval=(-0.01, 0.01)),
        lambda x: judge.approximation(1.0, 1.0, U=x, interval=(-0.01, 0.01)),
        lambda x: judge.approximation(x, 1.0, U=0.001, interval=None),
        lambda x: judge.fact(x, 0.001),
        lambda x: judge.fact(1.0, abs(x)),
        lambda x: judge.exact(x, bound=1e-9, scale=1.0),
        lambda x: judge.asymptotic(limit(d0=x), q=2, scale=1.0),
        lambda x: judge.asymptotic(limit(q=x), q=2, scale=1.0),
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


def jacobian(eps, c, q):
    return np.column_stack([np.ones_like(eps), eps**q, c * eps**q * np.log(eps)])


@pytest.mark.parametrize(("q", "n", "u"), [(0.5, 4, 1e-3), (1.0, 9, 1e-6), (2.0, 6, 1e-6)])
def test_uncertainties_of_a_limit_are_those_of_least_squares(q, n, u):
    """Smooth differences, with errors u of any signs, by the normal equations; k = 2."""
    eps = np.geomspace(1.0, 0.1, n)
    fit = judge.fit_limit(eps, 0.3 * eps**q, np.full(n, u))
    J = jacobian(eps, 0.3, q)
    expected = 2 * u * np.abs(np.linalg.inv(J.T @ J) @ J.T).sum(axis=1)[[0, 2]]
    assert (fit.U0, fit.U_q) == pytest.approx(tuple(expected), rel=0.01)


@pytest.mark.parametrize("n", [4, 5, 7])
def test_scatter_counts_by_the_points_beyond_three(n):
    """Errors a w along w, |w| = 1, that no constants take up: sqrt(a^2/(n - 3)) each, for u."""
    eps, c, a = np.geomspace(1.0, 0.1, n), 0.3, 1e-4
    J = jacobian(eps, c, 1.0)
    w = np.linalg.svd(J.T)[2][-1]  # J^T w = 0
    fit = judge.fit_limit(eps, c * eps + a * w, np.full(n, 1e-7))
    independent = np.sqrt(np.diag(np.linalg.inv(J.T @ J)))[[0, 2]] * a / math.sqrt(n - 3)
    assert (fit.U0, fit.U_q) == pytest.approx(tuple(2 * independent), rel=0.01)


def test_points_count_by_their_uncertainties():
    eps = np.geomspace(1.0, 0.1, 5)
    d = 0.3 * eps
    d[-1] += 0.01  # one wrong point with a large uncertainty
    vague = judge.fit_limit(eps, d, [1e-6] * 4 + [0.01])
    assert vague.d0 == pytest.approx(0.0, abs=1e-6)
    assert judge.asymptotic(vague, q=1, scale=1.0).status is Status.PASS
    # at eps = 0.1 eps^8 is 1e-8; what the vague points further off add is 1e-3 of U0
    eps = np.array([1.0, 0.9, 0.8, 0.7, 0.1])
    fit = judge.fit_limit(eps, 0.3 * eps**8, [1e-3] * 4 + [1e-6])
    assert pytest.approx(2e-6, rel=2e-3) == fit.U0  # k = 2
    # 0.3 eps^2 is exactly zero at one of the points but for what it is uncertain by
    eps = np.array([0.1, 0.05, 0.02, 0.01, 0.005])
    fit = judge.fit_limit(eps, 0.3 * eps**2 * (eps > 0.005), np.full(5, 1e-5))
    assert abs(fit.d0) < fit.U0
    assert fit.q == pytest.approx(2.0, abs=fit.U_q)


@pytest.mark.parametrize(
    ("fit", "status"),
    [
        (limit(d0=U), Status.PASS), (limit(d0=-U - HAIR), Status.FAIL),
        (limit(q=2.5), Status.PASS), (limit(q=2.5 + HAIR), Status.FAIL),
        (limit(q=1.5 - HAIR), Status.FAIL), (limit(U0=2.0**-6), Status.FAIL),
    ],
)  # fmt: skip
def test_a_limit_passes_up_to_its_uncertainties_and_is_sharp_relative_to_its_scale(fit, status):
    assert judge.asymptotic(fit, q=2, scale=1.0).status is status
    assert judge.asymptotic(limit(U0=2.0**-6), q=2, scale=1.0).reason.startswith(
        "insufficient sensitivity"
    )
    away = limit(d0=-(2.0**-7), U0=2.0**-6)  # (U0 + |d0|)/scale
    assert judge.asymptotic(away, q=2, scale=4.0).detects == 3 * 2.0**-9


@pytest.mark.parametrize(
    "eps",
    [
        [1.0, 0.3, 0.1], [1.0, 0.5, 0.2, 0.101], [1.0, 0.5, 0.1, 0.0], [1.0, 0.5, 0.1, -0.1],
        [1.0, 0.5, 0.1, NAN], [INF, 0.5, 0.1, 0.05],
    ],
)  # fmt: skip
def test_a_limit_needs_four_points_over_a_decade_that_are_not_all_zero(eps):
    with pytest.raises(ValueError, match="four points that span a decade"):
        judge.fit_limit(eps, [0.1 * abs(x) for x in eps], [1e-6] * len(eps))
    for u in (0.0, 1e-6):
        with pytest.raises(ValueError, match="zero"):
            judge.fit_limit(EPS, np.zeros(6), np.full(6, u))


@pytest.mark.parametrize(
    ("least", "at"),
    [
        (lambda x: x, 0.05), (lambda x: -x, 10.0),
        # multiples of 0.05 are tried: one of 0.002 to either side is lower there alone
        (lambda x: min(500 * abs(x - 0.5), 1 + abs(x - 9)), 0.5),
        (lambda x: min(500 * abs(x - 3.0), 1 + abs(x - 9)), 3.0),
    ],
)  # fmt: skip
def test_exponents_are_searched_from_a_twentieth_to_ten(least, at):
    assert judge._least(least) == pytest.approx(at, abs=2e-14)


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
    vague = [c * x**2 + 1e-3 * (x < 0.02) for x in eps]  # it hardly moves the coefficient
    found, _ = judge.quadratic_coefficient(eps, vague, [1e-2, 1e-7, 1e-7, 1e-7, 1e-7])
    assert found == pytest.approx(c, rel=1e-6)


@pytest.mark.parametrize(
    ("eps", "d", "u"),
    [
        ([0.1, 0.2], [0.1, 0.2], [1e-6] * 2),
        ([0.1, 0.2, 0.3], [0.1, NAN, 0.2], [1e-6] * 3),
        ([0.1, 0.2, 0.3], [0.1, 0.2, 0.3], [1e-6, INF, 1e-6]),  # did not converge
        ([0.1, 0.2, 0.3], [0.1, 0.2, 0.3], [1e-6, 0.0, 1e-6]),
    ],
)
def test_a_coefficient_needs_three_finite_points(eps, d, u):
    with pytest.raises(ValueError, match="three finite points"):
        judge.quadratic_coefficient(eps, d, u)


# Orders of convergence


@SIGNS
def test_parts_of_an_order_s_uncertainty_are_sizes(sign):
    """Slopes grow or fall towards the limit, and half of what the last is off counts."""
    h, a = (1 / 2, 1 / 4, 1 / 8, 1 / 16), 0.03 * sign
    fit = fit_order(h, [x**2 * (1 + a * x) for x in h])
    assert min(fit.parts) >= 0
    # the slope between h and h/2 is off by log2((1 + a h)/(1 + a h/2)) = a h/(2 ln 2)
    assert fit.parts[1] == pytest.approx(abs(a) * h[2] / (4 * math.log(2)), rel=0.05)


def test_half_an_order_is_one(monkeypatch):
    monkeypatch.setattr(convergence, "observed_order", lambda *_: 0.5)
    found = grid_convergence((1.0, 0.5, 0.25), (1.0, 0.1, 0.0), formal=2.0, scale=1.0)
    assert (found.behaviour, found.order) == ("monotone", 0.5)

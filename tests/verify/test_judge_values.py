"""What judging makes of signs, of uncertain references and of searches, by hand."""

import math

import numpy as np
import pytest

from tests.verify.test_checks import identity
from verify.core.results import Status
from verify.judging import judge

INF = math.inf


def test_one_per_cent_is_what_the_suite_demands():
    assert judge.DEMAND == identity().demand == identity().own_demand == 0.01


# Approximations: U_m = |formula/reference| U/|reference| narrows the interval on either side.


@pytest.mark.parametrize(
    ("formula", "reference", "m"),
    [
        pytest.param(1.0, 1.0, 0.0, id="both positive"),
        pytest.param(-1.0, -1.0, 0.0, id="both negative"),
        pytest.param(-1.0, 1.0, -2.0, id="the formula negative"),
        pytest.param(1.0, -1.0, -2.0, id="the reference negative"),
    ],
)
@pytest.mark.parametrize(("half", "status"), [(0.02, Status.PASS), (0.005, Status.FAIL)])
def test_an_interval_is_narrowed_whatever_the_signs(formula, reference, m, half, status):
    verdict = judge.approximation(
        formula, reference, U=0.01, interval=(m - half, m + half), demand=INF
    )
    assert verdict.status is status


@pytest.mark.parametrize(
    ("U", "status", "reason"),
    [
        pytest.param(0.5, Status.PASS, "", id="by half"),
        pytest.param(0.75, Status.PASS, "", id="by three quarters"),
        pytest.param(1.0, Status.FAIL, "as uncertain as itself", id="by all of it"),
    ],
)
def test_a_reference_decides_as_long_as_it_is_more_than_its_uncertainty(U, status, reason):
    verdict = judge.approximation(1.0, 1.0, U=U, interval=(-1.0, 1.0), demand=INF)
    assert verdict.status is status
    assert reason in verdict.reason


# Limits.


@pytest.mark.parametrize("n", [4, 5, 7])
def test_scatter_counts_by_the_points_beyond_three(n):
    """Errors a w along w, |w| = 1, that no constants take up: sqrt(a^2/(n - 3)) each, for u."""
    eps, c, a = np.geomspace(1.0, 0.1, n), 0.3, 1e-4
    J = np.column_stack([np.ones(n), eps, c * eps * np.log(eps)])
    w = np.linalg.svd(J.T)[2][-1]  # J^T w = 0
    fit = judge.fit_limit(eps, c * eps + a * w, np.full(n, 1e-7))
    independent = np.sqrt(np.diag(np.linalg.inv(J.T @ J)))[[0, 2]] * a / math.sqrt(n - 3)
    assert (fit.U0, fit.U_q) == pytest.approx(tuple(2 * independent), rel=0.01)


def test_a_limit_is_as_uncertain_as_the_only_point_near_it():
    """At eps = 0.1 eps^8 is 1e-8; what the vague points further off add is 1e-3 of U0."""
    eps = np.array([1.0, 0.9, 0.8, 0.7, 0.1])
    fit = judge.fit_limit(eps, 0.3 * eps**8, [1e-3] * 4 + [1e-6])
    assert pytest.approx(2e-6, rel=2e-3) == fit.U0  # k = 2


# The search for an exponent.


@pytest.mark.parametrize(("sign", "end"), [(1, 0.05), (-1, 10.0)])
def test_exponents_are_searched_from_a_twentieth_to_ten(sign, end):
    assert judge._least(lambda x: sign * x) == pytest.approx(end, abs=2e-14)


@pytest.mark.parametrize("q", [0.5, 1.0, 1.5, 2.0, 3.0])
def test_a_narrow_minimum_at_an_exponent_of_theory_is_seen_beside_a_wide_one(q):
    """Multiples of 0.05 are tried, so that one of 0.002 to either side is lower there alone."""
    found = judge._least(lambda x: min(500 * abs(x - q), 1 + abs(x - 9)))
    assert found == pytest.approx(q, abs=2e-14)


def test_a_formula_of_the_other_sign_is_judged_by_its_size():
    """R = -1 in [-1.5, -0.5] with u = 0.01: larger by 1.5/1.01 - 1, smaller by 1 - 0.5/0.99."""
    found = judge.approximation(-1.0, 1.0, U=0.01, interval=(-2.5, -1.5), demand=0.6)
    assert found.status is Status.PASS
    assert found.detects == pytest.approx(1 - 0.5 / 0.99)
    sharp = judge.approximation(-1.0, 1.0, U=0.01, interval=(-2.5, -1.5), demand=0.001)
    assert sharp.status is Status.FAIL


def test_a_formula_that_is_zero_is_refused():
    found = judge.approximation(0.0, 1.0, U=0.01, interval=(-1.5, 0.5))
    assert (found.status, found.detects) == (Status.FAIL, None)
    assert found.reason.startswith("the formula is zero")

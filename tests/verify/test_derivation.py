"""Rows judged again from what they keep: the same numbers, the same verdict, the same words."""

import math
from dataclasses import replace

import pytest

from tests.verify.rows_again import assert_the_same
from verify.core.case import Context, FemResult
from verify.core.results import Status
from verify.judging.checks import Approximation, Fact, Identity, Limit
from verify.judging.explain.steps import derive, steps
from verify.judging.profile_checks import Coefficient

# What no case has: series that oscillate, diverge, are noisy, limits, facts.

SIZES = (1 / 2, 1 / 4, 1 / 8)
ABOUT = {"name": "gap", "symbol": "g", "unit": "µm"}


def context(series, u_it=0.0, sizes=SIZES):
    levels = [
        FemResult(h=h, values={"v": v}, u_it={"v": u_it})
        for h, v in zip(sizes, series, strict=True)
    ]
    return Context("ring-made-up", None, {"g": 5e-6}, levels, is_paper=True)


IDENTITY = Identity(**ABOUT, analytic="g", fem="v", formal=2)
MONOTONE = [5.032e-6, 5.008e-6, 5.002e-6]
SERIES = {
    "monotone": MONOTONE,
    "far from its order": [5.1e-6, 5.01e-6, 5.001e-6],
    "oscillating": [5.01e-6, 4.99e-6, 5.005e-6],
    "slow": [5.03e-6, 5.02e-6, 5.012e-6],
    "diverging": [5.0e-6, 5.01e-6, 5.04e-6],
    "round-off": [5e-6, 5e-6, 5e-6],
    "short": [5.01e-6, 5.0e-6],
    "not a number": [5.1e-6, 5.01e-6, math.nan],
}


@pytest.mark.parametrize("name", SERIES)
@pytest.mark.parametrize(
    "claim",
    [
        IDENTITY,
        Identity(**ABOUT, analytic="g", fem="v"),
        Approximation(
            **ABOUT, analytic="g", fem="v", formal=2, source="made up",
            interval=lambda _q, _v: (-0.01, 0.01),
        ),
        Approximation(**ABOUT, analytic="g", fem="v", interval=None, source="none"),
    ],
    ids=["identity", "no order in theory", "approximation", "no interval"],
)  # fmt: skip
def test_series_of_every_behaviour_are_judged_alike_again(claim, name):
    series = SERIES[name]
    for u_it in (0.0, 1e-9):
        for row in claim.rows(context(series, u_it, SIZES[: len(series)])):
            assert_the_same(row)
            assert steps(row)


def test_a_limit_is_fitted_again():
    eps = [0.01, 0.02, 0.05, 0.1]
    claim = Limit(
        name="limit", symbol="d", unit="1", exponent=2.0,
        points=lambda _c: (eps, [3 * e**2 for e in eps], [1e-6] * 4),
    )  # fmt: skip
    (row,) = claim.rows(context(MONOTONE))
    assert row.status is Status.PASS
    assert_the_same(row)
    assert "q = 2.0000" in dict(steps(row))["fit"]


@pytest.mark.parametrize(("theory", "status"), [(3.0, Status.PASS), (3.1, Status.FAIL)])
def test_a_coefficient_is_fitted_again(theory, status):
    eps = [0.02, 0.05, 0.1]
    claim = Coefficient(
        name="coefficient", symbol="c", unit="1", theory=theory,
        points=lambda _c: (eps, [3 * e**2 - 2 * e**4 for e in eps], [1e-6] * 3),
    )  # fmt: skip
    (row,) = claim.rows(context(MONOTONE))
    assert row.status is status
    assert_the_same(row)
    assert "c = +3.00000" in dict(steps(row))["fit"]


@pytest.mark.parametrize(("margin", "word"), [(2e-6, "holds"), (1e-7, "does not hold")])
def test_a_fact_says_its_margin(margin, word):
    (row,) = Fact(**ABOUT, margin=lambda _c: (margin, 1e-6)).rows(context(MONOTONE))
    assert_the_same(row)
    assert dict(steps(row))["test"].endswith(word)


def test_the_index_has_its_numbers_put_in():
    """By hand: p = log2(24/6) = 2, GCI = 1.25 0.006/(4 - 1) = 0.0025 µm, U = 2 GCI/2."""
    row, _ = IDENTITY.rows(context(MONOTONE))
    said = dict(steps(row))
    assert said["GCI"] == "F |v1 − v2|/(r^p − 1) = 1.25 × 0.006/(2^2.0000 − 1) = 0.0025 µm"
    assert said["u_num"] == "√((GCI/2)² + u_it²) = √((0.0025/2)² + 0²) = 0.00125 µm"
    assert said["U"].endswith("= 2 √(0.00125² + 0² + 0²) = 0.0025 µm")
    assert said["test"] == "|d| ≤ U, that is 0.002 ≤ 0.0025: holds"
    assert said["detects"].startswith("(U + |d|)/scale = (0.0025 + 0.002)/5 = 0.090 %")


def test_an_order_far_from_theory_takes_the_larger_factor():
    """By hand: p = log2(0.09/0.009) = 3.32 against 2, so 3 0.009/(2^2 - 1) = 0.009 µm."""
    row, _ = IDENTITY.rows(context(SERIES["far from its order"]))
    said = dict(steps(row))
    assert said["F"] == "3: observed and theory are 1.3 apart, beyond 0.5"
    assert said["GCI"] == "F |v1 − v2|/(r^p − 1) = 3 × 0.009/(2^2.0000 − 1) = 0.009 µm"


def test_a_row_without_a_result_keeps_its_verdict():
    row = replace(
        IDENTITY.skipped("ring-made-up", "quick")[0],
        status=Status.FAIL, reason="level 2: MemoryError",
    )  # fmt: skip
    assert derive(row).verdict.status is Status.FAIL
    assert steps(row) == (("verdict", "FAIL: level 2: MemoryError"),)

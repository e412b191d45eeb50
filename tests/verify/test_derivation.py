"""Rows judged again from what they hold: the same numbers, the same verdict, the same words."""

import math
from dataclasses import replace

import pytest

from tests.verify.rows_again import assert_the_same
from tests.verify.test_checks import approximation, identity, limit, rows_of
from verify.core.results import Status
from verify.judging.checks import Fact
from verify.judging.explain.steps import derive, steps
from verify.judging.profile_checks import Coefficient

MONOTONE = [5.032e-6, 5.008e-6, 5.002e-6]
FAR = [5.1e-6, 5.01e-6, 5.001e-6]
SERIES = {
    "monotone": MONOTONE,
    "far from its order": FAR,
    "oscillating": [5.01e-6, 4.99e-6, 5.005e-6],
    "slow": [5.03e-6, 5.02e-6, 5.012e-6],
    "diverging": [5.0e-6, 5.01e-6, 5.04e-6],
    "round-off": [5e-6, 5e-6, 5e-6],
    "short": [5.01e-6, 5.0e-6],
    "not a number": [5.1e-6, 5.01e-6, math.nan],
}
VALUES = {"g": 5e-6, "k": 5e-6}


@pytest.mark.parametrize("name", SERIES)
def test_series_of_every_behaviour_are_judged_alike_again(name):
    series = SERIES[name]
    claims = (identity(), identity(formal=None), approximation(None),
              approximation(lambda _q, _v: (-0.01, 0.01)))  # fmt: skip
    for claim in claims:
        for u_it in (0.0, 1e-9):
            for row in rows_of(claim, series, analytic=VALUES, u_it=u_it):
                assert_the_same(row)
                assert steps(row)


def test_fits_and_facts_are_judged_alike_again_and_say_their_numbers():
    eps = [0.01, 0.02, 0.05, 0.1]
    square = limit(lambda _c: (eps, [3 * e**2 for e in eps], [1e-6] * 4), 2.0)
    curved = Coefficient(
        name="coefficient", symbol="c", unit="1", theory=3.0,
        points=lambda _c: (eps, [3 * e**2 - 2 * e**4 for e in eps], [1e-6] * 4),
    )  # fmt: skip
    held = Fact(name="fact", symbol="m", unit="µm", margin=lambda _c: (2e-6, 1e-6))
    undecided = replace(held, margin=lambda _c: (1e-7, 1e-6))
    for claim, status, label, words in (
        (square, Status.PASS, "fit", "q = 2.0000"),
        (curved, Status.PASS, "fit", "c = +3.00000"),
        (replace(curved, theory=3.1), Status.FAIL, "fit", "c = +3.00000"),
        (held, Status.PASS, "test", "holds"),
        (undecided, Status.FAIL, "test", "does not hold"),
    ):
        (row,) = rows_of(claim)
        assert row.status is status
        assert_the_same(row)
        assert words in dict(steps(row))[label]


def test_the_index_has_its_numbers_put_in():
    """By hand: p = log2(24/6) = 2, GCI = 1.25 0.006/(4 - 1) = 0.0025 µm, U = 2 GCI/2."""
    row, _ = rows_of(identity(), MONOTONE, analytic=VALUES)
    said = dict(steps(row))
    assert said["GCI"] == "F |v1 − v2|/(r^p − 1) = 1.25 × 0.006/(2^2.0000 − 1) = 0.0025 µm"
    assert said["u_num"] == "√((GCI/2)² + u_it²) = √((0.0025/2)² + 0²) = 0.00125 µm"
    assert said["U"].endswith("= 2 √(0.00125² + 0² + 0²) = 0.0025 µm")
    assert said["test"] == "|d| ≤ U, that is 0.002 ≤ 0.0025: holds"
    assert said["detects"].startswith("(U + |d|)/scale = (0.0025 + 0.002)/5 = 0.090 %")
    # p = log2(0.09/0.009) = 3.32 against 2 takes the larger factor: 3 0.009/(2^2 - 1) = 0.009 µm
    row, _ = rows_of(identity(), FAR, analytic=VALUES)
    said = dict(steps(row))
    assert said["F"] == "3: observed and theory are 1.3 apart, beyond 0.5"
    assert said["GCI"] == "F |v1 − v2|/(r^p − 1) = 3 × 0.009/(2^2.0000 − 1) = 0.009 µm"


def test_a_row_without_a_result_has_its_verdict_alone():
    skipped, _ = identity().skipped("ring-made-up", "quick")
    row = replace(skipped, status=Status.FAIL, reason="level 2: MemoryError")
    assert derive(row).verdict.status is Status.FAIL
    assert steps(row) == (("verdict", "FAIL: level 2: MemoryError"),)

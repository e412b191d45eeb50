"""Rows of two values within a tolerance stated beforehand, made by hand."""

import math

import numpy as np
import pytest

from tests.verify.test_checks import context
from verify.core.results import Kind, Status
from verify.judging.claims import rows_of
from verify.judging.tolerance_checks import (
    SUBJECT,
    Agreement,
    Deviation,
    Pair,
    demanded,
    farthest,
)

WORDS = "off by so much"


def agreement(value, reference=2.0, U=0.0, allowed=None, **more):
    about = {"name": "gap", "symbol": "g", "unit": "mm", "accepted": 0.002, "source": SUBJECT}
    return Agreement(**(about | more), pair=lambda _c: Pair(value, reference, U, WORDS, allowed))


def deviation(size, U=0.0, **more):
    about = {"name": "field", "symbol": "e", "unit": "1", "accepted": 0.002, "source": SUBJECT}
    return Deviation(**(about | more), whole="largest", size=lambda _c: (size, U, WORDS))


def row_of(check, **more):
    (row,) = check.rows(context([1.0, 1.0, 1.0], **more))
    return row


def test_an_agreement_is_an_approximation_with_a_detection_limit():
    row = row_of(agreement(2.002))
    assert (row.kind, row.status) == (Kind.APPROXIMATION, Status.PASS)
    assert (row.analytic, row.fem) == pytest.approx((2002, 2000), rel=1e-14)  # in the row's unit
    assert (row.interval, row.reason, row.demand) == ((-0.002, 0.002), WORDS, 0.01)
    assert row.detects == pytest.approx(1 - 0.998 / 1.001)  # down, across all of the interval
    # a figure of another quantity states what it leaves
    other = row_of(agreement(2.002, accepted=0.01, allowed=(-0.0001, 0.003)))
    assert (other.status, other.interval) == (Status.PASS, (-0.0001, 0.003))
    # another method's value is the partner's
    row = row_of(agreement(2.001, by="steps", fem_needed=False))
    assert (row.fem, row.by, row.reference) == (None, "steps", 2000.0)
    assert agreement(2.0, fem_needed=False).needs_fem is False


def test_a_deviation_is_an_identity_with_zero():
    row = row_of(deviation(0.0005, U=0.0001))
    assert (row.kind, row.status) == (Kind.IDENTITY, Status.PASS)
    assert (row.analytic, row.fem, row.scale) == (0.0, 0.0005, 1.0)
    assert row.tolerance == pytest.approx(0.0019)
    assert row.detects == pytest.approx(0.0024)


@pytest.mark.parametrize(
    "check",
    [
        agreement(2 * 1.0021), agreement(2 * 0.9979), deviation(0.0021),  # beyond the figure
        agreement(2 * 1.0019, U=2 * 0.0002), deviation(0.0019, U=0.0002),  # or not surely within
        agreement(math.nan), agreement(2.0, math.nan), deviation(math.nan),
    ],
)  # fmt: skip
def test_what_is_not_surely_within_its_figure_fails(check):
    row = row_of(check)
    assert row.status is Status.FAIL
    assert row.reason.endswith(WORDS)


def test_a_figure_wider_than_half_of_the_suite_s_demand_needs_a_stated_demand():
    assert (demanded(0.005), demanded(0.02)["demand"]) == ({}, 0.04)
    row = row_of(agreement(2.03, accepted=0.02, **demanded(0.02)))
    assert row.status is Status.PASS
    assert row.detects == pytest.approx(1 - 0.98 / 1.015)
    assert "insufficient sensitivity" in row_of(agreement(2.03, accepted=0.02)).reason


@pytest.mark.parametrize("make", [agreement, deviation])
def test_user_inputs_are_judged_only_where_the_figure_holds_for_any(make):
    own = row_of(make(0.5), is_paper=False)
    expected = (Kind.FACT, Status.SHOWN, WORDS)
    assert (own.kind, own.status, own.reason) == expected
    assert row_of(make(0.5, everywhere=True), is_paper=False).status is Status.FAIL
    assert rows_of(make(0.5, paper_only=True), context([1.0] * 3, is_paper=False)) == []


def test_the_farthest_of_many_pairs_is_the_one_that_is_judged():
    found = farthest(np.array([[1.0, 2.0], [3.0, 3.9]]), np.array([[1.0, 2.01], [3.0, 4.0]]), 0.01)
    assert (found.value, found.reference, found.U) == (3.9, 4.0, 0.04)
    assert found.words == "largest error -0.025, among 4 compared values"

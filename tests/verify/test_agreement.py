"""Rows of two values within a figure stated beforehand, made by hand."""

import math

import numpy as np
import pytest

from tests.verify.test_checks import context
from verify.core.results import Kind, Status
from verify.judging.claims import rows_of
from verify.judging.explain.steps import derive, steps
from verify.judging.tolerance_checks import (
    SUBJECT,
    Agreement,
    Deviation,
    Pair,
    demanded,
    farthest,
)


def agreement(value, reference=2.0, U=0.0, **more):
    told = {"name": "gap", "symbol": "g", "unit": "mm", "accepted": 0.002, "source": SUBJECT}
    return Agreement(**(told | more), pair=lambda _c: Pair(value, reference, U, "off by so much"))


def deviation(size, U=0.0, **more):
    told = {"name": "field", "symbol": "e", "unit": "1", "accepted": 0.002, "source": SUBJECT}
    told |= {"whole": "largest"}
    return Deviation(**(told | more), size=lambda _c: (size, U, "off by so much"))


def row_of(check, **more):
    (row,) = check.rows(context([1.0, 1.0, 1.0], **more))
    return row


def test_an_agreement_is_an_approximation_that_says_what_it_detects():
    row = row_of(agreement(2.002))
    assert (row.kind, row.status) == (Kind.APPROXIMATION, Status.PASS)
    assert (row.analytic, row.fem) == pytest.approx((2002, 2000), rel=1e-14)  # in the row's unit
    assert row.interval == (-0.002, 0.002)
    assert row.reason == "off by so much"
    assert row.detects == pytest.approx(1 - 0.998 / 1.001)  # down, across all of the interval
    assert row.demand == 0.01


@pytest.mark.parametrize("sign", [1, -1])
def test_it_is_red_beyond_its_figure_and_within_its_uncertainty_of_it(sign):
    assert row_of(agreement(2 * (1 + sign * 0.0019))).status is Status.PASS
    assert row_of(agreement(2 * (1 + sign * 0.0021))).status is Status.FAIL
    unsure = row_of(agreement(2 * (1 + sign * 0.0019), U=2 * 0.0002))
    assert unsure.status is Status.FAIL
    assert unsure.reason.endswith("off by so much")


def test_what_is_no_number_is_red():
    assert row_of(agreement(math.nan)).status is Status.FAIL
    assert row_of(agreement(2.0, math.nan)).status is Status.FAIL
    assert row_of(deviation(math.nan)).status is Status.FAIL


def test_a_figure_of_something_else_says_what_it_leaves():
    def pair(_context):
        return Pair(2.002, 2.0, 0.0, "off", (-0.0001, 0.003))

    row = row_of(
        Agreement(name="t", symbol="t", unit="s", accepted=0.01, pair=pair, source=SUBJECT)
    )
    assert row.status is Status.PASS
    assert row.interval == (-0.0001, 0.003)


def test_a_figure_wider_than_half_of_the_suite_s_demand_asks_for_its_own():
    assert demanded(0.005) == {}
    assert demanded(0.02)["demand"] == 0.04
    row = row_of(agreement(2.03, accepted=0.02, **demanded(0.02)))
    assert row.status is Status.PASS
    assert row.detects == pytest.approx(1 - 0.98 / 1.015)
    blunt = row_of(agreement(2.03, accepted=0.02))
    assert blunt.status is Status.FAIL
    assert "not sharp" in blunt.reason


def test_a_deviation_is_an_identity_with_zero():
    row = row_of(deviation(0.0005, U=0.0001))
    assert (row.kind, row.status) == (Kind.IDENTITY, Status.PASS)
    assert (row.analytic, row.fem, row.scale) == (0.0, 0.0005, 1.0)
    assert row.tolerance == pytest.approx(0.0019)
    assert row.detects == pytest.approx(0.0024)
    assert row_of(deviation(0.0021)).status is Status.FAIL
    assert row_of(deviation(0.0019, U=0.0002)).status is Status.FAIL


@pytest.mark.parametrize("make", [agreement, deviation])
def test_a_user_s_own_numbers_are_judged_only_where_the_figure_holds_for_any(make):
    own = row_of(make(0.5), is_paper=False)
    assert (own.kind, own.status, own.reason) == (
        Kind.FACT,
        Status.SHOWN,
        "measured: off by so much",
    )
    assert row_of(make(0.5, everywhere=True), is_paper=False).status is Status.FAIL


@pytest.mark.parametrize(
    "check", [agreement(2.0, paper_only=True), deviation(0.0, paper_only=True)]
)
def test_what_speaks_of_the_paper_alone_has_no_row_of_one_s_own(check):
    where = context([1.0, 1.0, 1.0], is_paper=False)
    assert check.paper_only
    assert rows_of(check, where) == []
    assert row_of(check).status is Status.PASS


def test_another_method_s_value_stands_as_the_partner_s():
    row = row_of(agreement(2.001, by="steps"))
    assert row.fem is None
    assert (row.by, row.reference) == ("steps", 2000.0)
    assert agreement(2.0, fem_needed=False).needs_fem is False


def test_the_farthest_of_many_pairs_is_the_one_that_is_judged():
    found = farthest(np.array([[1.0, 2.0], [3.0, 3.9]]), np.array([[1.0, 2.01], [3.0, 4.0]]), 0.01)
    assert (found.value, found.reference, found.U) == (3.9, 4.0, 0.04)
    assert found.words == "off by -0.025 at most of 4"


@pytest.mark.parametrize(
    "check", [agreement(2.001, U=1e-4), agreement(2.01), deviation(5e-4, U=1e-4), deviation(0.01)]
)
def test_rows_follow_from_what_they_keep(check):
    row = row_of(check)
    again = derive(row).verdict
    assert again.status is row.status
    assert again.detects == pytest.approx(row.detects) if row.detects else again.detects is None
    labels = [label for label, _ in steps(row)]
    assert labels[-1] == "verdict"
    assert "test" in labels

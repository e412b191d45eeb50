"""Differences as a user reads them: one sign, one unit, and inside what is allowed."""

import math

import pytest

from verify.cases.registry import find
from verify.core.differences import difference, difference_texts, largest, significant
from verify.core.results import Kind, Status
from verify.judging import judge
from verify.judging.claims import make_row
from verify.judging.explain.steps import steps


def approximation(formula, reference, interval):
    verdict = judge.approximation(formula, reference, U=1e-4, interval=interval, demand=0.1)
    return make_row(
        "case", Kind.APPROXIMATION, verdict, "row", "x", "1", analytic=formula, fem=reference,
        scale=abs(reference), interval=interval, interval_source="theory",
    )  # fmt: skip


def identity(formula, reference, scale, scale_name="", U=0.02):
    verdict = judge.difference(reference, formula, U=U, scale=scale, demand=0.1)
    return make_row(
        "case", Kind.IDENTITY, verdict, "row", "x", "1", analytic=formula, fem=reference,
        scale=scale, scale_name=scale_name,
    )  # fmt: skip


@pytest.mark.parametrize("sign", [1, -1])
def test_the_formula_of_the_larger_magnitude_is_positive_also_below_zero(sign):
    row = approximation(1.03 * sign, sign, (0.028, 0.031))
    assert row.status is Status.PASS
    assert difference_texts(row) == ("+3.0 %", "+2.8 % to +3.1 %")
    explained = dict(steps(row))
    assert explained["m"].startswith("formula/FE − 1 = +3.0000 %")
    assert explained["expected"].startswith("+2.8000 % to +3.1000 %")
    assert difference_texts(identity(0.99 * sign, sign, 0.99))[0] == "-1.0 %"


def test_a_scale_is_named_unless_it_is_the_formula_itself():
    assert difference_texts(identity(-0.99, -1.0, 10.0, "load")) == ("+0.10 % of load", "±0.20 %")
    assert difference_texts(identity(-1.01, -1.0, 1.01, "load"))[0] == "+1.0 %"


def test_limits_have_the_digits_that_tell_on_which_side_a_difference_lies():
    text, allowed = difference_texts(identity(1.0100004, 1.0, 1.0100004, U=0.01))
    assert float(text.removesuffix(" %")) > float(allowed.strip("± %"))


def test_what_is_not_judged_allows_nothing():
    row = approximation(0.7, 1.0, None)
    assert row.status is Status.SHOWN
    assert difference_texts(row) == ("-30 %", "")


def test_balances_orders_and_facts_have_no_per_cent(judged):
    by_kind = {row.kind: row for row in judged(find("ring-lame"), drawn=False).rows}
    assert not any("%" in text for text in difference_texts(by_kind[Kind.EXACT]))
    assert not any("%" in text for text in difference_texts(by_kind[Kind.TREND]))
    assert difference(by_kind[Kind.FACT]) is None
    assert difference(identity(math.nan, 1.0, 1.0)) is None


def test_the_largest_difference_is_taken_over_rows_that_are_not_judged_too():
    judged_row, not_judged = identity(1.01, 1.0, 1.01), approximation(0.7, 1.0, None)
    assert largest([judged_row, not_judged]) is not_judged
    assert largest([]) is None


@pytest.mark.parametrize(
    ("value", "text"),
    [(2.0, "2.0"), (259.3, "259"), (1.25e-8, "1.2e-8"), (0.0, "0"), (1e7, "1.0e7")],
)
def test_numbers_have_two_significant_digits(value, text):
    assert significant(value, 2) == text

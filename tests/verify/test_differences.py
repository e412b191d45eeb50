"""Differences as a user reads them: one sign, one unit, and inside what is allowed."""

import math

import pytest

from verify.cases.registry import CASES
from verify.core.differences import difference, difference_texts, largest, percent, significant
from verify.core.results import Kind, Status
from verify.judging import judge
from verify.judging.claims import make_row
from verify.judging.explain.steps import steps

EACH = pytest.mark.parametrize(
    "case", [pytest.param(c, id=c.id, marks=pytest.mark.xdist_group(c.id)) for c in CASES]
)


def approximation(formula, reference, interval, U=1e-4):
    verdict = judge.approximation(formula, reference, U=U, interval=interval, demand=0.1)
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


def shown(text):
    """The number of a difference as it is displayed."""
    return float(text.partition(" of ")[0].removeprefix("±").removesuffix(" %"))


def test_the_formula_of_the_larger_magnitude_is_positive_also_below_zero():
    row = approximation(-1.03, -1.00, (0.028, 0.031))
    assert row.status is Status.PASS
    text, allowed = difference_texts(row)
    assert text == "+3.0 %"
    low, high = map(shown, allowed.split(" to "))
    assert low < shown(text) < high
    assert difference_texts(approximation(1.03, 1.00, (0.028, 0.031))) == (text, allowed)


@pytest.mark.parametrize(
    ("formula", "reference", "text"),
    [(1.01, 1.0, "+1.0 %"), (0.99, 1.0, "-1.0 %"), (-1.01, -1.0, "+1.0 %"), (-0.99, -1.0, "-1.0 %"),
     (1.0, 1.0, "0 %")],
)  # fmt: skip
def test_identities_have_the_sign_of_the_magnitude(formula, reference, text):
    row = identity(formula, reference, abs(formula))
    assert difference_texts(row)[0] == text


def test_another_scale_is_named_and_the_sign_is_that_of_the_values():
    row = identity(-0.99, -1.0, 10.0, "load")
    assert difference_texts(row) == ("+0.10 % of load", "±0.20 %")


def test_a_scale_that_is_the_formula_itself_is_not_named():
    assert difference_texts(identity(-1.01, -1.0, 1.01, "load"))[0] == "+1.0 %"


def test_ends_have_the_digits_that_show_on_which_side_a_difference_lies():
    text, allowed = difference_texts(identity(1.0100004, 1.0, 1.0100004, U=0.01))
    assert shown(text) > shown(allowed)


def test_what_is_not_judged_allows_nothing():
    row = approximation(0.7, 1.0, None)
    assert row.status is Status.SHOWN
    assert difference_texts(row) == ("-30 %", "")


def test_balances_and_orders_are_no_percents(of_paper):
    rows = [r for r in of_paper(CASES[0]).rows if r.kind in (Kind.EXACT, Kind.TREND)]
    assert {r.kind for r in rows} == {Kind.EXACT, Kind.TREND}
    assert not any("%" in text for row in rows for text in difference_texts(row))


def test_facts_have_no_difference(of_paper):
    assert {difference(r) for r in of_paper(CASES[0]).rows if r.kind is Kind.FACT} == {None}


@EACH
def test_what_passes_lies_inside_what_is_displayed(case, of_paper):
    for row in of_paper(case).rows:
        text, allowed = difference_texts(row)
        if row.status is not Status.PASS or row.kind is Kind.FACT:
            continue
        if row.interval is None:
            assert abs(shown(text)) <= shown(allowed), row.id
        else:
            low, high = map(shown, allowed.split(" to "))
            assert low <= shown(text) <= high, row.id
            assert difference(row).value == pytest.approx(row.analytic / row.reference - 1,
                                                          abs=1e-12), row.id  # fmt: skip


@EACH
def test_the_largest_is_taken_over_rows_that_are_not_judged_too(case, of_paper):
    rows = of_paper(case).rows
    sizes = [
        abs(row.analytic - row.reference) / (row.scale if row.scale_name else abs(row.reference))
        for row in rows
        if row.kind in (Kind.IDENTITY, Kind.APPROXIMATION) and row.reference
    ]
    found = largest(rows)
    assert (found is None) == (not sizes)
    if found is not None:
        assert abs(difference(found).value) >= max(sizes) * (1 - 1e-3)


def test_explain_has_the_same_sign_and_unit_as_the_table():
    negative = approximation(-1.03, -1.00, (0.028, 0.031))
    told = dict(steps(negative))
    assert told["m"].startswith("formula/FE − 1 = +3.0000 %")
    assert told["expected"].startswith("+2.8000 % to +3.1000 %")


@pytest.mark.parametrize(
    ("value", "text"),
    [(2.0, "2.0"), (10.0, "10"), (259.3, "259"), (1.25e-8, "1.2e-8"), (0.0, "0"), (-0.5, "-0.50"),
     (1e7, "1.0e7")],
)  # fmt: skip
def test_numbers_have_two_significant_digits(value, text):
    assert significant(value, 2) == text


def test_percents_of_nothing_are_finite():
    assert percent(0.0123) == "1.2 %"
    assert difference(identity(math.nan, 1.0, 1.0)) is None

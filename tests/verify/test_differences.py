"""Differences as a user reads them: one sign, one unit, and inside what is allowed."""

import math

import pytest

from verify.cases.registry import find
from verify.core.differences import difference, difference_texts, largest, significant
from verify.core.results import Kind, Status
from verify.judging import judge
from verify.judging.claims import make_row
from verify.judging.explain.steps import steps


def made(kind, verdict, formula, reference, scale, **more):
    return make_row(
        "case", kind, verdict, "row", "x", "1", analytic=formula, fem=reference, scale=scale, **more
    )


def approximation(formula, reference, interval):
    verdict = judge.approximation(formula, reference, U=1e-4, interval=interval, demand=0.1)
    return made(
        Kind.APPROXIMATION, verdict, formula, reference, abs(reference), interval=interval,
        interval_source="theory",
    )  # fmt: skip


def identity(formula, reference, scale, scale_name="", U=0.02):
    verdict = judge.difference(reference, formula, U=U, scale=scale, demand=0.1)
    return made(Kind.IDENTITY, verdict, formula, reference, scale, scale_name=scale_name)


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


def test_numbers_have_the_digits_that_show_on_which_side_of_a_limit_a_difference_lies():
    text, allowed = difference_texts(identity(1.0100004, 1.0, 1.0100004, U=0.01))
    assert float(text.removesuffix(" %")) > float(allowed.strip("± %"))
    numbers = {2.0: "2.0", 259.3: "259", 1.25e-8: "1.2e-8", 0.0: "0", 1e7: "1.0e7"}
    assert {value: significant(value, 2) for value in numbers} == numbers


def test_balances_orders_and_facts_have_no_per_cent(judged):
    by_kind = {row.kind: row for row in judged(find("ring-lame"), drawn=False).rows}
    assert not any("%" in text for text in difference_texts(by_kind[Kind.EXACT]))
    assert not any("%" in text for text in difference_texts(by_kind[Kind.TREND]))
    assert difference(by_kind[Kind.FACT]) is None
    assert difference(identity(math.nan, 1.0, 1.0)) is None


def test_the_largest_difference_is_taken_over_rows_that_are_not_judged_too():
    not_judged = approximation(0.7, 1.0, None)
    assert (not_judged.status, difference_texts(not_judged)) == (Status.SHOWN, ("-30 %", ""))
    assert largest([identity(1.01, 1.0, 1.01), not_judged]) is not_judged
    assert largest([]) is None

"""Rows in the form for users: differences, columns on the terminal and closing sentences."""

import math
from dataclasses import replace

import pytest

from verify.cases.registry import find
from verify.core.console_rows import closing, row_cells, title
from verify.core.differences import difference, difference_texts, largest, significant
from verify.core.references import reference_name
from verify.core.results import Kind, Partner, Status
from verify.judging import judge
from verify.judging.claims import make_row
from verify.judging.explain.steps import steps


def approximation(formula, reference, interval, *, name="row", by=""):
    verdict = judge.approximation(formula, reference, U=1e-4, interval=interval, demand=0.1)
    other = {"partner": Partner(by=by, value=reference)} if by else {"fem": reference}
    return make_row(
        "ring-lame", Kind.APPROXIMATION, verdict, name, "x", "1", analytic=formula,
        scale=abs(reference), interval=interval, interval_source="theory", **other,
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


def test_numbers_have_the_digits_that_show_on_which_side_of_a_limit_a_difference_lies():
    text, allowed = difference_texts(identity(1.0100004, 1.0, 1.0100004, U=0.01))
    assert float(text.removesuffix(" %")) > float(allowed.strip("± %"))
    numbers = {2.0: "2.0", 259.3: "259", 1.25e-8: "1.2e-8", 0.0: "0", 1e7: "1.0e7"}
    assert {value: significant(value, 2) for value in numbers} == numbers


def test_balances_orders_and_facts_have_no_per_cent(judged):
    by_kind = {row.kind: row for row in judged(find("ring-lame"), drawn=False).rows}
    for kind in (Kind.EXACT, Kind.TREND):
        assert not any("%" in text for text in difference_texts(by_kind[kind]))
    assert difference(by_kind[Kind.FACT]) is None
    assert difference(identity(math.nan, 1.0, 1.0)) is None


def test_the_largest_difference_is_taken_over_rows_that_are_not_judged_too():
    not_judged = approximation(0.7, 1.0, None)
    assert (not_judged.status, difference_texts(not_judged)) == (Status.SHOWN, ("-30 %", ""))
    assert largest([identity(1.01, 1.0, 1.01), not_judged]) is not_judged
    assert largest([]) is None


# Rows on the terminal


def row(name, formula, interval=(0.0, 0.02), by=""):
    return approximation(formula, 1.0, interval, name=name, by=by)


ROWS = [row("judged", 1.01), row("printed form", 0.7, None)]  # 30 % off and not judged


def test_the_closing_sentences_name_the_largest_of_all_rows():
    passed, apart, limit, unjudged = closing(ROWS)
    assert passed == "1 of 2 comparisons pass"
    assert apart == (
        "largest difference of all comparisons: -30 % (printed form; reference: finite "
        "elements; SHOWN, not judged)"
    )
    assert limit == "detection limit of the judged rows: 0.98 %"
    assert unjudged == "not judged: 1 SHOWN (printed form: -30 %)"
    # of many that are not judged the largest are named
    many = [row(f"row {i}", 1 + 0.01 * i, None) for i in range(1, 9)]
    (*_, last) = closing([ROWS[0], *many])
    assert last.startswith("not judged: 8 SHOWN (row 8: +8.0 %; row 7: +7.0 %; ")
    assert last.endswith("; row 4: +4.0 %; and 3 more)")
    # rows that failed count for the largest
    words = "+100 % (broken; reference: finite elements; expected 0 % to +2.0 %)"
    assert words in closing([*ROWS, row("broken", 2.0)])[1]


def test_a_column_headed_fe_holds_finite_elements_only():
    assert row_cells(ROWS)[0][3] == "FE"
    head, _, _, strips = row_cells([*ROWS, row("by strips", 1.01, by="strips")])
    assert "FE" not in head
    assert head[3:5] == ("reference", "by")
    assert strips[4] == "strips"
    # a case without finite elements names its method
    one = replace(row("balance", 1.01), case="contact-roller", method="half-space")
    head, line = row_cells([one])
    assert "FE" not in (*head, *line)
    assert title([one]) == "formulas against half-space"
    assert reference_name(replace(one, quantity="pressure, plane finite elements")) == "FE"
    # finite elements come first and printed numbers last in the title
    others = [row(by, 1.01, by=by) for by in ("printed 0.6", "printed 0.7", "strips")]
    assert title([*others, *ROWS]) == "formulas against finite elements; strips; printed values"

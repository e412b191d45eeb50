"""What a misprint changes by itself, beside the error of a formula."""

import pytest

from verify.core.verdicts import Safe, Verdict
from verify.verdicts import found
from verify.verdicts.declared import Formula, declared, rows_of_corrected
from verify.verdicts.misprint import misprint

PRINTED, RIGHT = "ring-lame/printed", "ring-lame/right"


def verdict(*rows):
    formula = Formula(equation=6, what="x", safe=Safe.ABOVE, safe_reason="a margin",
                      part=(PRINTED,), errata=("eq-9-centrifugal",))  # fmt: skip
    known = {one.id: one for one in rows}
    return found._verdict("huang2018", "Huang 2018", formula, known, (RIGHT,))


def test_a_misprint_counts_apart_from_the_error_of_the_formula(row):
    """An error of 22 % hides that the misprint moves the value by half a per cent alone."""
    got = verdict(row("printed", -0.22, 0.001), row("right", -0.2161, 0.001))
    assert got.verdict is Verdict.WRONG
    assert got.misprint == pytest.approx(0.78 / 0.7839 - 1)
    assert got.words.startswith("wrong as printed; by the misprint alone −0.5 %, in all −22 %")


def test_a_misprint_that_changes_nothing_is_none_whatever_the_error(row):
    same = verdict(row("printed", -0.22, 0.001), row("right", -0.22, 0.001))
    assert same.verdict is Verdict.NONE
    assert "the printed form has no error" in same.words


def test_a_small_misprint_counts_though_it_is_within_the_bar(row):
    got = verdict(row("printed", 0.004, 0.01), row("right", 0.001, 0.01))
    assert got.verdict is Verdict.WRONG


@pytest.mark.parametrize(
    "other", [{"fem": 1.1}, {"unit": "mm"}, {"case": "ring-loads"}, {"analytic": None}]
)
def test_only_values_of_one_reference_are_compared(row, other):
    assert misprint([row("printed", 0.1)], [row("right", 0.2, **other)]) is None


def test_the_largest_change_counts(row):
    printed = [row("a", 0.1), row("b", -0.3)]
    assert misprint(printed, [row("right", 0.0)]) == pytest.approx(-0.3)


def test_rows_of_the_corrected_form_belong_to_printed_forms_with_errata():
    forms = declared()["belcin"].of(17)
    assert rows_of_corrected("belcin", forms[0]) == forms[1].rows
    assert rows_of_corrected("belcin", forms[1]) == ()


def test_a_misprint_without_a_row_says_what_is_wrong(row):
    shown = Formula(equation=9, what="x", errata=("eq-9-centrifugal",), limited_by="no growth")
    got = found._verdict("huang2018", "Huang 2018", shown, {})
    assert got.words == "wrong as printed: no growth"


@pytest.mark.parametrize(
    ("error", "says"),
    [
        (-0.004, "; at most 0.5 % too low, the unsafe side"),
        (0.004, "; all errors on the safe side"),
    ],
)
def test_an_accurate_formula_states_its_unsafe_side(row, error, says):
    formula = Formula(equation=6, what="x", safe=Safe.ABOVE, safe_reason="a margin",
                      part=("ring-lame/x",))  # fmt: skip
    got = found._verdict("p", "P", formula, {"ring-lame/x": row("x", error, 0.001)})
    assert says in got.words

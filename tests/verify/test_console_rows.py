"""Rows on the terminal: what the columns hold, and what the closing sentences name."""

from dataclasses import replace

import pytest

from verify.core.console_rows import closing, row_cells, title
from verify.core.references import reference_name
from verify.core.results import Kind, Partner
from verify.judging import judge
from verify.judging.claims import make_row


@pytest.fixture
def rows():
    """One judged row by finite elements, and one with 30 % that is not judged."""
    return [row("judged", 1.01, (0.0, 0.02)), row("printed form", 0.7, None)]


def row(name, formula, interval, case="ring-lame", by=""):
    verdict = judge.approximation(formula, 1.0, U=1e-4, interval=interval, demand=0.1)
    other = {"partner": Partner(by=by, value=1.0)} if by else {"fem": 1.0}
    return make_row(
        case, Kind.APPROXIMATION, verdict, name, "x", "1", analytic=formula, scale=1.0,
        interval=interval, **other,
    )  # fmt: skip


def test_the_closing_sentences_name_the_largest_of_all_rows(rows):
    passed, apart, limit, unjudged = closing(rows)
    assert passed == "1 of 2 comparisons pass"
    assert apart == (
        "largest difference of all comparisons: -30 % (printed form; reference: finite "
        "elements; SHOWN, not judged)"
    )
    assert limit == "detection limit of the judged rows: 0.98 %"
    assert unjudged == "not judged: 1 SHOWN (printed form: -30 %)"


def test_a_long_list_is_cut_but_never_its_largest(rows):
    many = [row(f"row {i}", 1 + 0.01 * i, None) for i in range(1, 9)]
    (*_, last) = closing([rows[0], *many])
    assert last.startswith("not judged: 8 SHOWN (row 8: +8.0 %; row 7: +7.0 %; ")
    assert last.endswith("; row 4: +4.0 %; and 3 more)")


def test_rows_that_failed_count_for_the_largest(rows):
    failed = row("broken", 2.0, (0.0, 0.02))
    assert (
        "+100 % (broken; reference: finite elements; expected 0 % to +2.0 %)"
        in closing([*rows, failed])[1]
    )


def test_a_column_headed_fe_holds_finite_elements_only(rows):
    head, *_ = row_cells(rows)
    assert head[3] == "FE"
    head, _, _, strips = row_cells([*rows, row("by strips", 1.01, (0.0, 0.02), by="strips")])
    assert "FE" not in head
    assert head[3:5] == ("reference", "by")
    assert strips[4] == "strips"


def test_rows_of_a_case_without_finite_elements_name_its_method(rows):
    one = replace(row("balance", 1.01, (0.0, 0.02), case="contact-roller"), method="half-space")
    head, line = row_cells([one])
    assert "FE" not in (*head, *line)
    assert title([one]) == "formulas against half-space"
    plane = row("pressure, plane finite elements", 1.01, (0.0, 0.02), case="contact-roller")
    assert reference_name(replace(plane, method="half-space")) == "FE"


def test_finite_elements_come_first_and_printed_numbers_last_in_the_title(rows):
    others = [row(by, 1.01, (0.0, 0.02), by=by) for by in ("printed 0.6", "printed 0.7", "strips")]
    assert title([*others, *rows]) == "formulas against finite elements; strips; printed values"

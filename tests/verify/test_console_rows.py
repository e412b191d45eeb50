"""Rows on the terminal: what the columns hold, and what the closing sentences name."""

from dataclasses import replace

import pytest

from verify.cases.registry import CASES, find
from verify.core.console_rows import closing, row_cells, title
from verify.core.references import FINITE_ELEMENTS, Method, reference_name
from verify.core.results import Kind, Partner, Status
from verify.core.source_code import parts_of
from verify.judging import judge
from verify.judging.claims import make_row
from verify.papers.paper_tables import _claim


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


@pytest.mark.parametrize("status", [Status.SHOWN, Status.CALIBRATED, Status.NOTE, Status.SKIP])
def test_every_row_that_is_not_judged_is_counted_and_named(rows, status):
    (*_, last) = closing([rows[0], replace(rows[1], status=status)])
    assert last == f"not judged: 1 {status.value} (printed form: -30 %)"


def test_a_long_list_is_cut_but_never_its_largest(rows):
    many = [row(f"row {i}", 1 + 0.01 * i, None) for i in range(1, 9)]
    (*_, last) = closing([rows[0], *many])
    assert last.startswith("not judged: 8 SHOWN (row 8: +8.0 %; row 7: +7.0 %; ")
    assert last.endswith("; row 4: +4.0 %; and 3 more)")


def test_rows_that_failed_count_for_the_largest(rows):
    failed = replace(row("broken", 2.0, (0.0, 0.02)))
    assert failed.status is Status.FAIL
    assert (
        "+100 % (broken; reference: finite elements; expected 0 % to +2.0 %)"
        in closing([*rows, failed])[1]
    )


def test_without_differences_nothing_is_said_of_them(rows):
    fact = replace(rows[0], kind=Kind.FACT, analytic=None, detects=None)
    assert len(closing([fact])) == 1


def test_a_column_headed_fe_holds_finite_elements_only(rows):
    head, *_ = row_cells(rows)
    assert head[3] == "FE"
    head, _, _, strips = row_cells([*rows, row("by strips", 1.01, (0.0, 0.02), by="strips")])
    assert "FE" not in head
    assert head[3:5] == ("reference", "by")
    assert strips[4] == "strips"


OTHERS = [case for case in CASES if case.method != Method()]


@pytest.mark.parametrize("case", OTHERS, ids=lambda case: case.id)
def test_cases_without_finite_elements_say_so(case):
    one = replace(row("balance", 1.01, (0.0, 0.02), case=case.id), method=case.method.alone)
    head, line = row_cells([one])
    assert "FE" not in (*head, *line)
    assert title([one]) == f"formulas against {case.method.alone}"
    assert reference_name(one) == case.method.alone
    assert case.method.case != FINITE_ELEMENTS


def test_every_row_that_was_judged_carries_the_method_of_its_case(of_paper):
    case = find("contact-roller-flat")
    assert {r.method for r in of_paper(case).rows if r.fem is not None} == {"half-space"}


def test_rows_of_such_cases_by_finite_elements_keep_their_name():
    named = row("pressure, plane finite elements", 1.01, (0.0, 0.02), case="contact-roller")
    one = replace(named, method="half-space")
    assert reference_name(one) == "FE"


def test_finite_elements_come_first_and_printed_numbers_last_in_the_title(rows):
    others = [row(by, 1.01, (0.0, 0.02), by=by) for by in ("printed 0.6", "printed 0.7", "strips")]
    assert title([*others, *rows]) == "formulas against finite elements; strips; printed values"


def test_the_column_of_finite_elements_beside_a_printed_table_holds_nothing_else():
    from verify.papers.ledger import published

    value = published("huang2018:table1-r-e")
    assert _claim(row("a", 1.0, None), value).fem is not None
    assert _claim(replace(row("a", 1.0, None), method="half-space"), value).fem is None


def test_every_case_whose_reference_uses_no_finite_elements_is_known():
    """By the modules that its reference runs; struts between rigid hubs are no elements."""
    bare = {
        case.id for case in CASES
        if not any(
            name.startswith("fem.") and not name.startswith("fem.rotor.struts")
            for name in parts_of(case.reference)[1]
        )
    }  # fmt: skip
    assert len(bare) >= 9
    assert bare <= {case.id for case in OTHERS}

"""Failed rows stand before all others, then those not run; files of data keep their order."""

import csv
import io
import re
from dataclasses import replace

import pytest

from reports.html import anchors, page
from reports.pdf_case import case_data
from reports.records import report_record
from reports.row_lines import failed_first, lines
from reports.rows import rows_csv
from verify.core.results import Kind, Row, Status


def row(quantity: str, status: Status = Status.PASS, case: str = "c") -> Row:
    return Row(
        case=case, quantity=quantity, symbol="x", unit="1", kind=Kind.IDENTITY, status=status
    )


PASS, NOTE, SKIP, FAIL = Status.PASS, Status.NOTE, Status.SKIP, Status.FAIL


def test_failed_rows_come_first_then_those_not_run_each_in_their_order():
    given = [
        row("a"),
        row("b", SKIP),
        row("c", NOTE),
        row("d", FAIL),
        row("e", FAIL),
        row("f", SKIP),
    ]
    assert [r.quantity for r in failed_first(given)] == ["d", "e", "b", "f", "a", "c"]
    assert [line.row.quantity for line in lines(given)] == ["d", "e", "b", "f", "a", "c"]


@pytest.fixture(scope="module")
def planted(report):
    """Three cases; the last row of the second with meshes fails, one of the third is not run."""
    first, second, third = report.cases[:3]
    last = max(i for i, r in enumerate(second.rows) if r.grid and r.levels)
    rows = [replace(r, status=FAIL) if i == last else r for i, r in enumerate(second.rows)]
    broken = replace(second, rows=tuple(rows))
    left_out = replace(third, rows=(*third.rows[:-1], replace(third.rows[-1], status=SKIP)))
    return replace(report, cases=(first, broken, left_out), tables=(), validity=(), budgets=())


@pytest.fixture(scope="module")
def text(planted):
    return page(planted, {})


def test_on_the_page_the_table_of_all_rows_begins_with_the_failed_one(planted, text):
    table = text[text.index('<table class="rows') :]
    found = re.findall(r'<tr role="row" id="(row-\d+)" class="row is-(\w+)"', table)
    where = anchors(planted.rows)
    assert found[0] == (where[failed(planted).id], "fail")
    assert found[1] == (where[planted.cases[2].rows[-1].id], "skip")
    assert {status for _, status in found[2:]}.isdisjoint({"fail", "skip"})
    rest = [int(name.removeprefix("row-")) for name, _ in found[2:]]
    assert rest == sorted(rest)


def failed(planted):
    (row,) = [row for row in planted.rows if row.status is FAIL]
    return row


def test_in_the_pdf_too(planted):
    case = planted.cases[1]
    data = case_data(case, (), anchors(planted.rows), ["s"] * len(case.tables), "p")
    assert [line["status"] for line in data["lines"]].index("FAIL") == 0


def test_files_of_data_keep_the_order_of_the_cases(planted):
    ids = [row.id for row in planted.rows]
    assert [r["id"] for r in report_record(planted)["rows"]] == ids
    table = csv.DictReader(io.StringIO(rows_csv(planted.rows).removeprefix("\ufeff")))
    assert [f"{r['case']}/{r['quantity']}" for r in table] == ids

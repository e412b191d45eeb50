"""tables.xlsx read back: numbers are numbers, texts are texts, and every table exists."""

import io
import math
from dataclasses import replace
from datetime import UTC, datetime

import openpyxl
import pytest

from reports.rows import HEADER, cells
from reports.sheets import LONGEST, Sheets
from reports.workbook import Book, Printed
from reports.xlsx import xlsx
from verify.core.figures import Table


def opened(content):
    return openpyxl.load_workbook(io.BytesIO(content))


def near(value):
    """The value to the 16 digits that a workbook holds."""
    return None if value is None else pytest.approx(value, rel=1e-15, abs=0)


@pytest.fixture(scope="module")
def book(report):
    return opened(xlsx(report))


def test_rows_are_those_of_the_run_with_their_values_and_links_to_errata(report, book):
    sheet = book["Rows"]
    head, *lines = sheet.iter_rows(values_only=True)
    assert head == (*HEADER, "ledger")
    numbers = range(HEADER.index("analytic"), HEADER.index("order"))
    for line, row in zip(lines, report.rows, strict=True):
        expected = cells(row)
        assert line[:5] == tuple(cell or None for cell in expected[:5])
        assert [line[i] for i in numbers] == [near(expected[i]) for i in numbers]
        assert line[HEADER.index("status")] == row.status.value
    linked = [c for (c,) in sheet.iter_rows(min_row=2, min_col=len(HEADER) + 1) if c.value]
    assert len(linked) == sum("ledger " in row.reason for row in report.rows) > 0
    for cell in linked:
        at = int(cell.hyperlink.location.removeprefix("'Errata'!A"))
        paper, entry = (book["Errata"].cell(at, k).value for k in (1, 2))
        assert cell.value == f"{paper}:{entry}"


def test_every_table_has_a_sheet_and_those_of_papers_none_in_a_user_s_report(report, book):
    assert book.sheetnames[:4] == ["Summary", "Rows", "Inputs and values", "Levels"]
    sheets = Sheets(report)
    for case, names in zip(report.cases, sheets.of_case, strict=True):
        for table, name in zip(case.tables, names, strict=True):
            read = [tuple(c or "" for c in line) for line in book[name].iter_rows(values_only=True)]
            assert read[read.index(table.header) + 1 :] == [
                tuple(near(c) if isinstance(c, float) and c else c or "" for c in row)
                for row in table.rows
            ]
    assert [name in book.sheetnames for name in sheets.of_paper].count(True) == len(report.tables)
    ledgers = {"Errata": report.errata, "Equations": report.equations,
               "Printed numbers": report.published}  # fmt: skip
    for name, records in ledgers.items():
        assert book[name].max_row == 1 + len(records)
    names = opened(xlsx(replace(report, name="mine"))).sheetnames
    assert "Rows" in names
    assert not {*ledgers, "wang2023 Table 1"} & set(names)


TEXTS = ("=1+1", "+1", "-1", "@A1", "http://example.org", "mailto:a@b", "{=1}", "1", "'x")
PRINTED = (
    ("0.610", 0.61, "0.000"), ("−3", -3, "0"), ("1.80×10^-3", 1.8e-3, "0.00E+00"),
    ("0.601; 0.602", "0.601; 0.602", "General"), ("twelve", "twelve", "General"),
)  # fmt: skip


def test_a_text_stays_a_text_none_is_empty_and_a_printed_number_keeps_its_digits():
    none = [math.nan, math.inf, -math.inf, None]
    given = [*TEXTS, *none, 0.0, *(Printed(text) for text, *_ in PRINTED)]
    book = Book("title", datetime(2026, 1, 1, 12, tzinfo=UTC))
    book.table("one", ["a"], [[one] for one in given])
    found = [c for (c,) in opened(book.content())["one"].iter_rows(min_row=2)]
    texts, numbers, printed = found[: len(TEXTS)], found[len(TEXTS) : -5], found[-5:]
    for text, cell in zip(TEXTS, texts, strict=True):
        assert (cell.value, cell.data_type, cell.hyperlink) == (text, "s", None)
    assert [cell.value for cell in numbers] == [None, None, None, None, 0]
    assert [(c.value, c.number_format) for c in printed] == [(v, shown) for _, v, shown in PRINTED]


def test_sheet_names_are_short_lawful_and_each_once(report):
    odd = ["a/b\\c:d*e?f[g]", "History", "rows", "''", "", "Summary", "é\x07"]
    titles = ["x" * 40, "X" * 40, *odd]
    tables = tuple(Table(title=t, header=("a",), rows=()) for t in titles)
    changed = replace(report, cases=(replace(report.cases[0], tables=tables),))
    (names,) = Sheets(changed).of_case
    book = opened(xlsx(changed))
    assert set(names) <= set(book.sheetnames)
    assert len({n.casefold() for n in book.sheetnames}) == len(book.sheetnames)
    assert all(len(n) <= LONGEST and n.casefold() != "history" for n in names)

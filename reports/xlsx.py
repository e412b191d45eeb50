"""tables.xlsx: all tables of the report, with numbers as numbers, not as text."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from typing import Any

from reports.html import title
from reports.paper_rows import printed_row
from reports.pdf import made
from reports.rows import HEADER, PERCENT, cells
from reports.second import seconds
from reports.sheets import Sheets
from reports.workbook import Book, Cell, Link, Printed
from verify.core.results import CaseResult, Crosscheck, PaperTable, Report, Row, Status
from verify.core.verdicts import FormulaVerdict

RELATIVE_FORMAT = "0.0E+00"
LEDGER = re.compile(r"ledger (\w+):([\w-]+)")
SMALL = (
    *PERCENT, "second_difference_relative", "tolerance", "difference", "u_num", "u_ref",
    "u_input", "u",
)  # fmt: skip
NUMBERS = dict.fromkeys(SMALL, RELATIVE_FORMAT) | {"order": "0.00"}
HEAD = 1  # line of the head of a sheet without lines above


def xlsx(report: Report) -> bytes:
    """Content of the workbook; for user cases or inputs, without the sheets of the papers."""
    book, sheets = Book(title(report), made(report)), Sheets(report)
    _summary(book, report)
    book.table("Rows", (*HEADER, "ledger"), _rows(report), numbers=NUMBERS)
    book.table(
        "Inputs and values",
        ("case", "side", "symbol", "name", "what", "value", "unit", "source"),
        [row for case in report.cases for row in _given(case)],
    )
    book.table(
        "Levels",
        ("case", "quantity", "symbol", "unit", "level", "mesh size, relative", "value", "u"),
        [line for row in report.rows for line in _levels(row)],
        numbers=NUMBERS,
    )
    for case, names in zip(report.cases, sheets.of_case, strict=True):
        for table, name in zip(case.tables, names, strict=True):
            above = [[table.title], *([[table.note]] if table.note else []), [case.id]]
            book.table(name, table.header, table.rows, above=above)
    if report.has_ledgers:
        for paper_table, name in zip(report.tables, sheets.of_paper, strict=True):
            _paper_table(book, name, paper_table)
        _ledgers(book, report)
    lines = list(_flat(report.provenance))
    book.table("Provenance", ("what", "value"), lines)
    return book.content()


def _summary(book: Book, report: Report) -> None:
    origin = report.provenance
    above: list[Sequence[Cell]] = [
        [title(report)],
        [f"made {origin['made']}, commit {origin['commit']}, lock {origin['lock']}"],
        [],
    ]
    lines: list[list[Cell]] = [
        [case.name or case.id, case.title, len(case.rows), *_counts(case.rows)]
        for case in report.cases
    ]
    total: list[Cell] = ["all", "", len(report.rows), *_counts(report.rows)]
    header = ("case", "title", "rows", *(status.value for status in Status))
    book.table("Summary", header, [*lines, total], above=above)


def _counts(rows: Sequence[Row]) -> list[int]:
    return [sum(row.status is status for row in rows) for status in Status]


def _rows(report: Report) -> list[list[Cell]]:
    """Cells of all rows as in rows.csv, with printed numbers as numbers and links to errata."""
    lines = {(e["paper"], e["id"]): i for i, e in enumerate(report.errata, HEAD + 1)}
    beside = seconds(report.crosschecks)
    return [_row(row, beside.of(row), lines) for row in report.rows]


def _row(
    row: Row, beside: Sequence[Crosscheck], lines: Mapping[tuple[str, str], int]
) -> list[Cell]:
    *values, theory, fea, test = cells(row, beside)
    found = LEDGER.search(row.reason)
    line = lines.get((found[1], found[2])) if found else None
    link = Link(f"{found[1]}:{found[2]}", f"'Errata'!A{line}") if found and line else None
    return [*values, *(Printed(str(p)) for p in (theory, fea, test)), link]


def _given(case: CaseResult) -> Iterator[list[Cell]]:
    for i in case.inputs:
        yield [case.id, "input", i.symbol, i.name, i.what, i.value, i.unit, i.source]
    for v in case.values:
        judged = "judged" if v.judged else "not judged"
        yield [case.id, "formula", v.symbol, "", v.what, v.value, v.unit, judged]


def _levels(row: Row) -> Iterator[list[Cell]]:
    for i, (size, value) in enumerate(row.levels):
        u = row.levels_u[i] if row.levels_u else None
        yield [row.case, row.quantity, row.symbol, row.unit, i, size, value, u]


def _paper_table(book: Book, name: str, table: PaperTable) -> None:
    """Add a sheet with a printed table.

    Each comparison or input of a printed row has a line, the first one beside the row.
    """
    above = [[f"{table.paper}, {table.name}"], [table.caption], [table.note]]
    lines: list[list[Cell]] = []
    for printed in table.rows:
        found = printed_row(printed)
        place = [f"{name} {cell.text}" for name, cell in zip(table.header, printed, strict=True)]
        made_of: list[list[Cell]] = [
            ["; ".join(place[k] for k in c.columns), c.status.value, c.row,
             c.numbers.analytic, c.numbers.fem, c.numbers.u]
            for c in found.claims
        ]  # fmt: skip
        made_of += [[place[i.column], "input", i.words, None, None, None] for i in found.inputs]
        aside = "; ".join(found.errata)
        texts: list[Cell] = [Printed(cell.text) for cell in printed]
        nothing: list[Cell] = ["", "", "", None, None, None]
        for i, claim in enumerate(made_of or [nothing]):
            lines.append([*(texts if i == 0 else [""] * len(texts)), *claim, "" if i else aside])
    ours = ("compared with", "status", "row or input", "formula", "FE", "u", "errata")
    book.table(name, (*table.header, *ours), lines, above=above, numbers=NUMBERS)


def _ledgers(book: Book, report: Report) -> None:
    if report.verdicts:
        _records(book, "Verdicts", [_verdict(one) for one in report.verdicts])
    _records(book, "Errata", report.errata)
    _records(book, "Equations", report.equations)
    _records(book, "Printed numbers", report.published)


def _verdict(one: FormulaVerdict) -> dict[str, Any]:
    """Record of a verdict in one line, with its ranges as text."""
    ranges = [f"{100 * r.limit:g} % in {r.case}: {r.words}" for r in one.ranges]
    return asdict(one) | {"ranges": ranges}


def _records(book: Book, name: str, records: Sequence[Mapping[str, Any]]) -> None:
    """Add a sheet with records of one kind; the paper and the id come first."""
    keys = dict.fromkeys(("paper", "id", *(k for record in records for k in record)))
    header = [k for k in keys if any(k in record for record in records)]
    book.table(name, header, [[_cell(k, record.get(k)) for k in header] for record in records])


def _cell(key: str, value: Any) -> Cell:
    if isinstance(value, bool):
        return "yes" if value else ""
    if isinstance(value, list | tuple):
        return "; ".join(map(str, value))
    return Printed(value) if key == "printed" and isinstance(value, str) else value


def _flat(record: Mapping[str, Any], path: str = "") -> Iterator[list[Cell]]:
    for key, value in record.items():
        if isinstance(value, Mapping):
            yield from _flat(value, f"{path}{key}: ")
        else:
            yield [f"{path}{key}", _cell(key, value)]

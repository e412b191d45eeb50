"""Tables of a case in the PDF: tolerances, values on every mesh, and results."""

from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import Any

from reports import formats
from reports.richtext import Run, digits, runs
from verify.core.figures import Table
from verify.core.results import Row

Data = dict[str, Any]

LONGEST = 20  # rows of a table that are printed whole
SHOWN = 12  # of a longer one
WIDEST = 12  # columns side by side


def prose(text: str) -> list[Run]:
    """Running text with lowered indices, as runs."""
    return runs(formats.prose(text))


def quantity(row: Row) -> list[Run]:
    """Name of a row and, on a separate line, its symbol and unit."""
    unit: list[Run] = [" ", *prose(row.unit)] if row.unit != "1" else []
    return [*prose(row.quantity), ["br"], ["small", *runs(formats.symbol(row.symbol)), *unit]]


def budget(rows: Sequence[Row]) -> Data:
    """Lines for the derivation of tolerances, and the reasons for required sensitivities."""
    reasons = dict.fromkeys(row.demand_reason for row in rows if row.demand_reason)
    marks = {reason: _letter(i) for i, reason in enumerate(reasons)}
    return {
        "rows": [_budget_line(row, marks.get(row.demand_reason, "")) for row in rows],
        "reasons": [[mark, prose(reason)] for reason, mark in marks.items()],
    }


def _letter(index: int) -> str:
    """Letters for an index: a to z, then aa, ab and so on."""
    more, last = divmod(index, 26)
    return (_letter(more - 1) if more else "") + chr(ord("a") + last)


def _budget_line(row: Row, mark: str) -> list[list[Run]]:
    return [
        quantity(row), [row.kind.value], [row.grid.behaviour if row.grid else ""],
        [formats.order(row)], [formats.number(row.formal_order, 3)],
        runs(formats.relative(row, "u_num")), runs(formats.relative(row, "u_ref")),
        runs(formats.tolerance(row)), runs(formats.fraction(row, row.detects)),
        [*runs(formats.fraction(row, row.demand)), *([["sup", mark]] if mark else [])],
    ]  # fmt: skip


def levels(rows: Iterable[Row]) -> list[Data]:
    """Values on every mesh, with one table for each set of meshes."""
    return [
        {
            "header": [["Quantity"], *([f"h = {formats.number(h, 3)}"] for h in sizes)],
            "rows": [_level_cells(row) for row in group],
        }
        for sizes, group in groupby(sorted(rows, key=_sizes), _sizes)
    ]


def _level_cells(row: Row) -> list[list[Run]]:
    return [quantity(row), *(digits(formats.number(v, 9)) for _, v in row.levels)]


def _sizes(row: Row) -> tuple[float, ...]:
    return tuple(h for h, _ in row.levels)


def expected(row: Row) -> list[list[Run]]:
    """Cells with the limits of the expected interval of an approximation, and its source."""
    assert row.interval is not None
    ends = (runs(formats.fraction(row, m, signed=True)) for m in row.interval)
    return [quantity(row), *ends, prose(row.interval_source)]


def shortened(table: Table, sheet: str) -> Data:
    """A table in parts that fit the page width; of a long table, only the first rows."""
    long = len(table.rows) > LONGEST
    rows = table.rows[:SHOWN] if long else table.rows
    count = f"The first {SHOWN} of {len(table.rows)} rows; all are in tables.xlsx, sheet {sheet}."
    last = len(table.header) - 1
    starts = range(1, max(last, 1) + 1, WIDEST - 1)
    parts = [[0, *range(i, min(i + WIDEST - 1, last + 1))] for i in starts]
    return {
        "title": prose(table.title),
        "parts": [
            {
                "header": [prose(table.header[i]) for i in part],
                "rows": [[_cell(row[i]) for i in part] for row in rows],
                "numbers": [bool(rows) and not isinstance(rows[0][i], str) for i in part],
            }
            for part in parts
        ],
        "note": prose(table.note),
        "shortened": count if long else "",
    }


def _cell(cell: str | float | None) -> list[Run]:
    return prose(cell) if isinstance(cell, str) else digits(formats.number(cell))

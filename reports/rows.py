"""Table of the rows of a run: content of rows.csv and of the workbook's sheet of rows."""

import csv
import io
from collections.abc import Iterable, Mapping, Sequence

from reports import second
from reports.formats import spaced
from reports.xml_text import clean
from verify.core.differences import difference, offset
from verify.core.references import reference_name
from verify.core.results import Crosscheck, Row

COLUMNS = (
    "case", "quantity", "symbol", "unit", "kind", "by", "analytic", "fem", "reference",
    "difference", "scale", "tolerance", "u_num", "u_ref", "u_input", "order", "status", "reason",
)  # fmt: skip
PERCENT = (
    "difference_percent", "tolerance_percent", "percent_of", "detects_percent", "demand_percent",
    "expected_low_percent", "expected_high_percent",
)  # fmt: skip
PRINTED = ("printed_theory", "printed_FEA", "printed_test")
HEADER = (*COLUMNS, *PERCENT, *second.COLUMNS, *PRINTED)
FORMULAS = ("=", "+", "-", "@", "\t", "\r")  # first characters of a formula in a spreadsheet

Cell = str | float | None


def cells(row: Row, beside: Sequence[Crosscheck] = ()) -> list[Cell]:
    """Cells of a row: its values, per cent as on the page, second solvers, printed numbers.

    `difference` is formula minus reference.
    """
    printed = (
        "; ".join(p.printed for p in row.published if p.kind == kind.partition("_")[2])
        for kind in PRINTED
    )
    named = {c: getattr(row, c) for c in COLUMNS} | {"difference": offset(row)}
    named["reason"] = spaced(row.reason)
    named["by"] = reference_name(row) if row.reference is not None and row.kind != "fact" else ""
    return [*named.values(), *_percents(row), *second.cells(beside), *printed]


def _percents(row: Row) -> list[Cell]:
    found = difference(row)
    if found is None or not found.percent:
        value, U, of = None, None, ""
    else:
        value, U, of = found.value, found.U, found.of or "reference"
    limits = (row.detects, row.demand, *(row.interval or (None, None)))
    return [_hundredfold(value), _hundredfold(U), of, *map(_hundredfold, limits)]


def _hundredfold(fraction: float | None) -> float | None:
    return None if fraction is None else 100 * fraction


def rows_csv(rows: Iterable[Row], beside: Mapping[str, Sequence[Crosscheck]] | None = None) -> str:
    """CSV text with one line per row.

    A text that a spreadsheet would evaluate begins with an apostrophe. `beside` contains results of
    second solvers, by id of the row. The text begins with a byte-order mark; without it,
    spreadsheets misread µm.
    """
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(HEADER)
    for row in rows:
        table.writerow([harmless(cell) for cell in cells(row, (beside or {}).get(row.id, ()))])
    return "\ufeff" + text.getvalue()


def harmless(cell: Cell) -> str | float:
    """A cell that no spreadsheet evaluates and that has no line break; empty for None."""
    if not isinstance(cell, str):
        return "" if cell is None else cell
    text = clean(cell).replace("\r", " ")  # csv writes it unquoted, and a line would end there
    return f"'{text}" if text.startswith(FORMULAS) else text

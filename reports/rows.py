"""The rows of a run as a table: what rows.csv and the workbook's sheet of rows hold."""

import csv
import io
from collections.abc import Iterable, Mapping, Sequence

from reports import second
from reports.xml_text import clean
from verify.results import Crosscheck, Row

COLUMNS = (
    "case", "quantity", "symbol", "unit", "kind", "by", "analytic", "fem", "reference",
    "difference", "scale", "tolerance", "u_num", "u_ref", "u_input", "order", "status", "reason",
)  # fmt: skip
RELATIVE = (
    "difference_relative", "tolerance_relative", "detects_relative", "demand_relative",
    "expected_low_relative", "expected_high_relative",
)  # fmt: skip
PRINTED = ("printed_theory", "printed_FEA", "printed_test")
HEADER = (*COLUMNS, *RELATIVE, *second.COLUMNS, *PRINTED)
FORMULAS = ("=", "+", "-", "@", "\t", "\r")  # what makes a spreadsheet compute a text

Cell = str | float | None


def cells(row: Row, beside: Sequence[Crosscheck] = ()) -> list[Cell]:
    """One row: values in its unit, what is relative to its scale, second solvers, the papers."""
    scale = row.scale if row.kind != "fact" else None
    relative = (
        row.difference / scale if scale and row.difference is not None else None,
        row.tolerance / scale if scale and row.tolerance is not None else None,
        row.detects, row.demand, *(row.interval or (None, None)),
    )  # fmt: skip
    printed = (
        "; ".join(p.printed for p in row.published if p.kind == kind.partition("_")[2])
        for kind in PRINTED
    )
    named = {c: getattr(row, c) for c in COLUMNS}
    named["by"] = row.by if row.reference is not None and row.kind != "fact" else ""
    return [*named.values(), *relative, *second.cells(beside), *printed]


def rows_csv(rows: Iterable[Row], beside: Mapping[str, Sequence[Crosscheck]] | None = None) -> str:
    """One line a row; a text that a spreadsheet would compute starts with an apostrophe.

    `beside` has what second solvers found, by id of the row.

    Begins with a byte-order mark, without which spreadsheets misread µm.
    """
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(HEADER)
    for row in rows:
        table.writerow([harmless(cell) for cell in cells(row, (beside or {}).get(row.id, ()))])
    return "\ufeff" + text.getvalue()


def harmless(cell: Cell) -> str | float:
    """A cell that no spreadsheet computes and that stays on its line; empty for nothing."""
    if not isinstance(cell, str):
        return "" if cell is None else cell
    text = clean(cell).replace("\r", " ")  # csv writes it unquoted, and a line would end there
    return f"'{text}" if text.startswith(FORMULAS) else text

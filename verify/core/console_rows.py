"""Table of the rows of a check for the terminal, and the closing sentences."""

from collections.abc import Mapping, Sequence

from verify.core.differences import COMPARED, UNJUDGED, difference_texts, largest, percent, size
from verify.core.references import FINITE_ELEMENTS, reference_name
from verify.core.results import FE, Row, Status

COMPANION = ": convergence"  # rows that share the line of their comparison
LISTED = (Status.FAIL, Status.SKIP, Status.SHOWN, Status.NOTE, Status.CALIBRATED)
PRINTED = "printed values"
NAMED = 5  # rows of one status that the closing sentences name

Causes = Mapping[tuple[Status, str, str], list[Row]]


def row_cells(rows: Sequence[Row]) -> list[tuple[str, ...]]:
    """Head and lines of the table of rows, without passed convergence rows.

    The column of references has the head "FE" if all references are finite elements.
    """
    shown = shown_rows(rows)
    every = all(reference_name(row) == FE for row in shown if row.reference is not None)
    head = ("", "", "formula", FE if every else "reference", *(() if every else ("by",)), "",
            "difference", "allowed")  # fmt: skip
    return [head, *(_compared(row, named=not every) for row in shown)]


def title(rows: Sequence[Row]) -> str:
    """Title of the table; it names the references that the formulas are compared with."""
    names = {
        PRINTED if (name := _full_name(row)).startswith("printed ") else name
        for row in rows if row.kind in COMPARED and row.reference is not None
    }  # fmt: skip
    ordered = sorted(names, key=lambda name: (name != FINITE_ELEMENTS, name == PRINTED, name))
    return f"formulas against {_shortened(ordered) or 'references'}"


def shown_rows(rows: Sequence[Row]) -> list[Row]:
    """Rows to display; passed convergence rows are omitted if `rows` contains their comparison."""
    known = {row.quantity for row in rows}
    return [
        row for row in rows
        if row.status is not Status.PASS or not row.quantity.endswith(COMPANION)
        or row.quantity.removesuffix(COMPANION) not in known
    ]  # fmt: skip


def causes(rows: Sequence[Row]) -> Causes:
    """Rows with any status but PASS, grouped by status, case and reason."""
    found: dict[tuple[Status, str, str], list[Row]] = {}
    for row in rows:
        if row.status in LISTED:
            found.setdefault((row.status, row.case, row.reason), []).append(row)
    return found


def closing(rows: Sequence[Row]) -> list[str]:
    """Closing sentences: passed rows, largest difference, detection limit, rows not judged."""
    found = [_counted([row for row in rows if not row.quantity.endswith(COMPANION)], "comparisons")]
    found += [
        _counted([row for row in rows if row.quantity.endswith(COMPANION)], "convergence rows")
    ]
    found_lines = ["; ".join(filter(None, found))]
    if (row := largest(list(rows))) is not None:
        text, allowed = difference_texts(row)
        judged = f"; {row.status.value}, not judged" if row.status in UNJUDGED else ""
        judged += f"; expected {allowed}" if "to" in allowed else ""
        found_lines.append(
            f"largest difference of all comparisons: {text} "
            f"({row.quantity}; reference: {_full_name(row)}{judged})"
        )
    limits = [row.detects for row in rows if row.kind in COMPARED and row.detects is not None
              and row.status not in UNJUDGED]  # fmt: skip
    if limits:
        found_lines.append(f"detection limit of the judged rows: {percent(max(limits))}")
    return [*found_lines, *_unjudged(rows)]


def _counted(rows: Sequence[Row], what: str) -> str:
    """Text such as `5 of 6 comparisons pass`; empty without rows."""
    passed = sum(row.status is Status.PASS for row in rows)
    return f"{passed} of {len(rows)} {what} pass" if rows else ""


def _unjudged(rows: Sequence[Row]) -> list[str]:
    """Sentence with the rows that were not judged: by status, then by decreasing difference."""
    parts = []
    for status in UNJUDGED:
        group = sorted((row for row in rows if row.status is status), key=size, reverse=True)
        if group:
            parts.append(f"{len(group)} {status.value} ({_shortened([_named(r) for r in group])})")
    return [f"not judged: {', '.join(parts)}"] if parts else []


def _full_name(row: Row) -> str:
    name = reference_name(row)
    return FINITE_ELEMENTS if name == FE else name


def _named(row: Row) -> str:
    text, _ = difference_texts(row)
    return f"{row.quantity}: {text}" if text else row.quantity


def _shortened(names: Sequence[str]) -> str:
    more = f"; and {len(names) - NAMED} more" if len(names) > NAMED else ""
    return "; ".join(names[:NAMED]) + more


def _compared(row: Row, *, named: bool) -> tuple[str, ...]:
    """Cells of a row: status, quantity, values, reference, difference, allowed difference."""
    name = reference_name(row) if row.reference is not None else ""
    found, allowed = difference_texts(row)
    if found and not allowed:
        allowed = "not judged" if row.status in UNJUDGED else ""
    return (
        row.status.value, row.quantity, number(row.analytic), number(row.reference),
        *((name,) if named else ()), unit_of(row.unit), found, allowed,
    )  # fmt: skip


def number(value: float | int | str | None) -> str:
    """Text of a number with six significant digits; empty for None."""
    return "" if value is None else f"{value:.6g}" if isinstance(value, float) else str(value)


def unit_of(unit: str) -> str:
    """Unit as printed after a number; empty for a plain number."""
    return "" if unit == "1" else unit

"""Output of the commands about judged rows, for the terminal."""

import re
from collections.abc import Sequence

from verify.core.console_rows import causes, closing, row_cells, shown_rows, title
from verify.core.results import Report, Row, Status
from verify.core.terminal import print_wrapped

_POWER = re.compile(r"(?<=[\w)])\^(-?\d+)(?![\d.]*\.\d)")
_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def verdict_lines(report: Report) -> list[str]:
    """Table of the numbers of rows by case and status, and reasons of the rows that did not pass.

    Each reason is stated once per case.
    """
    head = ("case", "rows", *(s.value for s in Status))
    lines = [head]
    for case in report.cases:
        states = [row.status for row in case.rows]
        counts = (str(states.count(s) or "·") for s in Status)
        lines.append((case.id, str(len(states)), *counts))
    found = aligned(lines)
    for (status, case_id, reason), rows in causes(report.rows).items():
        more = f" and {len(rows) - 1} more" if len(rows) > 1 else ""
        found.append(raised(f"{status.value:10} {case_id}: {rows[0].quantity}{more}: {reason}"))
    return [*found, f"{len(report.rows)} rows"]


def print_rows(rows: Sequence[Row]) -> None:
    """Print a table of the judged rows, the reasons of rows that did not pass, and a summary."""
    print(title(rows))
    lines = aligned([_numbers_first(cells) for cells in row_cells(rows)])
    print_wrapped(*(f"  {line}" for line in lines))
    print_wrapped(*sentences(rows))


def sentences(rows: Sequence[Row]) -> list[str]:
    """Reasons of rows with any status but PASS, followed by the closing sentences."""
    found = []
    for (status, _, reason), group in causes(shown_rows(rows)).items():
        more = f" and {len(group) - 1} more" if len(group) > 1 else ""
        found.append(f"{status.value} {group[0].quantity}{more}: {reason}")
    return [raised(line) for line in (*found, *closing(rows))]


def _numbers_first(cells: tuple[str, ...]) -> tuple[str, ...]:
    """Cells of a row with its difference first and its name (with the scale) last."""
    status, name, *values, difference, allowed = cells
    number, _, scale = difference.partition(" of ")
    name += f"; difference relative to {scale}" if scale else ""
    return status, number, allowed, *values, name


def aligned(lines: Sequence[tuple[str, ...]]) -> list[str]:
    """Lines of a table with aligned columns and raised exponents."""
    shown = [tuple(map(raised, line)) for line in lines]
    wide = [max(map(len, column)) for column in zip(*shown, strict=True)]
    return ["  ".join(map(str.ljust, line, wide)).rstrip() for line in shown]


def raised(text: str) -> str:
    """Text with raised exponents: "10^-5" becomes "10⁻⁵", "kg m^2" becomes "kg m²"."""
    return _POWER.sub(lambda match: match[1].translate(_RAISED), text)

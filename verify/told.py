"""What the commands print of judged rows."""

import re
from collections.abc import Mapping, Sequence

from verify.results import Kind, Report, Row, Status

COMPANION = ": convergence"  # rows that stand beside the one they are about
_POWER = re.compile(r"(?<=[\w)])\^(-?\d+)")
_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
LISTED = (Status.FAIL, Status.SKIP, Status.SHOWN, Status.NOTE, Status.CALIBRATED)


def print_verdicts(report: Report) -> None:
    """Counts by case, then every row that did not simply pass, each reason once a case."""
    head = ("case", "rows", *(s.value for s in Status))
    lines = [head]
    for case in report.cases:
        states = [row.status for row in case.rows]
        counts = (str(states.count(s) or "·") for s in Status)
        lines.append((case.id, str(len(states)), *counts))
    for line in aligned(lines):
        print(line)
    for (status, case_id, reason), rows in _causes(report.rows).items():
        more = f" and {len(rows) - 1} more" if len(rows) > 1 else ""
        print(raised(f"{status.value:10} {case_id}: {rows[0].quantity}{more}: {reason}"))
    print(f"{len(report.rows)} rows")


def print_rows(rows: Sequence[Row]) -> None:
    """The judged rows in short, the reasons of those that did not pass, and the total."""
    print("formulas against finite elements")
    known = {row.quantity for row in rows}
    shown = [
        row for row in rows
        if row.status is not Status.PASS or row.quantity.removesuffix(COMPANION) not in known
        or not row.quantity.endswith(COMPANION)
    ]  # fmt: skip
    head = ("", "", "formula", "FE", "", "difference", "allowed")
    for line in aligned([head, *map(_compared, shown)]):
        print(f"  {line}")
    for (status, _, reason), group in _causes(shown).items():
        more = f" and {len(group) - 1} more" if len(group) > 1 else ""
        print(raised(f"{status.value} {group[0].quantity}{more}: {reason}"))
    passed = sum(row.status is Status.PASS for row in rows)
    judged = [r for r in rows if r.kind in (Kind.IDENTITY, Kind.APPROXIMATION) and r.detects]
    print(f"{passed} of {len(rows)} rows pass, their convergence included" + _sharpest(judged))


def _sharpest(rows: Sequence[Row]) -> str:
    if not rows:
        return ""
    apart = max(abs(row.difference or 0.0) / (row.scale or 1.0) for row in rows)
    seen = max(row.detects or 0.0 for row in rows)
    return (
        f"; formula and FE are at most {_percent(apart)} apart, and any error above "
        f"{_percent(seen)} would have been seen"
    )


def _compared(row: Row) -> tuple[str, ...]:
    """Status, quantity, both values, formula less FE and what is allowed, relative."""
    cells = [row.status.value, row.quantity, number(row.analytic), _reference(row),
             unit_text(row.unit)]  # fmt: skip
    if row.analytic is None or row.reference is None or not row.scale or row.kind is Kind.FACT:
        return (*cells, "", "")
    cells.append(_percent((row.analytic - row.reference) / row.scale, signed=True))
    if row.interval is not None:
        low, high = (_percent(m, signed=True) for m in row.interval)
        return (*cells, f"{low} to {high}")
    return (*cells, "" if row.tolerance is None else f"±{_percent(row.tolerance / row.scale)}")


def _reference(row: Row) -> str:
    return number(row.reference) + (f" ({row.by})" if row.by != "FE" else "")


def _causes(rows: Sequence[Row]) -> Mapping[tuple[Status, str, str], list[Row]]:
    found: dict[tuple[Status, str, str], list[Row]] = {}
    for row in rows:
        if row.status in LISTED:
            found.setdefault((row.status, row.case, row.reason), []).append(row)
    return found


def aligned(lines: Sequence[tuple[str, ...]]) -> list[str]:
    """Lines whose columns are as wide as their longest cell, powers raised."""
    shown = [tuple(map(raised, line)) for line in lines]
    wide = [max(map(len, column)) for column in zip(*shown, strict=True)]
    return ["  ".join(map(str.ljust, line, wide)).rstrip() for line in shown]


def raised(text: str) -> str:
    """10^-5 as 10⁻⁵, kg m^2 as kg m²."""
    return _POWER.sub(lambda match: match[1].translate(_RAISED), text)


def number(value: float | int | str | None) -> str:
    return "" if value is None else f"{value:.6g}" if isinstance(value, float) else str(value)


def unit_text(unit: str) -> str:
    return "" if unit == "1" else unit


def _percent(share: float, *, signed: bool = False) -> str:
    digits = ".0f" if abs(share) >= 0.995 else ".2g"
    return f"{100 * share:{'+' if signed else ''}{digits}} %"

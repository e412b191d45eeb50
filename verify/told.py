"""What the commands print: verdicts of a run, and how one's own parameters fare."""

import re
from collections.abc import Sequence

from verify.console_rows import (
    causes,
    closing,
    number,
    row_cells,
    shown_rows,
    title,
    unit_of,
)
from verify.dynamic import DynamicResult
from verify.results import CaseResult, Report, Row, Status
from verify.shown import FormulaValue

_POWER = re.compile(r"(?<=[\w)])\^(-?\d+)")
_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


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
    for (status, case_id, reason), rows in causes(report.rows).items():
        more = f" and {len(rows) - 1} more" if len(rows) > 1 else ""
        print(raised(f"{status.value:10} {case_id}: {rows[0].quantity}{more}: {reason}"))
    print(f"{len(report.rows)} rows")


def print_check(
    result: CaseResult, *, use_fem: bool, dynamic: DynamicResult | None = None, offered: str = ""
) -> None:
    """What was found in words, inputs, formula values, the judged rows in short, warnings last.

    `offered` is what `--dynamic` would add where it was not asked for.
    """
    print(f"{result.name}: {result.title} ({result.id})")
    findings = dynamic.after(result.findings) if dynamic else result.findings
    for found in findings:
        print(raised(f"  {found}"))
    if findings:
        print("inputs")
    for line in aligned([(i.symbol, number(i.value), unit_of(i.unit), i.what)
                          for i in result.inputs]):  # fmt: skip
        print(f"  {line}")
    print("formulas")
    for line in aligned([_value(v) for v in result.values]):
        print(f"  {line}")
    if dynamic:
        print(dynamic.what)
        for line in aligned([_value(v) for v in dynamic.values]):
            print(f"  {line}")
    elif offered:
        print(f"(check --dynamic adds {offered})")
    if use_fem:
        _print_rows(result.rows)
    elif result.refused:
        print(f"(no check --fem here: {result.refused})")
    else:
        print("(check --fem judges what is marked * with finite elements)")
    for warning in result.warnings:
        print(raised(f"warning: {warning}"))


def _print_rows(rows: Sequence[Row]) -> None:
    print(title(rows))
    for line in aligned(row_cells(rows)):
        print(f"  {line}")
    for (status, _, reason), group in causes(shown_rows(rows)).items():
        more = f" and {len(group) - 1} more" if len(group) > 1 else ""
        print(raised(f"{status.value} {group[0].quantity}{more}: {reason}"))
    for sentence in closing(rows):
        print(raised(sentence))


def _value(v: FormulaValue) -> tuple[str, ...]:
    return v.symbol, f"{v.value:.6g}", unit_of(v.unit), f"{v.what}{' *' if v.judged else ''}"


def aligned(lines: Sequence[tuple[str, ...]]) -> list[str]:
    """Lines whose columns are as wide as their longest cell, powers raised."""
    shown = [tuple(map(raised, line)) for line in lines]
    wide = [max(map(len, column)) for column in zip(*shown, strict=True)]
    return ["  ".join(map(str.ljust, line, wide)).rstrip() for line in shown]


def raised(text: str) -> str:
    """10^-5 as 10⁻⁵, kg m^2 as kg m²."""
    return _POWER.sub(lambda match: match[1].translate(_RAISED), text)

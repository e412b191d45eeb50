"""What the commands do, apart from reading the command line."""

import json
import math
import shlex
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from verify import cache, environment, units
from verify.case import Case
from verify.cases.registry import CASES, find
from verify.inputs import REQUIRED, InputError, Inputs, build, meta, read_parameter_file
from verify.results import CaseResult, Report, Row, Status
from verify.run import Job
from verify.solving import solve

ROOT = Path(__file__).parent.parent
BAD = (Status.FAIL, Status.SKIP)


def run_list() -> int:
    """Print each case with its subject and its inputs, their units, and which may be left out."""
    for case in CASES:
        needed: list[str] = []
        optional: list[str] = []
        for name, field in case.inputs.model_fields.items():
            unit = meta(field)["unit"]
            text = name if unit == "1" else f"{name} [{unit}]"
            (needed if meta(field)["omitted"] == REQUIRED else optional).append(text)
        print(f"{case.id:20} {case.title} ({case.paper}, {case.place})")
        print(f"{'':20} inputs: {', '.join(needed)}")
        if optional:
            print(f"{'':20} optional: {', '.join(optional)}")
    return 0


def run_verify(
    names: Sequence[str], *, quick: bool, jobs: int, out: Path | None, use_cache: bool
) -> int:
    """Run the cases on the paper's numbers, write the report and print the verdicts."""
    cases = [find(name) for name in dict.fromkeys(names)] or list(CASES)
    out = out or ROOT / "reports" / "out"
    _writable(out)
    start = time.perf_counter()
    work = [
        Job(case, case.inputs(), skip="" if case.quick or not quick else "quick") for case in cases
    ]
    results = solve(work, jobs, use_cache)
    report = make_report(results, cases, time.perf_counter() - start)
    _print_verdicts(report)
    page = _write(report, out, use_cache)
    print(f"report: {page} ({time.perf_counter() - start:.1f} s)")
    if any(case.errors for case in report.cases):
        print(f"tracebacks: {out / 'errors.txt'}")
    failed = any(
        row.status is Status.FAIL or (row.status is Status.SKIP and not quick)
        for row in report.rows
    )
    return 1 if failed else 0


def run_check(
    path: Path, *, use_fem: bool, as_json: bool, jobs: int, use_cache: bool, out: Path | None
) -> int:
    """Formulas, warnings and, if asked for, finite elements and a report on a user's parameters."""
    name, case, inputs = load(path)
    if out is not None:
        _writable(out)
    start = time.perf_counter()
    job = Job(case, inputs, use_fem=use_fem)
    (result,) = solve([job], jobs, use_cache, quiet=as_json)
    values = case.analytic(inputs)
    if as_json:
        print(json.dumps(_check_json(name, case, result, values, use_fem), ensure_ascii=False))
    else:
        _print_check(name, case, result, values, use_fem)
    if out is not None:
        command = f"freewheel check {'--fem ' if use_fem else ''}{shlex.quote(path.name)}"
        mine = replace(result, name=name, command=command)
        report = make_report([mine], [case], time.perf_counter() - start, name)
        page = _write(report, out, use_cache)
        print(f"report: {page}", file=sys.stderr if as_json else sys.stdout)
    return 1 if any(row.status in BAD for row in result.rows) else 0


def _writable(out: Path) -> None:
    """Make the folder; a read-only place is found before the work."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=out):
            pass
    except OSError as error:
        raise InputError(f"{out}: cannot be written: {error.strerror}") from error


def _write(report: Report, out: Path, use_cache: bool) -> Path:
    """Write the report into `out` and say what had to be done in another way; the page."""
    from reports.write import write  # only the command line knows reports

    drawn = cache.picture_folder() if use_cache else None
    hint = environment.remedy_for_pictures().removeprefix("; ")
    written = write(report, out, cache=drawn, hint=hint)
    for remark in written.remarks:
        print(f"freewheel: {remark}", file=sys.stderr)
    return written.page


def load(path: Path) -> tuple[str, Case, Inputs]:
    """Name, case and inputs of a parameter file; InputError says in one line what is wrong."""
    case_id, name, raw = read_parameter_file(path)
    try:
        case = find(case_id)
    except ValueError as error:
        raise InputError(f"{path}: case: {error}") from error
    inputs = build(case.inputs, raw, str(path))
    try:
        with np.errstate(over="raise", divide="raise", invalid="raise"):
            values = case.analytic(inputs)
    except (ValueError, ArithmeticError) as error:
        raise InputError(f"{path}: inputs: {error}") from error
    if wild := [key for key, value in values.items() if not math.isfinite(value)]:
        raise InputError(f"{path}: inputs: {wild[0]} is not finite with these inputs")
    return name, case, inputs


def make_report(
    results: list[CaseResult], cases: Sequence[Case], seconds: float, name: str = ""
) -> Report:
    """A run with the ledgers and its provenance; `name` is that of a user's own parameters."""
    from verify.ledgers import ledgers
    from verify.provenance import provenance

    return Report(
        cases=tuple(results),
        provenance=provenance(ROOT, results, seconds),
        name=name,
        **ledgers(results, cases),
    )


def _print_verdicts(report: Report) -> None:
    from rich.console import Console
    from rich.table import Table

    console = Console()
    table = Table("case", "rows", *(s.value for s in Status), box=None, pad_edge=False)
    for case in report.cases:
        count = Counter(row.status for row in case.rows)
        table.add_row(case.id, str(len(case.rows)), *(str(count[s] or "·") for s in Status))
    console.print(table)
    for row in report.rows:
        if row.status in (Status.FAIL, Status.SKIP, Status.SHOWN, Status.NOTE, Status.CALIBRATED):
            console.print(
                f"{row.status.value:10} {row.id}: {row.reason}", markup=False, highlight=False,
                soft_wrap=True,
            )  # fmt: skip
    console.print(f"{len(report.rows)} rows", highlight=False)


def _print_check(name: str, case: Case, result: CaseResult, values: Any, use_fem: bool) -> None:
    print(f"{name}: {case.title} ({case.id})")
    for entry in result.inputs:
        unit = "" if entry.unit == "1" else f" {entry.unit}"
        value = f"{entry.value:.6g}" if isinstance(entry.value, float) else entry.value
        print(f"  {entry.symbol:8} {value}{unit}   {entry.what}")
    print("formulas")
    for out in case.outputs:
        if out.key in values:
            shown = values[out.key] / units.factor(out.unit)
            unit = "" if out.unit == "1" else f" {out.unit}"
            mark = " *" if out.judged else ""
            print(f"  {out.symbol:8} {shown:.6g}{unit}   {out.what}{mark}")
    for warning in result.warnings:
        print(f"warning: {warning}")
    if use_fem:
        print("formulas against finite elements")
        for row in result.rows:
            print(f"  {row.status.value:5} {describe(row)}")
    else:
        print("(check --fem judges what is marked * with finite elements)")


def describe(row: Row) -> str:
    """One line: what was compared, by how much it differs, what was allowed."""
    unit = "" if row.unit == "1" else f" {row.unit}"
    parts = [row.quantity]
    if row.analytic is not None:
        parts.append(f"formula {row.analytic:.6g}{unit}")
    if row.fem is not None:
        parts.append(f"FE {row.fem:.6g}{unit}")
    if row.difference is not None and row.tolerance is not None and row.scale:
        parts.append(
            f"difference {row.difference / row.scale:+.1e}, U {row.tolerance / row.scale:.1e}"
        )
    if row.interval is not None:
        parts.append(f"expected {row.interval[0]:+.1e} to {row.interval[1]:+.1e}")
    if row.reason:
        parts.append(row.reason)
    return "; ".join(parts)


def _check_json(
    name: str, case: Case, result: CaseResult, values: Any, use_fem: bool
) -> dict[str, Any]:
    from reports.records import row_record

    return {
        "name": name,
        "case": case.id,
        "inputs": {i.name: {"value": i.value, "unit": i.unit} for i in result.inputs},
        "values": [
            {"key": o.key, "symbol": o.symbol, "what": o.what, "unit": o.unit,
             "value": values[o.key] / units.factor(o.unit)}
            for o in case.outputs if o.key in values
        ],
        "warnings": list(result.warnings),
        "rows": [row_record(row) for row in result.rows] if use_fem else [],
    }  # fmt: skip

"""Stored regions of a case; a record is valid for unchanged code, inputs and scans."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cache as memoised
from typing import Any

import numpy as np

from verify.core import source_code, units
from verify.core.case import Case, Scan
from verify.core.figures import Array
from verify.core.inputs import Inputs, meta
from verify.jobs.records import Record, Records
from verify.judging import convergence
from verify.judging.judge import expanded
from verify.studies.sweep import outcome as outcomes
from verify.studies.sweep import pairs
from verify.studies.sweep.axes import changed
from verify.studies.sweep.outcome import Course, Outcome
from verify.studies.sweep.pairs import Pair, portion, selected, signature
from verify.studies.sweep.plan import Plan, grid
from verify.studies.sweep.point import code_of

RECORDS = Records("validity")
DIGITS = 4  # significant, of errors and their bars
ARITHMETIC = (outcomes, pairs, convergence)  # makes errors and their bars of solved points


@dataclass(frozen=True)
class Measured:
    """Results of each scan of a case, and the date of the measurement."""

    date: str
    scans: tuple[tuple[Plan, tuple[Course, ...]], ...]


def plans(case: Case) -> tuple[Plan, ...]:
    """Plans of the scans of a case around its default inputs.

    Raises InputError if a scan is invalid.
    """
    return tuple(
        grid(case, case.id, _held(case, scan), selected(case, scan.only), scan.vary, star=scan.star)
        for scan in case.scans
    )


def _held(case: Case, scan: Scan) -> Inputs:
    """Default inputs of the case, with the values that the scan sets."""
    inputs, values = case.inputs(), {}
    for text in scan.at:
        name, _, given = text.partition("=")
        values[name] = units.parse(given, meta(type(inputs).model_fields[name])["unit"])
    return changed(inputs, values)


def measured(case: Case) -> Measured | None:
    """Stored regions of `case`; None if code, inputs or scans have changed."""
    every = plans(case)

    def read(record: Record) -> Measured:
        scans = zip(every, record.content, strict=True)
        return Measured(record.date, tuple(
            (plan, tuple(_course(pair, scan[pair.name], len(plan.points)) for pair in plan.chosen))
            for plan, scan in scans
        ))  # fmt: skip

    return RECORDS.current(case.id, _made_by(case, every), read)


def keep(case: Case, outcomes: Sequence[Outcome]) -> None:
    """Store the results of all scans of a case.

    Raises OSError if the record cannot be written.
    """
    RECORDS.keep(case.id, _made_by(case, [one.solved.plan for one in outcomes]), [
        {course.pair.name: {
            "error": _short(course.error), "U": _short(course.U_error),
            "problems": _reasons(course.problems),
        } for course in one.courses}
        for one in outcomes
    ])  # fmt: skip


def _made_by(case: Case, every: Sequence[Plan]) -> dict[str, Any]:
    """All data on which the numbers depend: inputs, scans, comparisons, and sources."""
    return {
        "arithmetic": _arithmetic(),
        "inputs": case.inputs().model_dump(),
        "scans": [asdict(scan) for scan in case.scans],
        "pairs": [[signature(pair) for pair in plan.chosen] for plan in every],
        "code": [code_of(case, portion(case, plan.chosen)) for plan in every],
    }


@memoised
def _arithmetic() -> str:
    modules = source_code.group_hash([module.__name__ for module in ARITHMETIC])
    return f"{modules[:16]} {source_code.source_of(expanded)[:16]}"


def _short(values: Array) -> list[float | None]:
    return [float(f"{v:.{DIGITS}g}") if math.isfinite(v) else None for v in values]


def _reasons(problems: Sequence[str]) -> dict[str, list[int]]:
    """Row numbers of the points whose error was not computed, by reason."""
    found: dict[str, list[int]] = {}
    for n, reason in enumerate(problems):
        if reason:
            found.setdefault(reason, []).append(n)
    return found


def _course(pair: Pair, stored: Mapping[str, Any], points: int) -> Course:
    """Stored results of a pair; values of formula and finite elements are not stored."""
    error, U = (
        np.array([math.nan if v is None else float(v) for v in stored[key]])
        for key in ("error", "U")
    )  # fmt: skip
    if not len(error) == len(U) == points:
        raise ValueError(f"{pair.name}: {len(error)} stored values for {points} points")
    problems = [""] * points
    for reason, rows in dict(stored["problems"]).items():
        for n in rows:
            problems[n] = reason
    none = np.full(points, math.nan)
    return Course(
        pair=pair, formula=none, fe=none, U=none, error=error, U_error=U, problems=tuple(problems)
    )

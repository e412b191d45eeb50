"""One case: its levels are solved or taken from the cache, then all rows are judged.

An error inside a case gives a failed row of this case, with a traceback in the report folder.
"""

import shlex
import time
import traceback
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from verify.core.case import Case, Check, Context, FemResult, Values
from verify.core.inputs import Inputs
from verify.core.results import CaseResult, Grid, Row, Status
from verify.jobs import cache
from verify.jobs.guard import Guard, named, unsolved
from verify.papers.case_report import described

INDEPENDENT = (
    "the reference does not depend on the level: refine the mesh with `level`, or declare that it "
    "is exact, with the round-off of its numbers: solved(..., iteration=1e-12)"
)


@dataclass(frozen=True)
class Job:
    """A case with its inputs. If `use_fem` is False, only formulas are judged.

    `values` are known results of the formulas, if any; without `drawn`, no figure is made.
    """

    case: Case
    inputs: Inputs
    use_fem: bool = True
    values: Values | None = None
    drawn: bool = True

    @property
    def is_paper(self) -> bool:
        """Whether the inputs are the default inputs, to which printed numbers refer."""
        return self.inputs == type(self.inputs)()


@dataclass(frozen=True)
class Solved:
    """One level: its result, or the reason why it failed (one line) and the traceback.

    `unstored` is the reason if the cache could not store the result.
    """

    result: FemResult | None
    failure: str
    seconds: float
    cached: bool
    trace: str = ""
    unstored: str = ""


def judge_case(job: Job, levels: Sequence[Solved]) -> CaseResult:
    """Judged result of one job from its solved levels, which are in order from coarse to fine."""
    guard = Guard(job.case)
    values = guard.values(job.inputs) if job.values is None else job.values
    no_formulas = "".join(row.reason for row in guard.rows)
    results = [s.result for s in levels if s.result is not None]
    context = Context(job.case.id, job.inputs, values, results, job.is_paper)
    failure = next((s.failure for s in levels if s.failure), "")
    rows: list[Row] = []
    for check in job.case.checks:
        if check.paper_only and not job.is_paper:
            continue
        reason = no_formulas or (failure if check.needs_fem else "")
        judge = partial(_judged, check, context, job)
        rows += guard.red(check, reason) if reason else guard.judged(check, judge)
    if failure and not any(check.needs_fem for check in job.case.checks):
        rows.append(guard.row("finite elements", failure))
    case = guard.silent() if no_formulas else guard.guarded()
    shown = described(case if job.drawn else replace(case, figures=lambda _: ()), context)
    traces = (*(s.trace for s in levels if s.trace), *guard.traces)
    return CaseResult(
        **shown, rows=(*rows, *guard.rows), seconds=sum(s.seconds for s in levels),
        cached=all(s.cached for s in levels), errors=traces,
        cells={f.name: len(f.cells) for f in shown["fields"]},
        command=f"freewheel verify {shlex.quote(job.case.named)}",
    )  # fmt: skip


def _judged(check: Check, context: Context, job: Job) -> list[Row]:
    if check.needs_fem and not job.use_fem:
        return []
    try:
        rows = [replace(row, method=job.case.method.alone) for row in check.rows(context)]
    except KeyError as error:
        if reason := _without(context, check, error.args[0]):
            raise ValueError(reason) from error
        raise
    all_same = (job.is_paper or job.case.file) and ignores_level(context.fem)
    return [
        replace(row, status=Status.FAIL, reason=INDEPENDENT)
        if row.grid and (all_same or (job.case.file and is_constant(row.grid)))
        else row
        for row in rows
    ]


def ignores_level(levels: Sequence[FemResult]) -> bool:
    """Whether all numbers and arrays are the same on every level.

    It is False if an uncertainty of iteration or round-off is stated. Cases of the suite may have
    single numbers that are the same on every level, such as a formula that is drawn point by point.
    """
    first, *others = levels or (None,)
    if first is None or not others or any(any(one.u_it.values()) for one in levels):
        return False
    return all(
        one.values == first.values
        and one.arrays.keys() == first.arrays.keys()
        and all(np.array_equal(one.arrays[key], first.arrays[key]) for key in first.arrays)
        for one in others
    )


def is_constant(grid: Grid) -> bool:
    """Whether a quantity of a user's case is the same on every level.

    It is False for zero, for a whole number without a unit (a count), and if an uncertainty of
    iteration or round-off is stated.
    """
    values = {value for _, value in grid.levels}
    if len(grid.levels) < 2 or len(values) > 1 or grid.u_it:
        return False
    (value,) = values
    return value != 0 and not (grid.unit == "1" and value.is_integer())


def _without(context: Context, check: Check, key: object) -> str:
    """Message that the formulas or the reference lack the number `key`.

    The result is "" if `check` does not use this number.
    """
    if not any(isinstance(name, str) and name == key for name in vars(check).values()):
        return ""
    if key not in context.analytic:
        return f"the formulas have no value of {key}, or it is nan or inf"
    if any(key not in level.values for level in context.fem):
        level = context.fem[-1]
        if key in level.arrays:
            return f"the reference has {key} as an array, not as a number"
        others = f"; its values are {', '.join(level.values)}" if level.values else ""
        return f"the reference has no value of {key}{others}"
    return ""


def solve_level(case: Case, inputs: Inputs, level: int, folder: Path | None) -> Solved:
    """Load one level from the cache, or compute and store it. An error becomes a failure."""
    start = time.perf_counter()
    if folder is not None and (found := cache.load(folder, case, inputs, level)) is not None:
        return Solved(found, "", time.perf_counter() - start, cached=True)
    try:
        result = case.reference(inputs, level)
    except Exception as error:  # gmsh raises Exception itself
        seconds = time.perf_counter() - start
        if unsolved(error):
            failure = f"not converged: level {level}: {' '.join(str(error).split())}"
            return Solved(None, failure, seconds, cached=False)
        failure, trace = f"level {level}: {named(error)}", traceback.format_exc()
        return Solved(None, failure, seconds, cached=False, trace=trace)
    seconds = time.perf_counter() - start
    unstored = "" if folder is None else keep_level(folder, case, inputs, level, result)
    return Solved(result, "", seconds, cached=False, unstored=unstored)


def keep_level(folder: Path, case: Case, inputs: Inputs, level: int, result: FemResult) -> str:
    """Store a result in the cache and return "", or the reason why it could not be stored."""
    try:
        cache.store(folder, case, inputs, level, result)
    except OSError as error:
        return str(error)
    return ""

"""Run cases: finite elements over levels and processes, through the cache, then the judging."""

import time
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ProcessPoolExecutor, wait
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from verify import cache
from verify.case import Case, Context, FemResult
from verify.described import described
from verify.inputs import Inputs
from verify.results import CaseResult, Row, Status

Progress = Callable[[str, int, int], None]


@dataclass(frozen=True)
class Job:
    """A case with the inputs to run it on; `use_fem` False judges the formulas alone."""

    case: Case
    inputs: Inputs
    use_fem: bool = True
    skip: str = ""

    @property
    def is_paper(self) -> bool:
        """Whether the inputs are the defaults, of which the printed numbers speak."""
        return self.inputs == type(self.inputs)()


@dataclass(frozen=True)
class Solved:
    """One level: its result, or why there is none."""

    result: FemResult | None
    failure: str
    seconds: float
    cached: bool


def run(
    jobs: Sequence[Job],
    *,
    processes: int = 1,
    cache_folder: Path | None = None,
    progress: Progress = lambda _what, _done, _total: None,
) -> list[CaseResult]:
    """Solve what the cache does not hold and judge every job; results in the order of `jobs`."""
    tasks = [
        (i, level) for i, job in enumerate(jobs) if job.use_fem and not job.skip
        for level in job.case.levels
    ]  # fmt: skip
    tasks.sort(key=lambda task: -task[1])  # the finest levels first: they take longest
    solved: dict[tuple[int, int], Solved] = {}
    for n, (task, result) in enumerate(_solve_all(jobs, tasks, processes, cache_folder)):
        solved[task] = result
        progress(f"{jobs[task[0]].case.id} level {task[1]}", n + 1, len(tasks))
    return [
        judge_case(job, [solved[i, level] for level in job.case.levels if (i, level) in solved])
        for i, job in enumerate(jobs)
    ]


def judge_case(job: Job, levels: Sequence[Solved]) -> CaseResult:
    """All rows, tables and pictures of one job from its solved levels, coarse to fine."""
    case, q = job.case, job.inputs
    values = case.analytic(q)
    failures = [s.failure for s in levels if s.failure]
    results = [s.result for s in levels if s.result is not None]
    context = Context(case.id, q, values, results, job.is_paper)
    rows: list[Row] = []
    for check in case.checks:
        if check.paper_only and not job.is_paper:
            continue
        if not check.needs_fem:
            rows += check.rows(context)
        elif job.skip:
            rows += check.skipped(case.id, job.skip)
        elif failures:
            rows += [_failed(row, failures[0]) for row in check.skipped(case.id, "")]
        elif job.use_fem:
            rows += check.rows(context)
    return CaseResult(
        **described(case, context), rows=tuple(rows), seconds=sum(s.seconds for s in levels),
        cached=all(s.cached for s in levels), command=f"freewheel verify {case.id}",
    )  # fmt: skip


def solve_level(case: Case, inputs: Inputs, level: int, folder: Path | None) -> Solved:
    """One level, from the cache or computed and stored; a solver's error becomes a failure."""
    start = time.perf_counter()
    if folder is not None and (found := cache.load(folder, case, inputs, level)) is not None:
        return Solved(found, "", time.perf_counter() - start, cached=True)
    try:
        result = case.fem(inputs, level)
    except (ValueError, ArithmeticError, RuntimeError, MemoryError) as error:
        failure = f"level {level}: {' '.join(str(error).split()) or type(error).__name__}"
        return Solved(None, failure, time.perf_counter() - start, cached=False)
    seconds = time.perf_counter() - start
    if folder is not None:
        cache.store(folder, case, inputs, level, result)
    return Solved(result, "", seconds, cached=False)


def _solve_all(
    jobs: Sequence[Job], tasks: list[tuple[int, int]], processes: int, folder: Path | None
) -> Iterable[tuple[tuple[int, int], Solved]]:
    waiting = []
    for i, level in tasks:
        job = jobs[i]
        start = time.perf_counter()
        found = cache.load(folder, job.case, job.inputs, level) if folder else None
        if found is not None:
            yield (i, level), Solved(found, "", time.perf_counter() - start, cached=True)
        else:
            waiting.append((i, level))
    if processes == 1 or len(waiting) < 2:
        for i, level in waiting:
            yield (i, level), solve_level(jobs[i].case, jobs[i].inputs, level, folder)
        return
    # spawn: a forked child would share gmsh's state
    with ProcessPoolExecutor(min(processes, len(waiting)), get_context("spawn")) as pool:
        yield from _drain(pool, jobs, waiting, folder)


def _drain(
    pool: Executor, jobs: Sequence[Job], waiting: list[tuple[int, int]], folder: Path | None
) -> Iterable[tuple[tuple[int, int], Solved]]:
    running: dict[Future[Solved], tuple[int, int]] = {
        pool.submit(_remote, jobs[i].case.id, jobs[i].inputs.model_dump(), level, folder): (
            i,
            level,
        )
        for i, level in waiting
    }
    try:
        while running:
            done, _ = wait(running, return_when=FIRST_COMPLETED)
            for future in done:
                yield running.pop(future), future.result()
    finally:
        for future in running:
            future.cancel()


def _remote(case_id: str, inputs: dict[str, Any], level: int, folder: Path | None) -> Solved:
    from verify.cases.registry import find  # a spawned process knows no cases yet

    case = find(case_id)
    return solve_level(case, case.inputs(**inputs), level, folder)


def _failed(row: Row, reason: str) -> Row:
    from dataclasses import replace

    return replace(row, status=Status.FAIL, reason=f"not converged: {reason}")

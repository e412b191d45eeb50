"""The levels of all jobs: from the cache, or on processes with the longest first, then judged."""

import time
from collections import deque
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from verify.core import source_memory
from verify.core.case import Case
from verify.core.environment import require_gmsh
from verify.core.inputs import Inputs
from verify.core.progress import Show
from verify.core.results import CaseResult
from verify.jobs import cache
from verify.jobs import timing as durations
from verify.jobs.dispatch import Dispatch
from verify.jobs.engine import Engine
from verify.jobs.executor import Lost, local
from verify.jobs.level import Job, Solved, judge_case, keep_level, solve_level


@dataclass(frozen=True)
class Task:
    """One level to solve, the `number`th; it reaches another process by the name of its case."""

    case: Case
    inputs: Inputs
    level: int
    folder: Path | None
    number: int = 0

    def __reduce__(self) -> tuple[Any, ...]:
        rest = self.inputs, self.level, self.folder, self.number
        return _named_task, (Case.finder, self.case.id, *rest)


def _named_task(find: Callable[[str], Case], case_id: str, *rest: Any) -> Task:
    """The task of a case that another process finds by its id: its functions do not pickle."""
    return Task(find(case_id), *rest)


def solve_task(task: Task) -> Solved:
    """One level, in whatever process."""
    if task.folder is not None:
        source_memory.use(task.folder)
    return solve_level(task.case, task.inputs, task.level, task.folder)


def run(
    jobs: Sequence[Job],
    *,
    engine: AbstractContextManager[Engine] | None = None,
    cache_folder: Path | None = None,
    show: Show = lambda _state: None,
    warn: Callable[[str], None] = lambda _message: None,
) -> list[CaseResult]:
    """Solve what the cache does not hold and judge every job; results in the order of `jobs`.

    OSError names what is missing where gmsh cannot start and something is to be solved.
    `engine` is entered where something is to be solved; without one this process does. `show`
    follows the state, `warn` takes what the user should know of at once.
    """
    wanted = [
        (i, level) for i, job in enumerate(jobs) if job.use_fem
        for level in job.case.levels
    ]  # fmt: skip
    solved = {n: found for n in wanted if (found := _stored(jobs[n[0]], n[1], cache_folder))}
    missing = [n for n in wanted if n not in solved]
    tasks = [
        Task(jobs[i].case, jobs[i].inputs, level, cache_folder, n)
        for n, (i, level) in enumerate(missing)
    ]
    if tasks:
        require_gmsh()  # a machine without its libraries is no red row
        source_memory.share()
        levels = _Levels(tasks, known=len(solved), show=show, warn=warn)
        levels.solve(engine or local(0))
        solved |= {missing[n]: answer for n, answer in levels.solved.items()}
    return [
        judge_case(job, [solved[i, level] for level in job.case.levels if (i, level) in solved])
        for i, job in enumerate(jobs)
    ]


def _stored(job: Job, level: int, folder: Path | None) -> Solved | None:
    if folder is None:
        return None
    start = time.perf_counter()
    found = cache.load(folder, job.case, job.inputs, level)
    if found is None:
        return None
    return Solved(found, "", time.perf_counter() - start, cached=True)


class _Levels:
    """Tasks, solved longest first; each tells how long the others will take."""

    def __init__(
        self, tasks: Sequence[Task], *, known: int, show: Show, warn: Callable[[str], None]
    ) -> None:
        self.tasks, self.warn = tasks, warn
        self.folder = tasks[0].folder
        self.earlier = durations.load(self.folder) if self.folder else {}
        self.measured: dict[durations.Level, float] = {}
        self.solved: dict[int, Solved] = {}
        seconds = self._expected()
        self.waiting = deque(sorted(tasks, key=lambda task: -seconds[_level(task)]))
        self.dispatch = Dispatch(
            "refinement levels", known + len(tasks), known, show,
            title=lambda task: "{} level {}".format(*_level(task)), remaining=self._remaining,
        )  # fmt: skip

    def solve(self, engine: AbstractContextManager[Engine]) -> None:
        """Solve all, into `solved` by their numbers."""
        self.dispatch.run(engine, solve_task, self._take, self._receive)

    def _take(self) -> Task | None:
        if not self.waiting:
            return None
        remote = self.dispatch.drive.engine.remote
        return replace(self.waiting.popleft(), folder=None if remote else self.folder)

    def _receive(self, task: Task, answer: Solved | Lost) -> int:
        if isinstance(answer, Lost):
            failure = f"level {task.level}: {answer.reason}"
            answer = Solved(None, failure, 0.0, cached=False, trace=answer.trace)
        self.solved[task.number] = answer
        if answer.result is not None and not answer.cached:
            self.measured[_level(task)] = answer.seconds
        if not self._keep(task, answer):
            self.dispatch.unstored += 1
        return 1

    def _keep(self, task: Task, answer: Solved) -> bool:
        """See that the result of a task is in the store; where there is no room, warn once."""
        if answer.result is None or self.folder is None:
            return False
        unstored = answer.unstored
        if self.dispatch.drive.engine.remote:
            unstored = keep_level(self.folder, task.case, task.inputs, task.level, answer.result)
        if not answer.cached:
            with suppress(OSError):  # an estimate is no reason to stop
                durations.store(self.folder, {_level(task): answer.seconds})
        if unstored:
            self.warn(f"{unstored}: going on without")
            self.folder = None
        return not unstored

    def _expected(self) -> dict[durations.Level, float]:
        known = durations.refined(self.earlier, self.measured)
        return durations.expected_seconds(map(_level, self.tasks), known)

    def _remaining(self, dispatch: Dispatch) -> float:
        seconds, now = self._expected(), time.monotonic()
        under_way = [(seconds[_level(task)], now - start) for task, start in dispatch.under_way]
        waiting = [seconds[_level(task)] for task in self.waiting]
        return durations.remaining_seconds(under_way, waiting, dispatch.workers)


def _level(task: Task) -> durations.Level:
    return task.case.id, task.level

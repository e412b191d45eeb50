"""The levels of all jobs: from the cache, or on processes with the longest first, then judged."""

import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from verify.core.case import Case
from verify.core.environment import require_gmsh
from verify.core.inputs import Inputs
from verify.core.progress import Show, State
from verify.core.results import CaseResult
from verify.jobs import cache
from verify.jobs import timing as durations
from verify.jobs.engine import Engine
from verify.jobs.executor import Drive, Lost, local
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
        (i, level) for i, job in enumerate(jobs) if job.use_fem and not job.skip
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
        with engine or local(0) as entered:
            remaining = Round(tasks, engine=entered, done=len(solved), show=show, warn=warn)
            solved |= {missing[n]: answer for n, answer in remaining.solve()}
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


class Round:
    """Solves tasks, longest first, and learns from each how long the others will take."""

    def __init__(
        self, tasks: Sequence[Task], *, engine: Engine, done: int, show: Show,
        warn: Callable[[str], None],
    ) -> None:  # fmt: skip
        self.tasks, self.show, self.warn = tasks, show, warn
        self.done, self.total = done, done + len(tasks)
        self.folder = tasks[0].folder if tasks else None
        self.earlier = durations.load(self.folder) if self.folder else {}
        self.measured: dict[durations.Level, float] = {}
        self.drive = Drive(engine, solve_task)

    def solve(self) -> Iterator[tuple[int, Solved]]:
        """Position and answer of each task as they come."""
        seconds = self._expected()
        order = sorted(range(len(self.tasks)), key=lambda n: -seconds[self._level(n)])
        waiting = deque(order)

        def turns() -> Iterator[Task]:
            while waiting:
                yield replace(
                    self.tasks[waiting.popleft()],
                    folder=None if self.drive.engine.remote else self.folder,
                )

        for event in self.drive.answers(turns()):
            if event is not None:
                task, answer = event
                self.done += 1
                yield task.number, self._learnt(task.number, answer)
            self.show(self._state(waiting))

    def _learnt(self, n: int, answer: Solved | Lost) -> Solved:
        task = self.tasks[n]
        if isinstance(answer, Lost):
            failure = f"level {task.level}: {answer.reason}"
            return Solved(None, failure, 0.0, cached=False, trace=answer.trace)
        if self.drive.engine.remote and answer.result is not None and self.folder is not None:
            stored = keep_level(self.folder, task.case, task.inputs, task.level, answer.result)
            answer = replace(answer, unstored=stored)
        if not answer.cached and not answer.failure:
            self.measured[self._level(n)] = answer.seconds
            if self.folder is not None:
                with suppress(OSError):  # an estimate is no reason to stop
                    durations.store(self.folder, self.measured)
        if answer.unstored and self.folder is not None:
            self.warn(f"cannot store in {self.folder} ({answer.unstored}): going on without")
            self.folder = None
        return answer

    def _level(self, n: int) -> durations.Level:
        return self.tasks[n].case.id, self.tasks[n].level

    def _expected(self) -> dict[durations.Level, float]:
        known = durations.refined(self.earlier, self.measured)
        return durations.expected_seconds(map(self._level, range(len(self.tasks))), known)

    def _state(self, waiting: Iterable[int]) -> State:
        seconds, now = self._expected(), time.monotonic()
        running = [task.number for task, _ in self.drive.running.values()]
        under_way = [
            (seconds[self._level(task.number)], now - start)
            for task, start in self.drive.running.values()
        ]
        left = durations.remaining_seconds(
            under_way, [seconds[self._level(n)] for n in waiting], self.drive.engine.workers()
        )
        names = tuple("{} level {}".format(*self._level(n)) for n in running)
        return State(self.done, self.total, names, left)

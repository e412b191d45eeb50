"""Runs all jobs: levels are loaded or solved in processes, then the cases are judged."""

import time
from collections import Counter, deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from dataclasses import replace
from pathlib import Path

from verify.core import source_memory
from verify.core.environment import require_gmsh
from verify.core.progress import Show
from verify.core.results import CaseResult
from verify.jobs import cache
from verify.jobs import timing as durations
from verify.jobs.dispatch import Dispatch
from verify.jobs.engine import Engine
from verify.jobs.executor import Lost, local
from verify.jobs.level import Job, Solved, judge_case, keep_level
from verify.jobs.tasks import Judging, Task, do, load

FEW = 3  # cases without a level to solve that this process judges: others take a second to start
JUDGED = 0.3  # s that a case takes to be judged


def run(
    jobs: Sequence[Job],
    *,
    engine: AbstractContextManager[Engine] | None = None,
    cache_folder: Path | None = None,
    judged: Callable[[CaseResult], None] | None = None,
    show: Show = lambda _state: None,
    warn: Callable[[str], None] = lambda _message: None,
) -> list[CaseResult]:
    """Solve levels that are not in the cache, and judge every job.

    Returns the results in the order of `jobs`.

    `engine` is entered if levels must be solved; without an engine, this process solves them.
    `show` receives the state, `warn` receives warnings for immediate display. With `judged`, cases
    are also judged on the engine as soon as their levels are stored; each result is passed to
    `judged`. Raises OSError with the name of the missing library if gmsh cannot start and a level
    must be solved.
    """
    many = bool(judged and cache_folder and len(jobs) > FEW)
    with _begun(engine or local(0), jobs) if many else nullcontext(engine or local(0)) as place:
        wanted = [
            (i, level) for i, job in enumerate(jobs) if job.use_fem
            for level in job.case.levels
        ]  # fmt: skip
        solved = {n: found for n in wanted if (found := _stored(jobs[n[0]], n[1], cache_folder))}
        tasks = [
            Task(jobs[i].case, jobs[i].inputs, level, cache_folder, i)
            for i, level in wanted if (i, level) not in solved
        ]  # fmt: skip
        work = _Work(jobs, tasks, solved, cache_folder, judged, show=show, warn=warn)
        if tasks:
            require_gmsh()  # missing libraries of the machine are no failed row
        if tasks or many:
            source_memory.share()
            work.do(place)
    return [work.judged.get(i) or judge_case(job, work.levels(i)) for i, job in enumerate(jobs)]


@contextmanager
def _begun(
    engine: AbstractContextManager[Engine], jobs: Sequence[Job]
) -> Iterator[AbstractContextManager[Engine]]:
    """Enter the engine; its workers import the cases while this process searches the store."""
    with engine as entered:
        for _ in range(entered.workers()):
            entered.executor.submit(load, [job.case.id for job in jobs])
        yield nullcontext(entered)


def _stored(job: Job, level: int, folder: Path | None) -> Solved | None:
    if folder is None:
        return None
    start = time.perf_counter()
    found = cache.load(folder, job.case, job.inputs, level)
    if found is None:
        return None
    return Solved(found, "", time.perf_counter() - start, cached=True)


class _Work:
    """Levels to solve and cases to judge, with an estimate of the remaining time."""

    def __init__(
        self, jobs: Sequence[Job], tasks: Sequence[Task], solved: dict[tuple[int, int], Solved],
        folder: Path | None, hand_over: Callable[[CaseResult], None] | None, *, show: Show,
        warn: Callable[[str], None],
    ) -> None:  # fmt: skip
        self.jobs, self.tasks, self.solved = jobs, tasks, solved
        self.folder, self.hand_over, self.warn = folder, hand_over, warn
        self.judged: dict[int, CaseResult] = {}
        self.earlier = durations.usual() | (durations.load(folder) if folder else {})
        self.measured: dict[durations.Level, float] = {}
        self.left = Counter(task.job for task in tasks)
        self.waiting: deque[Task | Judging] = deque(self._by_case())
        self.dispatch = Dispatch(
            "refinement levels", len(solved) + len(tasks), len(solved), show, title=str,
            remaining=self._remaining,
        )  # fmt: skip

    def do(self, engine: AbstractContextManager[Engine]) -> None:
        """Solve all levels; judge the cases whose levels are stored."""
        for i in range(len(self.jobs)):
            self._judge_if_solved(i)
        self.dispatch.run(engine, do, self._take, self._receive)

    def levels(self, job: int) -> list[Solved]:
        """Solved levels of a job, coarse to fine."""
        known = ((job, level) for level in self.jobs[job].case.levels)
        return [self.solved[one] for one in known if one in self.solved]

    def _by_case(self) -> list[Task]:
        """Tasks in order of cases, longest levels first.

        Thus, cases can be judged and their figures drawn while levels of other cases are solved.
        """
        seconds = self._expected()
        longest: dict[int, float] = {}
        for task in self.tasks:
            longest[task.job] = max(longest.get(task.job, 0.0), seconds[_level(task)])
        return sorted(
            self.tasks, key=lambda task: (-longest[task.job], task.job, -seconds[_level(task)])
        )

    def _take(self) -> Task | Judging | None:
        if not self.waiting:
            return None
        task = self.waiting.popleft()
        if isinstance(task, Judging):
            return task
        return replace(task, folder=None if self._is_remote else self.folder)

    @property
    def _is_remote(self) -> bool:
        return self.dispatch.drive.engine.remote

    def _receive(self, task: Task | Judging, answer: Solved | CaseResult | Lost | None) -> int:
        if isinstance(task, Judging):
            if isinstance(answer, CaseResult):  # otherwise it is judged here, with the same outcome
                self.judged[task.job] = answer
                assert self.hand_over is not None
                self.hand_over(answer)
            return 0
        if isinstance(answer, Lost):
            failure = f"level {task.level}: {answer.reason}"
            answer = Solved(None, failure, 0.0, cached=False, trace=answer.trace)
        assert isinstance(answer, Solved)
        self.solved[task.job, task.level] = answer
        self.left[task.job] -= 1
        if answer.result is not None and not answer.cached:
            self.measured[_level(task)] = answer.seconds
        if not self._keep(task, answer):
            self.dispatch.unstored += 1
        self._judge_if_solved(task.job)
        return 1

    def _judge_if_solved(self, i: int) -> None:
        """Make judging of a case the next task if all its levels are solved and stored."""
        job, known = self.jobs[i], self.levels(i)
        if self.hand_over is None or self.folder is None or self.left[i]:
            return
        if any(one.unstored for one in known):
            return
        levels = tuple(
            (n, replace(one, result=None)) for n, one in zip(job.case.levels, known, strict=True)
        )
        self.waiting.appendleft(Judging(job.case, job.inputs, self.folder, i, levels))

    def _keep(self, task: Task, answer: Solved) -> bool:
        """Return whether the result of a task is in the store. If the disk is full, warn once."""
        if answer.result is None or self.folder is None:
            return False
        unstored = answer.unstored
        if self._is_remote:
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
        expected, now = self._expected(), time.monotonic()

        def seconds(task: Task | Judging) -> float:
            return JUDGED if isinstance(task, Judging) else expected[_level(task)]

        under_way = [(seconds(task), now - start) for task, start in dispatch.under_way]
        waiting = [seconds(task) for task in self.waiting]
        if self.hand_over is not None:
            waiting += [JUDGED for count in self.left.values() if count]
        return durations.remaining_seconds(under_way, waiting, dispatch.workers)


def _level(task: Task) -> durations.Level:
    return task.case.id, task.level

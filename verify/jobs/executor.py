"""Executors of tasks: this process, processes of this machine, or a dask cluster.

An engine is an executor of concurrent.futures with further data. `Drive` runs tasks on any engine:
it submits a few tasks in advance, repeats tasks of dead processes once, and regularly returns
control to the caller.
"""

import os
import re
import time
import traceback
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor, Future
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, field
from typing import Any

from verify.core.inputs import InputError
from verify.jobs.engine import Engine, GoneError
from verify.jobs.guard import named
from verify.jobs.processes import Processes, RemoteTraceback

TICK = 0.25  # s between two checks of the caller if nothing happens in a run
MOST_JOBS = 256
ENGINES = ("local", "dask")
ADDRESS = re.compile(r"(tcp|tls)://(\[[0-9a-fA-F:]+\]|[^\s:/\[\]]+):\d{1,5}")


@dataclass(frozen=True)
class Lost:
    """A task without a result.

    Its process died twice, or the task raised an exception, whose traceback is `trace`.
    """

    reason: str
    trace: str = ""


class Here(Executor):
    """Executor that runs each task at once in this process."""

    def submit(self, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Future with the result, which is already computed."""
        future: Future[Any] = Future()
        try:
            future.set_result(function(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


@dataclass(frozen=True)
class Where:
    """Choice of an engine by its name, with `jobs` processes (0: one per core).

    Raises InputError if a value is not permitted.
    """

    jobs: int = 0
    engine: str = "local"
    scheduler: str = ""

    def __post_init__(self) -> None:
        if self.engine not in ENGINES:
            raise InputError(f"--engine must be one of {', '.join(ENGINES)}, got {self.engine!r}")
        if not 0 <= self.jobs <= MOST_JOBS:
            raise InputError(f"--jobs must be 0 (one per core) to {MOST_JOBS}, got {self.jobs}")
        if self.scheduler and self.engine != "dask":
            raise InputError("--scheduler requires --engine dask")
        if self.scheduler and not ADDRESS.fullmatch(self.scheduler):
            raise InputError(
                f"--scheduler must be an address such as tcp://host:8786, got {self.scheduler!r}"
            )

    def entered(self) -> AbstractContextManager[Engine]:
        """Context manager that provides the engine.

        Raises GoneError if the engine is not available.
        """
        processes = self.jobs or os.cpu_count() or 1
        if self.engine == "local":
            return local(processes)
        from verify.jobs.dask import dask  # slow to import

        return dask(processes, self.scheduler)


class ThisProcess(Where):
    """Engine in this process only.

    Scripts and notebooks need it, because other processes would run their code again.
    """

    def entered(self) -> AbstractContextManager[Engine]:
        """Context of the engine that solves in this process."""
        return local(0)


@contextmanager
def local(processes: int) -> Iterator[Engine]:
    """Engine with processes of this machine; with 0 processes, this process itself solves."""
    if processes == 0:
        yield Engine(Here(), lambda: 1)
        return
    executor = Processes(processes)
    try:
        yield Engine(executor, lambda: processes, gone=executor.gone, renew=executor.renew)
    finally:
        executor.shutdown()


Split = Callable[[Any], Sequence[Any]]


@dataclass
class Drive:
    """Runs tasks with `function` on an engine.

    `running` contains each running task and its start [s, of `time.monotonic`]. `split` returns the
    tasks to repeat if a process died; `begun` is called before a task is submitted.
    """

    engine: Engine
    function: Callable[[Any], Any]
    split: Split = lambda task: (task,)
    begun: Callable[[], None] = lambda: None
    running: dict[int, tuple[Any, float]] = field(default_factory=dict)

    def answers(self, tasks: Iterable[Any]) -> Iterator[tuple[Any, Any] | None]:
        """Each task with its result, in order of completion, and None every TICK seconds.

        A task is taken from `tasks` when it can be submitted; `tasks` is read again after every
        result. A task whose process dies is split, and its parts are repeated when no other task is
        left, each part alone in a new process; if this process also dies, the result of the part is
        Lost. Raises GoneError if the engine no longer answers.
        """
        waiting = iter(tasks)
        while died := (yield from self._round(waiting, self.engine.ahead)):
            for part in [part for task, _ in died for part in self.split(task)]:
                self.engine.renew()
                for dead, reason in (yield from self._round(iter((part,)), 0)):
                    yield dead, Lost(reason)

    def _round(self, tasks: Iterator[Any], ahead: int) -> Any:
        under_way: dict[Future[Any], tuple[int, Any]] = {}
        died: list[tuple[Any, str]] = []
        number = 0
        while True:
            while len(under_way) < self.engine.workers() * (1 + ahead):
                if (task := next(tasks, None)) is None:
                    break
                self.running[number] = task, time.monotonic()
                self.begun()
                under_way[self.engine.executor.submit(self.function, task)] = number, task
                number += 1
            if not under_way:
                return died
            done = self.engine.wait(under_way, TICK)
            if not done and (why := self.engine.gone()):
                raise GoneError(why)
            for future in done:
                n, task = under_way.pop(future)
                del self.running[n]
                error = future.exception() if not future.cancelled() else None
                if future.cancelled() or isinstance(error, self.engine.deadly):
                    if why := self.engine.gone():
                        raise GoneError(why)
                    died.append((task, str(error) if error else "the task was cancelled"))
                elif error is not None:
                    yield task, _raised(error)
                else:
                    yield task, future.result()
            yield None


def _raised(error: BaseException) -> Lost:
    cause = error.__cause__
    there = str(cause) if isinstance(cause, RemoteTraceback) else ""
    return Lost(named(error), there or "".join(traceback.format_exception(error)))

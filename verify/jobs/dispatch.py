"""One dispatcher for all studies: tasks on an engine, progress, and an orderly end when stopped.

A study provides tasks and receives each result when it is complete, and stores it at once. The next
run finds the results that an interrupted run has stored, and continues with the others.
"""

import time
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from typing import Any

from verify.core.progress import Show, State
from verify.jobs.engine import Engine, GoneError
from verify.jobs.executor import Drive, Split


@dataclass
class Dispatch:
    """A run that computes `total` results; `what` is their name in messages.

    `done` is the number of results that exist now, `known` the number before the run. `unstored` of
    the `done` results are not in the store: failed results, or all results if the store does not
    accept them. A study increases `total` if a result adds tasks, and counts `unstored`. `title` is
    the name of a running task; `remaining` estimates the remaining seconds, by default from the
    pace of this run.
    """

    what: str
    total: int = 0
    known: int = 0
    show: Show = lambda _state: None
    title: Callable[[Any], str] = str
    remaining: Callable[["Dispatch"], float] = lambda dispatch: dispatch.at_pace()
    split: Split = lambda task: (task,)
    unstored: int = 0
    done: int = field(init=False)
    start: float = field(init=False)
    drive: Drive = field(init=False)

    def __post_init__(self) -> None:
        self.done, self.start = self.known, time.monotonic()

    def run(
        self,
        engine: AbstractContextManager[Engine],
        function: Callable[[Any], Any],
        take: Callable[[], Any],
        receive: Callable[[Any, Any], int],
    ) -> None:
        """Do every task that `take` returns, until `take` returns None and no result adds a task.

        `receive` gets a task and its result (`Lost` if there is none) and returns the number of
        results stored with it. The messages of KeyboardInterrupt, GoneError and OSError state what
        is stored.
        """
        try:
            with engine as entered:
                self.drive = Drive(entered, function, self.split, lambda: self.show(self.state()))
                for event in self.drive.answers(_Waiting(take)):
                    if event is not None:
                        self.done += receive(*event)
                    self.show(self.state())
        except KeyboardInterrupt:
            raise KeyboardInterrupt(f"interrupted; {self}") from None
        except OSError as error:
            kind = GoneError if isinstance(error, GoneError) else OSError
            raise kind(f"{error}; {self}") from error

    @property
    def workers(self) -> int:
        """Number of tasks that are done simultaneously."""
        return self.drive.engine.workers()

    @property
    def under_way(self) -> list[tuple[Any, float]]:
        """The tasks in progress, each with its start [s, of `time.monotonic`]."""
        return list(self.drive.running.values())

    def at_pace(self) -> float:
        """Remaining time [s], if results continue to be made at the mean rate of this run."""
        made = self.done - self.known
        return (time.monotonic() - self.start) / made * (self.total - self.done) if made else 0.0

    def state(self) -> State:
        """State of the run."""
        names = tuple(self.title(task) for task, _ in self.under_way)
        return State(self.done, self.total, names, self.remaining(self), what=self.what)

    def __str__(self) -> str:
        stored = self.done - self.unstored
        if self.unstored and not stored:
            return f"{self.done} of {self.total} {self.what} are done, and not stored"
        return (
            f"{stored} of {self.total} {self.what} are stored: the same command continues with the "
            "others"
        )


def queue(waiting: deque[Any]) -> Callable[[], Any]:
    """Function for `Dispatch.run` that returns the next waiting task, or None if none waits."""
    return lambda: waiting.popleft() if waiting else None


class _Waiting:
    """Waiting tasks in order. Further tasks may be appended."""

    def __init__(self, take: Callable[[], Any]) -> None:
        self.take = take

    def __iter__(self) -> Iterator[Any]:
        return self

    def __next__(self) -> Any:
        if (task := self.take()) is None:
            raise StopIteration
        return task

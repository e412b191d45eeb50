"""Engine: an executor of concurrent.futures with the data that the scheduler needs."""

from collections.abc import Callable, Collection
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from dataclasses import dataclass
from typing import Any


class GoneError(OSError):
    """Error if the engine no longer answers; earlier results are stored."""


def first_done(futures: Collection[Future[Any]], seconds: float) -> Collection[Future[Any]]:
    """Futures that are done, returned when one is done or `seconds` have passed."""
    return wait(futures, seconds, FIRST_COMPLETED).done


@dataclass(frozen=True)
class Engine:
    """An executor, its number of simultaneous tasks, and functions that control it.

    `gone` returns the reason for which the executor can no longer answer, otherwise "". `renew`
    ends idle processes, so that a task whose process was killed gets a new process. `ahead` tasks
    wait in the engine for each task in progress. `wait` returns the futures that are done; an
    executor without threads computes during this call.
    """

    executor: Executor
    workers: Callable[[], int]
    deadly: tuple[type[BaseException], ...] = (BrokenExecutor,)
    gone: Callable[[], str] = lambda: ""
    renew: Callable[[], None] = lambda: None
    ahead: int = 0
    wait: Callable[[Collection[Future[Any]], float], Collection[Future[Any]]] = first_done
    remote: bool = False  # tasks may run on machines that don't see this one's files

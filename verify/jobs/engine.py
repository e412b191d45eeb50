"""What an engine is: an executor of concurrent.futures, and what must be known of it besides."""

from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Executor
from dataclasses import dataclass


class GoneError(OSError):
    """The engine answers no more; what was answered before is kept."""


@dataclass(frozen=True)
class Engine:
    """An executor, how many tasks it solves at a time, and what kills a task without an answer.

    `gone` says why it will never answer again, "" while it may. `renew` ends idle processes, so
    that a task that killed one finds a fresh one. `ahead` tasks wait there for each that is solved.
    """

    executor: Executor
    workers: Callable[[], int]
    deadly: tuple[type[BaseException], ...] = (BrokenExecutor,)
    gone: Callable[[], str] = lambda: ""
    renew: Callable[[], None] = lambda: None
    ahead: int = 0
    remote: bool = False  # tasks may run on machines that don't see this one's files

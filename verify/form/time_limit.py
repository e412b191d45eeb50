"""A limit of the time that a case's own code may take: an endless loop ends with its place."""

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


class TimeLimitError(Exception):
    """Code of a case took longer than its limit."""


@contextmanager
def limited(seconds: float | None) -> Iterator[None]:
    """Raise `TimeLimitError` where the body takes longer, in whatever line it is then.

    A limit needs the main thread of a process that has interval timers; elsewhere there is none.
    Limits may be nested: the inner one replaces the outer one for its body.
    """
    in_main = threading.current_thread() is threading.main_thread()
    if seconds is None or not in_main or not hasattr(signal, "setitimer"):
        yield
        return

    def late(_signal: int, _frame: FrameType | None) -> None:
        raise TimeLimitError(f"longer than {seconds:g} s, the time_limit of the case")

    handler = signal.signal(signal.SIGALRM, late)
    left, interval = signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, left, interval)
        signal.signal(signal.SIGALRM, handler)

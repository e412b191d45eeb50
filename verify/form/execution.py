"""Execution of the code of a case: errors are located, and a time limit ends endless loops."""

import signal
import threading
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from multiprocessing import parent_process
from pathlib import Path
from types import FrameType

from verify.form.quantity import CaseError


class TimeLimitError(Exception):
    """Error if the code of a case takes longer than its time limit."""


@contextmanager
def executed(file: str, time_limit: float | None) -> Iterator[None]:
    """Context in which code of a case in `file` is executed, with a time limit [s].

    The limit is for code outside the suite. An error becomes a CaseError with its line in the file.
    Errors that mean "no solution" or a failure of the machine are not changed. A ValueError of a
    case of the suite is not changed, because it is about inputs; in other cases, it may come from
    math.sqrt. Ctrl-C interrupts only the first process. In other processes, a KeyboardInterrupt
    comes from the code of the case and becomes a CaseError.
    """
    try:
        with limited(time_limit):
            yield
    except (CaseError, OSError, MemoryError):
        raise
    except (KeyboardInterrupt, SystemExit) as error:
        if isinstance(error, KeyboardInterrupt) and parent_process() is None:
            raise
        raise _located(error, file) from error
    except Exception as error:
        states = ArithmeticError if time_limit is not None else (ArithmeticError, ValueError)
        if isinstance(error, states) and not isinstance(error, ZeroDivisionError | OverflowError):
            raise
        raise _located(error, file) from error


def _located(error: BaseException, file: str) -> CaseError:
    frames = [f for f in traceback.extract_tb(error.__traceback__) if f.filename == file]
    place = f"{Path(file).name}:{frames[-1].lineno}: {frames[-1].name}" if frames else file
    text = " ".join(str(error).split())
    return CaseError(f"{place}: {type(error).__name__}{f': {text}' if text else ''}")


@contextmanager
def limited(seconds: float | None) -> Iterator[None]:
    """Context that raises `TimeLimitError` if its body takes longer than `seconds`, at any line.

    A limit requires the main thread of a process with interval timers; otherwise, there is no
    limit. Limits can be nested: the inner limit replaces the outer one in its body.
    """
    in_main = threading.current_thread() is threading.main_thread()
    if seconds is None or not in_main or not hasattr(signal, "setitimer"):
        yield
        return

    def late(_signal: int, _frame: FrameType | None) -> None:
        raise TimeLimitError(f"the code took longer than {seconds:g} s, the time_limit of the case")

    handler = signal.signal(signal.SIGALRM, late)
    left, interval = signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, left, interval)
        signal.signal(signal.SIGALRM, handler)

"""Executing the code of a case: an error is located, and an endless loop ends."""

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
    """Code of a case took longer than its limit."""


@contextmanager
def executed(file: str, time_limit: float | None) -> Iterator[None]:
    """Execute code of a case in a file; one outside the suite has a limit of its time [s].

    A fault becomes a CaseError with its place in the file. What states that there is no solution,
    or that the machine failed, passes unchanged; so does a ValueError of the suite's cases, which
    speaks of inputs. In others it may be that of math.sqrt. Ctrl-C reaches the first process only:
    in others the code itself has raised KeyboardInterrupt.
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
    """Raise `TimeLimitError` if the body takes longer, at any line.

    A limit needs the main thread of a process that has interval timers; without it there is none.
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

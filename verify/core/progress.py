"""Display of the progress of a run: a bar on a terminal and in a notebook, otherwise lines."""

import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TextIO

EVERY = 5.0  # s between two lines
FIRST = 2.0  # s before the first: short runs need none
MOST_NAMES = 2
WIDTH = 16  # characters of a bar


@dataclass(frozen=True)
class State:
    """State of a run: numbers of completed and of all tasks, running tasks, remaining seconds."""

    done: int
    total: int
    running: tuple[str, ...]
    remaining: float
    what: str = "refinement levels"


Show = Callable[[State], None]


@contextmanager
def shown(*, quiet: bool) -> Iterator[Show]:
    """Context with a function that the run calls with its state several times a second."""
    if quiet:
        yield lambda _state: None
    elif sys.stderr.isatty():
        with _bar() as show:
            yield show
    elif "ipykernel" in sys.modules:  # a notebook, whose output is no terminal
        with rewritten(sys.stderr) as show:
            yield show
    else:
        yield Lines()


class Lines:
    """Display of the state as plain lines on stderr, with several seconds between lines."""

    def __init__(
        self, clock: Callable[[], float] = time.monotonic, stream: TextIO | None = None
    ) -> None:
        self.clock, self.stream = clock, stream or sys.stderr
        self.next = clock() + FIRST

    def __call__(self, state: State) -> None:
        if self.clock() >= self.next and state.running:
            self.next = self.clock() + EVERY
            print(line(state), file=self.stream, flush=True)


@contextmanager
def rewritten(stream: TextIO) -> Iterator[Show]:
    """Context with a function that displays the state as a bar in one line of `stream`.

    The line is written again for each state and removed at the end.
    """
    longest = 0

    def show(state: State) -> None:
        nonlocal longest
        if not state.running:
            return
        filled = WIDTH * state.done // max(state.total, 1)
        text = f"[{'#' * filled:{WIDTH}}] {line(state)}"
        longest = max(longest, len(text))
        stream.write(f"\r{text:{longest}}")
        stream.flush()

    try:
        yield show
    finally:
        if longest:
            stream.write(f"\r{'':{longest}}\r")
            stream.flush()


def line(state: State) -> str:
    """State as one line of text.

    For example: "finite elements 12 of 48, spring-continuum level 8, about 14 s left".
    """
    left = f"about {duration(state.remaining)} left"
    return f"{state.what} {state.done} of {state.total}, {names(state.running)}, {left}"


def names(running: Sequence[str]) -> str:
    """Names of the running levels, at most two."""
    more = f" and {len(running) - MOST_NAMES} more" if len(running) > MOST_NAMES else ""
    return ", ".join(running[:MOST_NAMES]) + more


def duration(seconds: float) -> str:
    """Text of a rounded duration: "14 s", "3 min", "1 h 20 min"."""
    if seconds < 90:
        return f"{max(round(seconds), 1)} s"
    minutes = round(seconds / 60)
    return f"{minutes} min" if minutes < 60 else f"{minutes // 60} h {minutes % 60} min"


@contextmanager
def message_if_slow(message: str, *, quiet: bool, after: float = FIRST) -> Iterator[None]:
    """Context that prints `message` on stderr if its body takes more than `after` seconds.

    At the end, it prints the duration.
    """
    start = time.monotonic()
    timer = threading.Timer(after, lambda: print(message, file=sys.stderr, flush=True))
    timer.daemon = True
    if not quiet:
        timer.start()
    try:
        yield
    finally:
        timer.cancel()
    if not quiet and (seconds := time.monotonic() - start) > after:
        print(f"done after {seconds:.1f} s", file=sys.stderr, flush=True)


@contextmanager
def _bar() -> Iterator[Show]:
    from rich.console import Console  # slow to import, and only used on a terminal
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

    columns = (  # together less than 80 characters
        TextColumn("solving"), BarColumn(WIDTH), MofNCompleteColumn(),
        TextColumn("{task.fields[left]}"), TextColumn("{task.description}", style="dim"),
    )  # fmt: skip
    bar = Progress(*columns, console=Console(stderr=True), transient=True)
    task = bar.add_task("", total=None, left="")

    def show(state: State) -> None:
        left = f"about {duration(state.remaining)} left" if state.running else ""
        what = state.running[0] if state.running else ""  # the longest started first
        bar.update(task, completed=state.done, total=state.total, description=what, left=left)
        bar.start()  # not before there is something to solve

    try:
        yield show
    finally:
        bar.stop()

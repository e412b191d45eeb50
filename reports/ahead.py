"""Figures and pictures of cases, drawn while other cases are solved."""

from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path
from queue import SimpleQueue
from threading import Thread
from typing import Self

from reports.frames import frames
from reports.html import plot
from verify.core.results import CaseResult

TOGETHER = 8  # pictures or more for one process of pyvista, which takes a second to start
LAST = 2  # cases left to judge, from which on every picture is drawn at once


class Ahead:
    """A context with a thread that draws what the report shows of `count` cases as they come.

    Pictures go into the store. What fails here is drawn again, and then reported, where the
    report is written. `hint` goes to a reader who lacks pyvista; `first` is other work that the
    report needs: it waits for the first case, by when every core solves.
    """

    def __init__(self, count: int, folder: Path, hint: str, first: Callable[[], object]) -> None:
        self._count, self._folder, self._hint, self._first = count, folder, hint, first
        self._cases: SimpleQueue[CaseResult | None] = SimpleQueue()
        self._thread = Thread(target=self._work, daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, error: object, *_rest: object) -> None:
        self._cases.put(None)
        if error is None:  # an interrupted run does not wait for a picture
            self._thread.join()

    def add(self, case: CaseResult) -> None:
        """Have a case drawn."""
        self._cases.put(case)

    def _work(self) -> None:
        waiting: list[CaseResult] = []
        left = self._count
        for case in iter(self._cases.get, None):
            if left == self._count:
                with suppress(Exception):
                    self._first()
            left -= 1
            waiting.append(case)
            with suppress(Exception):
                _ = [plot(figure) for figure in case.figures]
            if _pictures(waiting) >= (1 if left <= LAST else TOGETHER):
                with suppress(Exception):
                    frames(waiting, self._folder, self._hint)
                waiting = []


def _pictures(cases: Iterable[CaseResult]) -> int:
    return sum(len(case.pictures) for case in cases)

"""What a report needs of a case, drawn while other cases are solved."""

from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path
from queue import SimpleQueue
from threading import Thread
from typing import Self

from reports.equations import Glyphs
from reports.frames import frames
from verify.core.results import CaseResult

TOGETHER = 8  # pictures or more for one process of pyvista, which takes a second to start


def draw_equations(case: CaseResult, folder: Path) -> None:
    """Draw the equations of a case into the store of a folder."""
    glyphs = Glyphs(folder)
    glyphs.prepare(tex for e in case.equations for tex in (e.tex, e.numbers))
    glyphs.store()


class Ahead:
    """A context with a thread that draws pictures of cases into the store as they are added.

    What fails here is drawn again, and then reported, where the report is written. `hint` goes
    to a reader who lacks pyvista; `first` is other work that the report needs.
    """

    def __init__(self, folder: Path, hint: str, first: Callable[[], object]) -> None:
        self._folder, self._hint, self._first = folder, hint, first
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
        """Have the pictures of a case drawn."""
        self._cases.put(case)

    def _work(self) -> None:
        with suppress(Exception):
            self._first()
        waiting: list[CaseResult] = []
        for case in iter(self._cases.get, None):
            waiting.append(case)
            if _count(waiting) >= TOGETHER:
                with suppress(Exception):
                    frames(waiting, self._folder, self._hint)
                waiting = []


def _count(cases: Iterable[CaseResult]) -> int:
    return sum(len(case.pictures) for case in cases)

"""Drawing of figures and pictures of cases while other cases are solved."""

from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from queue import SimpleQueue
from threading import Thread
from typing import Self

from reports.drawing_process import DrawingProcess
from reports.figures import plot
from reports.frames import frames
from verify.core.results import CaseResult


class Ahead:
    """Context manager with a thread that draws the figures and pictures of judged cases.

    Pictures are written to the store. A picture that fails here is drawn again when the report is
    written; its failure is then reported. `hint` is the advice if pyvista is missing. Before the
    first case is drawn, the thread calls `first`, which prepares other content of the report.
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
        """Add a case whose figures and pictures are to be drawn."""
        self._cases.put(case)

    def _work(self) -> None:
        first: Callable[[], object] | None = self._first
        with DrawingProcess() as process:
            for case in iter(self._cases.get, None):
                if first:
                    with suppress(Exception):
                        first()
                    first = None
                with suppress(Exception):
                    _ = [plot(figure) for figure in case.figures]
                with suppress(Exception):
                    frames([case], self._folder, self._hint, process)

"""Display of a job: a start button, its progress, and a button that cancels it."""

import asyncio
import time
from collections.abc import Callable, Coroutine
from typing import Any

from markupsafe import Markup
from nicegui import ui

from verify.app.page.jobs import CancelledError, FailedError, Jobs, Worker
from verify.app.page.widgets import button, enable, html, message
from verify.core.inputs import InputError
from verify.core.progress import duration

Work = Callable[[Worker, Callable[[Any], None]], Coroutine[Any, Any, None]]


class JobView:
    """Runs `work` in a separate process when its button is pressed, one run at a time.

    `kept` is added to the message of a run that is cancelled.
    """

    def __init__(self, text: str, name: str, jobs: Jobs, work: Work, *, kept: str = "") -> None:
        self._jobs, self._work, self._kept = jobs, work, kept
        self._worker: Worker | None = None
        self._state: Any = None
        self._start = 0.0
        with ui.element("div").classes("row"):
            self._run = button(text, self._begin, css="main", name=name)
            self._cancel = button("Cancel", self.cancel, name=f"{name}-cancel")
            enable(self._cancel, False)
            self._progress = html().props(f'id="{name}-progress" role="status"')
        self._timer = ui.timer(0.5, self._show, active=False)
        ui.context.client.on_delete(self.cancel)

    def cancel(self) -> None:
        """End the process."""
        if self._worker is not None:
            self._worker.end()

    async def _begin(self) -> None:
        if self._worker is not None:
            return
        try:
            worker = self._worker = self._jobs.begin()
        except InputError as error:
            self._progress.set_content(message(str(error)))
            return
        self._state, self._start = None, time.monotonic()
        enable(self._run, False)
        enable(self._cancel, True)
        self._timer.activate()
        self._show()
        reason = ""
        try:
            await self._work(worker, self._take)
        except CancelledError:
            reason = f"cancelled{self._kept}"
        except (InputError, FailedError) as error:
            reason = str(error)
        except asyncio.CancelledError:
            reason = "the page was closed"
            raise
        finally:
            self._jobs.finish(worker)
            self._worker = None
            if not self._run.is_deleted:
                self._ended(reason)

    def _ended(self, reason: str) -> None:
        self._timer.deactivate()
        enable(self._run, True)
        enable(self._cancel, False)
        seconds = f"done in {duration(time.monotonic() - self._start)}"
        self._progress.set_content(message(reason) or seconds)

    def _take(self, state: Any) -> None:
        self._state = state

    def _show(self) -> None:
        if self._worker is None:
            return
        spent = duration(time.monotonic() - self._start)
        if not self._state:
            self._progress.set_content(f"running, {spent}")
            return
        done, total, what = self._state
        bar = Markup('<progress value="{}" max="{}" aria-label="progress"></progress>')
        text = ", ".join(filter(None, (f"{done} of {total}", what, spent)))
        self._progress.set_content(Markup("{} {}").format(bar.format(done, total), text))

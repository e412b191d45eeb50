"""Updates the answer of a page after a change of its state.

Notes about assumed inputs are slow to compute and follow after a pause.
"""

import asyncio
import json
from dataclasses import replace
from typing import Any

from nicegui import background_tasks, ui

from verify.app.page.answer_view import answer, brief
from verify.app.page.answers import Shown, shown
from verify.app.page.jobs import CancelledError, FailedError
from verify.app.page.link import to_link
from verify.app.page.session import State
from verify.app.page.widgets import enable
from verify.core.inputs import InputError

FORMULAS, DETAILS = 60.0, 60.0  # s, time limit of an answer
SLOW = 0.4  # s after which the page states that it computes
PAUSE = 0.5  # s without typing before slow notes are computed


class Answering:
    """Computes the answers for the states of one screen, one after the other."""

    def __init__(self, screen: Any) -> None:
        self.screen, self.found = screen, Shown()
        self._answering = False
        self._stored: tuple[State, Shown] | None = None

    def changed(self) -> None:
        """Compute the answer to the present state of the page.

        A state is not answered if a later state replaces it while another answer is computed.
        """
        if not self._answering:
            self._answering = True
            background_tasks.create(self._answer(), name="answer")

    async def _answer(self) -> None:
        try:
            state: Any = None
            while state is not self.screen.session.state:
                state = self.screen.session.state
                with self.screen.client:
                    await self._once(state)
        finally:
            self._answering = False
        await asyncio.sleep(PAUSE)
        if state is self.screen.session.state and not self._answering:
            with self.screen.client:
                await self._details(state)

    async def _once(self, state: State) -> None:
        enable(self.screen.undo, bool(self.screen.session.before))
        enable(self.screen.redo, bool(self.screen.session.after))
        busy = background_tasks.create(self._busy(), name="busy")
        try:
            found = await self._asked(state)
            other = await self._of_stored(state)
        except (InputError, FailedError, CancelledError) as error:
            found, other = Shown(fault=str(error)), None
        finally:
            busy.cancel()
        self.screen.busy.set_content("")
        self._display(found)
        self.screen.tools.show_compared(found, other)
        self.screen.tools.mark_outdated()
        ui.run_javascript(f"freewheel.keep({json.dumps(to_link(state))})")

    async def _asked(self, state: State) -> Shown:
        asked = self.screen.asked(state)
        found: Shown = await self.screen.place.formulas.ask(shown, *asked, False, seconds=FORMULAS)
        return found

    async def _of_stored(self, state: State) -> Shown | None:
        """Answer of variant B, which does not change while only the form is edited."""
        if state.other is None:
            return None
        stored = replace(state, raw=state.other, other=None)
        if self._stored is None or self._stored[0] != stored:
            self._stored = stored, await self._asked(stored)
        return self._stored[1]

    async def _busy(self) -> None:
        """After a delay, display that the answer does not yet belong to the present inputs."""
        await asyncio.sleep(SLOW)
        with self.screen.client:
            self.screen.busy.set_content("computing; the answer below is that of the inputs before")
            self.screen.brief.set_content("computing")

    async def _details(self, state: State) -> None:
        """Display the same answer with notes about the assumed inputs, if there are any."""
        if not self.found.assumed:
            return
        ask = self.screen.place.details.ask
        try:
            found = await ask(shown, *self.screen.asked(state), True, seconds=DETAILS)
        except (InputError, FailedError, CancelledError):
            return
        if state is self.screen.session.state:
            self._display(found)

    def _display(self, found: Shown) -> None:
        self.found = found
        self.screen.answer.set_content(answer(found))
        self.screen.brief.set_content(brief(found))
        if found.sketch:
            self.screen.sketch.set_content(found.sketch)
        data = json.dumps([found.faults, found.beside, found.assumed, bool(found.verdict)])
        ui.run_javascript(
            f"freewheel.messages(...{data}); freewheel.highlight(); freewheel.unfold()"
        )

"""One page in a browser: selection of a case, form, answer, and tools."""

import itertools
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from markupsafe import Markup
from nicegui import ui

from verify.app.page.answering import FORMULAS, Answering
from verify.app.page.described import Described, describe
from verify.app.page.file_view import FileView
from verify.app.page.form import ADD, form
from verify.app.page.jobs import CancelledError, FailedError
from verify.app.page.link import from_link
from verify.app.page.parts import groups
from verify.app.page.place import FIRST, Place
from verify.app.page.session import Session, State, with_entry, without_entry
from verify.app.page.toml_text import as_values, read_state
from verify.app.page.tools_view import Tools
from verify.app.page.widgets import VALUE, button, chosen_of, html, message
from verify.core.inputs import InputError

HERE = Path(__file__).parent
TEMPLATES = Path(__file__).parents[3] / "reports" / "templates"
NUMBERS = itertools.count(1)
TYPED = "e => { if (e.target.dataset.place) emit([e.target.dataset.place, e.target.value]); }"
PRESSED = (
    "e => { const b = e.target.closest('[data-action]'); "
    "if (b) emit([b.dataset.action, b.dataset.table, b.dataset.entry || '0']); }"
)


class Screen:
    """A page with its session. All pages share the processes and the folder of `place`."""

    def __init__(self, place: Place) -> None:
        self.place, self.number = place, next(NUMBERS)
        self.client = ui.context.client
        self.session = Session(State(FIRST, f"my {FIRST}"))
        self.case: Described
        self.tools: Tools
        self.changed = Answering(self).changed

    async def build(self, link: str) -> None:
        """Build the page for the session of a link or of a file, otherwise for the first part."""
        self._head()
        self.bar = ui.element("div").classes("bar")
        self.error = html().props('id="error"')
        self.body = ui.element("main")
        try:
            state = self._first(link)
        except InputError as error:
            self.error.set_content(message(str(error)))
            state = State(FIRST, f"my {FIRST}")
        await self.show(state, fill=not state.raw)

    def _first(self, link: str) -> State:
        if link:
            return from_link(link)
        if self.place.first:
            return read_state(self.place.folder.path(self.place.first, ".toml"))
        return State(FIRST, f"my {FIRST}")

    def _head(self) -> None:
        css = [TEMPLATES / "palette.css", TEMPLATES / "figures.css", HERE / "page.css"]
        styles = "\n".join(one.read_text("utf-8") for one in css)
        ui.add_head_html(f"<style>{styles}</style>")
        ui.add_head_html(f"<script>{(HERE / 'page.js').read_text('utf-8')}</script>")
        ui.add_head_html("<script>document.documentElement.lang = 'en'</script>")

    def path(self, state: State) -> str:
        """Id of the case of a state, or the path of its file. May raise InputError."""
        name = state.case
        return str(self.place.folder.path(name, ".py")) if name.endswith(".py") else name

    def asked(self, state: State) -> tuple[str, str, dict[str, Any]]:
        """Case, name and inputs of a state, as in a parameter file of the command line."""
        return self.path(state), state.name, as_values(state.raw, self.case.whole)

    async def show(self, state: State, *, fill: bool = False) -> None:
        """Select another case or file. With `fill`, the inputs of the template are used.

        Errors are displayed.
        """
        case = await self._described(state)
        if case is None:
            if not hasattr(self, "case"):
                await self.show(State(FIRST, f"my {FIRST}"), fill=True)
            return
        self.case = case
        filled = replace(state, raw=self.case.raw) if fill else state
        if self.session.state.raw:
            self.session.put(filled)
        else:
            self.session.state = filled
        self._lay_out()
        self.changed()

    async def _described(self, state: State) -> Described | None:
        """Form of the case of a state; None after an error, which is displayed."""
        try:
            path = self.path(state)
            case: Described = await self.place.formulas.ask(describe, path, seconds=FORMULAS)
            for raw in filter(None, (state.raw, state.other)):
                case.refuse_shapes(raw)
        except (InputError, FailedError, CancelledError) as error:
            self.error.set_content(message(str(error)))
            return None
        return case

    def _lay_out(self) -> None:
        self.bar.clear()
        with self.bar:
            html("<h1>freewheel app</h1>")
            self._choice()
            self.undo = button("Undo", self._undo, name="undo")
            self.redo = button("Redo", self._redo, name="redo")
            FileView(self)
        if hasattr(self, "tools"):
            self.tools.cancel()
        self.body.clear()
        with self.body:
            html(Markup("<h2>{}</h2>").format(self.case.title))
            self.brief = html(css="brief")
            with ui.element("div").classes("columns"):
                with ui.element("div"):
                    self.sketch = html(css="drawing")
                    html('<p class="soft" id="sketch-note" aria-live="polite"></p>')
                    self.form = html(form(self.case, self.session.state.raw)).props('id="form"')
                    self.form.on("input", self._typed, js_handler=TYPED)
                    self.form.on("click", self._pressed, js_handler=PRESSED)
                with ui.element("div").classes("answer"):
                    self.busy = html(css="soft").props('id="busy" role="status"')
                    self.answer = html().props('id="answer" aria-live="polite"')
            with ui.element("div").classes("tools"):
                self.tools = Tools(self)

    def _choice(self) -> None:
        chosen = self.session.state.case
        content = chosen_of(groups(self.place.folder.names_of(".py"), chosen), chosen)
        select = ui.html(content, sanitize=False, tag="select")
        select.props('id="case" aria-label="part or case"').on("change", self._choose,
                                                                js_handler=VALUE)  # fmt: skip

    async def _choose(self, event: Any) -> None:
        name = str(event.args)
        self.error.set_content("")
        await self.show(State(name, f"my {name}"), fill=True)

    def _typed(self, event: Any) -> None:
        place, text = (str(one) for one in event.args)
        try:
            self.session.edit(place, self.case.entered(place, text))
        except (ValueError, LookupError) as error:
            self.error.set_content(message(str(error)))
            return
        self.error.set_content("")
        self.changed()

    def _pressed(self, event: Any) -> None:
        action, table, number = (str(one) for one in event.args)
        state = self.session.state
        if action == ADD:
            entries = self.case.raw.get(table) or [{}]
            raw = with_entry(state.raw, table, entries[-1])
        else:
            raw = without_entry(state.raw, table, int(number))
        self.put(replace(state, raw=raw))

    def put(self, state: State) -> None:
        """Display another state of the same case."""
        is_typed = state.raw == self.session.state.raw
        self.session.put(state)
        self.changed() if is_typed else self._refill()

    async def _undo(self) -> None:
        case = self.session.state.case
        if self.session.undo():
            await self._after_step(case, self.session.redo)

    async def _redo(self) -> None:
        case = self.session.state.case
        if self.session.redo():
            await self._after_step(case, self.session.undo)

    async def _after_step(self, case: str, back: Callable[[], bool]) -> None:
        """Display the state after a step.

        If its case cannot be displayed, undo the step with `back`.
        """
        if self.session.state.case == case:
            self._refill()
            return
        described = await self._described(self.session.state)
        if described is None:
            back()
            return
        self.case = described
        self._lay_out()
        self.changed()

    def _refill(self) -> None:
        again = Markup("<!-- {} -->").format(next(NUMBERS))  # the same text would change nothing
        self.form.set_content(again + form(self.case, self.session.state.raw))
        ui.run_javascript("freewheel.again()")
        self.changed()

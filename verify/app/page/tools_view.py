"""Tools of the page in addition to the answer: finite elements, sweep, comparison, report."""

import shlex
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from markupsafe import Markup, escape
from nicegui import run, ui

from verify.app.page import tasks
from verify.app.page.answer_view import evidence
from verify.app.page.answers import Shown
from verify.app.page.compared import compared
from verify.app.page.job_view import JobView
from verify.app.page.jobs import Worker
from verify.app.page.session import text_at
from verify.app.page.shape_view import ShapeView
from verify.app.page.sweep_figure import options
from verify.app.page.toml_text import parameter_file
from verify.app.page.widgets import Choice, Typed, button, enable, html, is_dark, message, tool
from verify.core.inputs import InputError

OLD = "of earlier inputs: the form has changed since then"
Notify = Callable[[Any], None]


class Tools:
    """The tools of one screen, created for its case."""

    def __init__(self, screen: Any) -> None:
        self.screen = screen
        self.old: dict[str, ui.html] = {}
        self.made: dict[str, Any] = {}  # inputs of a job's result
        self.jobs: list[JobView] = []
        with tool("Check with finite elements", "tool-fem"):
            html(Markup('<p class="soft">{}</p>').format(screen.case.method))
            self._job("Check with finite elements", "fem", self._fem)
            self.rows = html().props('id="fem-rows"')
        with tool("Sweep over one or two inputs", "tool-sweep"):
            self._sweep_form()
        with tool("Compare two variants", "tool-compare"), ui.element("div").classes("row"):
            button("Store these inputs as variant B", self._keep, name="keep")
            self.exchange = button("Exchange A and B", self._exchange, name="exchange")
            self.drop = button("Remove variant B", self._drop, name="drop")
        with ui.element("div"):
            self.compared = html().props('id="compared"')
        with tool("Fields and deformed shapes in 3-D", "tool-shape"):
            self._job("Solve and display the fields", "fields", self._fields)
            self.shape = ShapeView(screen)
        with tool("Report: pictures of fields, PDF, CSV", "tool-report"):
            self.fem = Choice("Content", {"": "formulas", "fem": "with finite elements and fields"},
                              "report-content")  # fmt: skip
            self._job("Write the report", "report", self._report)
            self.report = html().props('id="report-files"')

    def _job(self, text: str, name: str, work: Any) -> None:
        kept = "" if name == "sweep" else "; finished levels are stored"
        self.jobs.append(JobView(text, name, self.screen.place.jobs, work, kept=kept))
        self.old[name] = html(css="error").props(f'id="{name}-old" role="status"')

    def cancel(self) -> None:
        """Cancel all jobs, because another case is selected."""
        for job in self.jobs:
            job.cancel()

    def mark_outdated(self) -> None:
        """Mark each result of a job as outdated if it does not belong to the present inputs."""
        for name, raw in self.made.items():
            self.old[name].set_content(OLD if raw != self.screen.session.state.raw else "")

    def _is_made(self, name: str, raw: Any) -> None:
        self.made[name] = raw
        self.mark_outdated()

    async def _fem(self, worker: Worker, notify: Notify) -> None:
        state = self.screen.session.state
        asked = self.screen.asked(state)
        found: Shown = await worker.ask(tasks.finite_elements, *asked, notify=notify)
        self.rows.set_content(evidence(found))
        self._is_made("fem", state.raw)

    async def _fields(self, worker: Worker, notify: Notify) -> None:
        raw = self.screen.session.state.raw
        await self.shape.solve(worker, notify)
        self._is_made("fields", raw)

    def _sweep_form(self) -> None:
        fields = [f for f in self.screen.case.fields if f.is_number]
        numbers = {f.name: f"{f.symbol or f.name}: {f.what}" for f in fields}
        none = {"": "none"}
        raw = self.screen.session.state.raw
        first = next((n for n in numbers if raw.get(n)), next(iter(numbers), ""))
        with ui.element("div").classes("row"):
            self.first = Choice("First input", numbers, "sweep-first", first)
            about = text_at(raw, first)
            self.values = Typed(
                "From : to : number", "sweep-values", "", about and f"such as {about}:…:20"
            )
            self.second = Choice("Second input", none | numbers, "sweep-second")
            self.more = Typed("From : to : number", "sweep-more")
            results = {tasks.MARGIN: "margin", tasks.DESIGN: "design value"}
            self.result = Choice("Result", results | dict(self.screen.case.outputs),
                                 "sweep-result")  # fmt: skip
        self._job("Sweep the formulas", "sweep", self._sweep)
        self.figure = ui.element("div").props('id="sweep-figure"')

    async def _sweep(self, worker: Worker, notify: Notify) -> None:
        state = self.screen.session.state
        axes = [(self.first.value, self.values.value)]
        if self.second.value:
            axes.append((self.second.value, self.more.value))
        for name, values in axes:
            if not values.strip():
                raise InputError(f"{name}: write first:last:number of values (5 mm:30 mm:20)")
        vary = [f"{name}={values}" for name, values in axes]
        try:
            found: tasks.Swept = await worker.ask(
                tasks.sweep, *self.screen.asked(state), vary, self.result.value, notify=notify
            )
        except InputError as error:
            raise InputError(str(error).removeprefix("--vary ")) from error
        dark = not self.figure.is_deleted and await is_dark()
        if self.figure.is_deleted:  # another case was selected
            return
        self.figure.clear()
        with self.figure:
            ui.echart(options(found, dark=dark)).classes(f"figure {'dark' if dark else 'light'}")
            options_of = " ".join(f"--vary {shlex.quote(v)}" for v in vary)
            repeat = f"freewheel sweep FILE {options_of}"
            html(Markup("<p>{}</p>").format(f"By finite elements: {repeat}"), "soft")
            problem = found.problem.removeprefix("inputs: ")
            html(message(problem and f"points without a result: {problem}"))
            if not any(value is not None for line in found.values for value in line):
                html(message(f"no point has a result: {found.label}"))
        self._is_made("sweep", state.raw)

    def _keep(self) -> None:
        state = self.screen.session.state
        self.screen.put(replace(state, other=state.raw))

    def _exchange(self) -> None:
        state = self.screen.session.state
        if state.other is not None:
            self.screen.put(replace(state, raw=state.other, other=state.raw))

    def _drop(self) -> None:
        self.screen.put(replace(self.screen.session.state, other=None))

    def show_compared(self, present: Shown, other: Shown | None) -> None:
        """Display both variants side by side; display nothing if there is no second variant."""
        state = self.screen.session.state
        for one in (self.exchange, self.drop):
            enable(one, state.other is not None)
        if other is None or state.other is None:
            self.compared.set_content("")
            return
        raws = (state.raw, state.other)
        self.compared.set_content(compared(self.screen.case, raws, (present, other)))

    async def _report(self, worker: Worker, _notify: Notify) -> None:
        place, state = self.screen.place, self.screen.session.state
        folder = place.reports / f"{self.screen.number}"
        folder.mkdir(exist_ok=True)
        file = folder / "part.toml"
        text = parameter_file(replace(state, case=self.screen.path(state)))
        await run.io_bound(file.write_text, text, "utf-8")
        out = folder / "report"
        names = await worker.ask(tasks.report, file, out, bool(self.fem.value))
        links = Markup(" ").join(
            Markup('<a href="/reports/{0}/report/{1}" download>{1}</a>').format(
                self.screen.number, name)
            for name in names
        )  # fmt: skip
        frame = Markup('<iframe title="report" src="/reports/{}/report/report.html?{}"></iframe>')
        self.report.set_content(
            Markup("<p>{}</p>").format(links) + frame.format(self.screen.number, escape(len(names)))
        )
        self._is_made("report", state.raw)

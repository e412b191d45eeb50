"""Tool that displays fields and deformed shapes in space; the user can rotate the view."""

from collections.abc import Callable, Mapping
from typing import Any

from markupsafe import Markup
from nicegui import ui

from reports.svg import MINUS
from verify.app.page import tasks
from verify.app.page.jobs import Worker
from verify.app.page.shape_figure import VIEWS, figure
from verify.app.page.shapes import Shape
from verify.app.page.widgets import VALUE, Choice, html, is_dark
from verify.core.console import raised

STEPS = 20  # of the slider up to the proposed scale
LARGEST = 2  # scale of displacements at the end of the slider, in proposed scales
DIGITS = 3  # of the slider; a forged message of a browser can contain more
HEIGHTS = {"": "flat", "values": "values as height"}


class ShapeView:
    """The fields of one solution, with controls for field, view and scale of displacements."""

    def __init__(self, screen: Any) -> None:
        self.screen = screen
        self.shapes: tuple[Shape, ...] = ()
        self.dark = False
        self.body = ui.element("div").props('id="shape"')

    async def solve(self, worker: Worker, notify: Callable[[Any], None]) -> None:
        """Display the fields of the present inputs."""
        asked = self.screen.asked(self.screen.session.state)
        self.shapes = await worker.ask(tasks.fields, *asked, notify=notify)
        self.dark = not self.body.is_deleted and await is_dark()
        if self.body.is_deleted:  # another case was selected
            return
        self.body.clear()
        with self.body:
            self._lay_out()

    def _lay_out(self) -> None:
        titles = {str(k): raised(one.title) for k, one in enumerate(self.shapes)}
        with ui.element("div").classes("row"):
            self.field = Choice("Field", titles, "shape-field", on_change=self._other)
            self.view = Choice("View", {name: name for name in VIEWS}, "shape-view",
                               self._usual_view, on_change=self._draw)  # fmt: skip
            self.height = Choice("Plane bodies", HEIGHTS, "shape-height", on_change=self._draw)
        self.scale = ui.element("div").classes("row")
        self.plot = ui.plotly(self._figure(1.0)).classes("figure space").props('id="shape-figure"')
        self.plot.props('role="img" aria-label="field on the deformed body"')
        html('<p class="soft">Drag to turn, drag with the right button to move, use the wheel to '
             "zoom.</p>")  # fmt: skip
        self.range = html(css="soft").props('id="shape-range"')
        self._other()

    @property
    def shape(self) -> Shape:
        """The selected body."""
        return self.shapes[int(self.field.value)]

    @property
    def _usual_view(self) -> str:
        return "front" if self.shapes[0].is_plane else "oblique"

    def _other(self) -> None:
        """Display another field with its proposed scale of displacements."""
        self.share = 1.0
        self.scale.clear()
        with self.scale:
            if self.shape.factor:
                slider = ('Scale of displacements<input type="range" id="shape-scale" min="0" '
                          f'max="{LARGEST * STEPS}" value="{STEPS}">')  # fmt: skip
                ui.html(slider, sanitize=False, tag="label").on(
                    "change", self._scaled, js_handler=VALUE
                )
                self.times = html(css="soft").props('id="shape-times" role="status"')
            else:
                html('<p class="soft">This field has no displacements.</p>')
        self._draw()

    def _scaled(self, event: Any) -> None:
        text = str(event.args)
        self.share = min(int(text[:DIGITS]) / STEPS, LARGEST) if text.isdecimal() else 1.0
        self._draw()

    def _draw(self) -> None:
        if not (self.field.is_offered and self.view.is_offered):
            return
        if self.shape.factor:
            self.times.set_content(f"× {self.share * self.shape.factor:g}")
        self.plot.update_figure(self._figure(self.share))
        self.range.set_content(about(self.shape))

    def _figure(self, share: float) -> Mapping[str, Any]:
        return figure(
            self.shape, share * self.shape.factor, view=self.view.value,
            as_height=bool(self.height.value), dark=self.dark,
        )  # fmt: skip


def about(shape: Shape) -> str:
    """Text with the title of the field, its label, and its smallest and largest value."""
    title = Markup("{}<br>").format(raised(shape.title))
    if shape.values is None:
        return title
    low, high = (10**v if shape.decades else v for v in (shape.values.min(), shape.values.max()))
    smallest, largest = (f"{v:.4g}".replace("-", MINUS) for v in (low, high))
    return title + f"{shape.label}: smallest {smallest}, largest {largest}"

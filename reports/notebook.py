"""Drawings and tables that a notebook displays, without imports of notebook software."""

import base64
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from markupsafe import Markup

from reports.convergence import convergence
from reports.figures import plot
from reports.sketch import sketch
from reports.standalone import standalone
from verify.core.results import CaseResult

WIDTH = 480  # pixels of a drawing


@dataclass(frozen=True)
class Drawing:
    """A drawing with its title; `svg` is the text of an SVG file."""

    title: str
    svg: str

    def _repr_html_(self) -> str:
        """HTML image, so that the style of the drawing does not affect the notebook."""
        data = base64.b64encode(self.svg.encode()).decode()
        return Markup(
            '<figure style="margin: 1em 0"><figcaption>{title}</figcaption>'
            '<img width="{width}" alt="{title}" src="data:image/svg+xml;base64,{data}"/></figure>'
        ).format(title=self.title, width=WIDTH, data=data)


class Drawings(tuple[Drawing, ...]):
    """Several drawings, which are displayed one below the other."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        return "\n".join(one._repr_html_() for one in self)


def drawings(case: CaseResult) -> Drawings:
    """Sketch, figures and convergence plot of a judged case, as far as they exist."""
    return Drawings(
        Drawing(title, made["svg"]) for title, svg in _parts(case) if (made := standalone(svg))
    )


def table(header: Sequence[str], rows: Sequence[Sequence[str]], title: str = "") -> Markup:
    """HTML table of cells with escaped text."""
    caption = Markup("<caption>{}</caption>").format(title) if title else ""
    head = _line("th", header) if header else ""
    lines = Markup("").join(_line("td", row) for row in rows)
    return Markup('<table style="text-align: left">{}{}{}</table>').format(caption, head, lines)


def _line(tag: str, cells: Sequence[str]) -> Markup:
    """Line of a table; `tag` is th or td."""
    cell = Markup(f'<{tag} style="text-align: left">{{}}</{tag}>')  # noqa: S704 - one of two
    return Markup("<tr>{}</tr>").format(Markup("").join(cell.format(text) for text in cells))


def _parts(case: CaseResult) -> Iterator[tuple[str, str]]:
    if case.sketch:
        yield case.sketch.title, sketch(case.sketch)
    for figure in case.figures:
        yield figure.title, plot(figure)
    yield "Convergence", convergence(case.rows)

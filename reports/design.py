"""Page of a design task: a single file without scripts."""

from collections.abc import Sequence
from dataclasses import dataclass

import jinja2
from markupsafe import Markup

from reports import figures, formats
from reports.design_plots import Bars, Parallel, Region, bars, parallel, region
from reports.environment import HERE, columns
from reports.html import styles
from reports.sketch import sketch
from verify.core.figures import Figure, Sketch, Table

Picture = Figure | Bars | Region | Parallel


@dataclass(frozen=True, kw_only=True)
class Tile:
    """A number at the top of the page; `css` is "" or a status such as is-pass."""

    number: str
    words: str
    css: str = ""


@dataclass(frozen=True, kw_only=True)
class DesignPage:
    """Content of the page of a design task.

    `failure` has one line per failed criterion. `subject` is the designed object in one word, and
    `of` in a few words. `front` is the table of results with the name `front_name`, and `checks`
    are the tables of the criteria.
    """

    name: str
    subject: str = "spring"
    of: str = "an accordion spring"
    front_name: str = "Pareto front"
    checks: Sequence[Table] = ()
    meta: str
    tiles: Sequence[Tile]
    failure: Sequence[str]
    warnings: Sequence[str]
    lead: str
    sketch: Sketch | None
    chosen: Sequence[tuple[str, str, str]]
    """Symbol, what it is, value with unit."""
    limits: Table
    front: Table | None
    relaxations: Sequence[Table]
    figures: Sequence[Picture]
    steps: Sequence[str]
    inputs: Sequence[tuple[str, str, str]]
    command: str


def page(design: DesignPage) -> str:
    """HTML of the page."""
    env = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE), autoescape=True, trim_blocks=True,
        lstrip_blocks=True, undefined=jinja2.StrictUndefined,
    )  # fmt: skip
    env.filters |= {
        "symbol": formats.symbol, "prose": formats.prose, "plot": plot, "sketch": sketch,
        "columns": columns,
    }  # fmt: skip
    css = Markup(styles())  # noqa: S704 - files of the project
    return env.get_template("design.html.j2").render(page=design, css=css)


def plot(figure: Picture) -> Markup:
    """SVG of a figure."""
    match figure:
        case Bars():
            return bars(figure)
        case Region():
            return region(figure)
        case Parallel():
            return parallel(figure)
        case _:
            return figures.plot(figure)

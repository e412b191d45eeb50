"""Page of a sweep: a single file without scripts."""

from collections.abc import Sequence
from dataclasses import dataclass

import jinja2
from markupsafe import Markup

from reports import figures, formats
from reports.design import Tile
from reports.environment import HERE, columns
from reports.html import styles
from reports.measured import Measured
from reports.slim import slim
from reports.sweep_plots import Causes, Histogram, causes, histogram
from reports.validity_map import has_nominal, measured, scale_key, validity_map
from verify.core.figures import Figure, Table


@dataclass(frozen=True, kw_only=True)
class Panels:
    """Small maps or curves side by side, each with a title, and one common key."""

    title: str
    maps: tuple[Measured, ...]
    note: str = ""


Picture = Figure | Measured | Histogram | Causes


@dataclass(frozen=True, kw_only=True)
class Formula:
    """Result of a sweep for one formula: sentence, tables, figures, `panels` of small figures.

    `kind` is the name of the comparison; `opened` states whether all details are visible at first.
    """

    anchor: str
    name: str
    symbol: str
    kind: str
    verdict: str
    tables: Sequence[Table]
    figures: Sequence[Picture]
    panels: Sequence[Panels] = ()
    note: str = ""
    opened: bool = False


@dataclass(frozen=True, kw_only=True)
class SweepPage:
    """Content of the page of a sweep.

    `overview` is a table with a line for each of `formulas`, in their order. `problems` state the
    number of failed points and the reasons. `varied` and `inputs` contain symbol, meaning and
    value; `facts` and `files` contain name and content.
    """

    name: str
    kicker: str
    meta: str
    tiles: Sequence[Tile]
    problems: Sequence[str]
    lead: str
    overview: Table
    formulas: Sequence[Formula]
    points: Table
    varied: Sequence[tuple[str, str, str]]
    inputs: Sequence[tuple[str, str, str]]
    facts: Sequence[tuple[str, str]]
    command: str
    files: Sequence[tuple[str, str]]


def page(sweep: SweepPage) -> str:
    """HTML of the page."""
    env = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE), autoescape=True, trim_blocks=True,
        lstrip_blocks=True, undefined=jinja2.StrictUndefined,
    )  # fmt: skip
    env.filters |= {
        "symbol": formats.symbol, "prose": prose, "plot": plot, "columns": columns,
        "small": validity_map, "flat": flat, "key": key,
    }  # fmt: skip
    css = Markup(styles())  # noqa: S704 - files of the project
    return slim(env.get_template("sweep.html.j2").render(page=sweep, css=css))


def prose(text: str) -> Markup:
    """HTML of running text in which no number is separated from its per cent sign."""
    return formats.prose(flat(text))


def flat(text: str) -> str:
    """Text without markup, for attributes."""
    return text.replace(" %", "\u202f%")


def key(panels: Sequence[Panels]) -> Markup:
    """SVG of the key of the colours and marks that all maps of the panels share."""
    maps = [m for one in panels for m in one.maps]
    return scale_key(maps[0].limits, marked=any(has_nominal(m) for m in maps))


def plot(figure: Picture) -> Markup:
    """SVG of a figure."""
    match figure:
        case Measured():
            return measured(figure)
        case Histogram():
            return histogram(figure)
        case Causes():
            return causes(figure)
        case _:
            return figures.plot(figure)

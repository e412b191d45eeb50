"""Figures of a design search: rejected candidates by limit, feasible region, Pareto front."""

from dataclasses import dataclass

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray

from reports import svg
from reports.axes import WIDTH
from verify.core.figures import Array

LINE, SWATCH, LETTER = 18.0, 14.0, 6.2
CELL_TOP = 26.0
MANY = 3  # limits violated, or more


@dataclass(frozen=True, kw_only=True)
class Bars:
    """Bar chart: for each limit, how many of `total` candidates violate it.

    `names` of limits and `counts` of candidates are in the same order.
    """

    title: str
    names: tuple[str, ...]
    counts: tuple[int, ...]
    total: int
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Region:
    """Map of the number of violated limits over two parameters.

    `violated` is (k, m); it is -1 where no spring is possible. `columns` and
    `rows` [in the units of the labels] are ascending; `mark` is a pair (row, column).
    """

    title: str
    x_label: str
    y_label: str
    columns: tuple[float, ...]
    rows: tuple[float, ...]
    violated: NDArray[np.int64]
    mark: tuple[int, int]
    mark_name: str
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Parallel:
    """Plot of lines (k, m) over m axes; 0 at the top is the best value, 1 the worst.

    `ends` are the best and the worst value of every axis. `chosen` is the number of the selected
    line. `kept` marks the lines that finite elements confirm.
    """

    title: str
    axes: tuple[str, ...]
    ends: tuple[tuple[str, str], ...]
    lines: Array
    kept: tuple[bool, ...]
    chosen: int
    note: str = ""


def bars(b: Bars) -> Markup:
    """SVG with one bar per limit, relative to all candidates."""
    left, right, high = 118.0, WIDTH - 62.0, 24.0
    body = []
    for k, (name, count) in enumerate(zip(b.names, b.counts, strict=True)):
        y = 8.0 + high * k
        width = (right - left) * count / max(b.total, 1)
        body.append(svg.text(left - 8, y + 14, name, "label", "end"))
        body.append(svg.rectangle(left, y + 3, right - left, 14, "track"))
        body.append(svg.rectangle(left, y + 3, width, 14, "share"))
        body.append(svg.text(WIDTH, y + 14, f"{count:,}", "tick", "end"))
    return svg.drawing(WIDTH, 12 + high * len(b.names), body, b.title, "chart bars")


def region(g: Region) -> Markup:
    """SVG of cells coloured by the number of violated limits; the selected one is marked."""
    rows, columns = g.violated.shape
    left, right = 52.0, 8.0
    width = (WIDTH - left - right) / columns
    high = min(24.0, max(7.0, 190.0 / rows))
    bottom = CELL_TOP + high * rows
    body = [svg.text(left - 42, CELL_TOP - 12, g.y_label, "label")]
    for k, j in np.ndindex(rows, columns):
        count = int(g.violated[k, j])
        css = "none" if count < 0 else f"m{min(count, MANY)}"
        x, y = left + width * j, bottom - high * (k + 1)
        body.append(svg.rectangle(x, y, width, high, css))
    k, j = g.mark
    body.append(
        svg.circle(left + width * (j + 0.5), bottom - high * (k + 0.5), min(high, 12.0) / 3, "at")
    )
    every = max(1, -(-rows // 9))
    for k in range(0, rows, every):
        words = svg.plain(g.rows[k])
        body.append(svg.text(left - 6, bottom - high * (k + 0.5) + 4, words, "tick", "end"))
    every = max(1, -(-columns // 7))
    for j in range(0, columns, every):
        words = svg.plain(g.columns[j])
        body.append(svg.text(left + width * (j + 0.5), bottom + 15, words, "tick", "middle"))
    body.append(svg.text(WIDTH - right, bottom + 31, g.x_label, "label", "end"))
    named = [
        ("m0", "feasible"),
        ("m1", "one limit violated"),
        ("m2", "two limits"),
        ("m3", "more limits"),
    ]
    if (g.violated < 0).any():
        named.append(("none", "no spring"))
    body += _key([*named, ("at", g.mark_name)], bottom + 52)
    return svg.drawing(WIDTH, bottom + 80, body, g.title, "chart map")


def _key(named: list[tuple[str, str]], top: float) -> list[Markup]:
    drawn: list[Markup] = []
    left, row = 12.0, 0
    for css, words in named:
        wide = SWATCH + 6 + LETTER * len(words) + 14
        if left > 12.0 and left + wide > WIDTH:
            left, row = 12.0, row + 1
        y = top + LINE * row
        if css == "at":
            drawn.append(svg.circle(left + SWATCH / 2, y - 4, 4, "at"))
        else:
            drawn.append(svg.rectangle(left, y - 10, SWATCH, 12, f"{css} swatch"))
        drawn.append(svg.text(left + SWATCH + 6, y, words, "tick"))
        left += wide
    return drawn


def parallel(p: Parallel) -> Markup:
    """SVG with one line per spring across the axes; the best end of each axis is at the top."""
    top, bottom, left, right = 46.0, 236.0, 44.0, WIDTH - 44.0
    x = np.linspace(left, right, len(p.axes))
    body = []
    for at, name, (best, worst) in zip(x, p.axes, p.ends, strict=True):
        body += [
            svg.line(at, top, at, bottom, "axis"),
            svg.text(at, top - 26, name, "label", "middle"),
            svg.text(at, top - 10, best, "tick", "middle"),
            svg.text(at, bottom + 18, worst, "tick", "middle"),
        ]
    order = sorted(range(len(p.lines)), key=lambda k: (k == p.chosen, p.kept[k]))
    for k in order:  # the chosen line on top
        points = list(zip(x, top + (bottom - top) * p.lines[k], strict=True))
        css = "fit s2 strong" if k == p.chosen else "fit s0" if p.kept[k] else "fit s4 dashes"
        body.append(svg.polyline(points, css))
    named = [("fit s2 strong", "chosen")]
    if any(kept for k, kept in enumerate(p.kept) if k != p.chosen):
        named.append(("fit s0", "on the front"))
    if not all(p.kept):
        named.append(("fit s4 dashes", "not confirmed by finite elements"))
    at = 12.0
    for css, words in named:
        body.append(svg.line(at, bottom + 42, at + 22, bottom + 42, css))
        body.append(svg.text(at + 28, bottom + 46, words, "tick"))
        at += 28 + LETTER * len(words) + 18
    return svg.drawing(WIDTH, bottom + 54, body, p.title, "chart parallel")

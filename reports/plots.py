"""Plots about 400 units wide, legible on a phone: profiles, convergence, values side by side."""

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.outlines import simplified
from verify.core.figures import Array, Dots, Profile
from verify.core.references import is_finite_elements
from verify.core.results import Kind, Row

WIDTH, HEIGHT = 400.0, 300.0
UNSEEN = 0.05  # pixels: invisible deviation of a line
LABEL = 36.0  # width of a mesh size's label


@dataclass
class Axes:
    """A plotting box (left, top, right, bottom) with the ranges of x and y; collects `body`."""

    box: tuple[float, float, float, float]
    x: tuple[float, float]
    y: tuple[float, float]
    log: bool = False
    body: list[Markup] = field(default_factory=list)
    y_log: bool = False
    x_log: bool = False

    def X(self, value: float) -> float:
        """Abscissa of x in the image."""
        return _between(value, self.x, (self.box[0], self.box[2]), self.log or self.x_log)

    def Y(self, value: float) -> float:
        """Ordinate of y in the image."""
        return _between(value, self.y, (self.box[3], self.box[1]), self.log or self.y_log)

    def grid(self, values: Sequence[float], name: Callable[[float], str | Markup]) -> None:
        """Horizontal lines with their numbers."""
        left, _, right, _ = self.box
        for v in values:
            self.body += [
                svg.line(left, self.Y(v), right, self.Y(v), "grid"),
                _tick(left - 6, self.Y(v) + 4, name(v), "end"),
            ]

    def base(self, values: Sequence[float], name: Callable[[float], str | Markup]) -> None:
        """The horizontal axis with its numbers."""
        left, _, right, bottom = self.box
        self.body.append(svg.line(left, bottom, right, bottom, "axis"))
        for v in values:
            self.body += [
                svg.line(self.X(v), bottom, self.X(v), bottom + 4, "axis"),
                _tick(self.X(v), bottom + 16, name(v), "middle"),
            ]

    def titles(self, x: str, y: str) -> None:
        """Titles of both axes."""
        left, top, right, bottom = self.box
        self.body += [svg.text(left - 40, top - 10, y, "label")] if y else []
        self.body += [svg.text(right, bottom + 31, x, "label", "end")] if x else []

    def curve(self, x: Array, y: Array, css: str) -> None:
        """A line through points, without those that change nothing visible."""
        self.body.append(svg.polyline(self._line(x, y), css))

    def ribbon(self, x: Array, low: Array, high: Array, css: str) -> None:
        """The area between two curves."""
        up, down = self._line(x, high), self._line(x, low)
        self.body.append(svg.polyline([*up, *down[::-1]], css, closed=True))

    def _line(self, x: Array, y: Array) -> Array:
        """Points in the image, as many as the shape of the line needs."""
        points = np.array([(self.X(a), self.Y(b)) for a, b in zip(x, y, strict=True)])
        return simplified(points, UNSEEN) if len(points) > 2 else points

    def dots(self, x: Array, y: Array, css: str, r: float = 2.6, shape: int = 0) -> None:
        """Points, as dots or another of the shapes of marks."""
        self.body += [
            svg.marker(self.X(a), self.Y(b), r, css, shape) for a, b in zip(x, y, strict=True)
        ]


def profile(p: Profile) -> Markup:
    """The reference on the formula, and below their difference in the band of its uncertainty."""
    x = float(min(p.x.min(), p.x_fem.min())), float(max(p.x.max(), p.x_fem.max()))
    low, high = min(p.y.min(), p.y_fem.min()), max(p.y.max(), p.y_fem.max())
    margin = 0.06 * (high - low) or abs(high) or 1.0
    top = Axes((52, 28, 390, 168), x, (float(low - margin), float(high + margin)))
    top.grid(svg.ticks(*top.y), svg.plain)
    top.titles("", p.y_label)
    top.curve(p.x, p.y, "formula")
    top.dots(p.x_fem, p.y_fem, "fe")
    rest, U = (p.y_ref - p.y_fem) / p.scale, 2 * p.u / p.scale
    reach = 1.2 * float(max(np.abs(rest).max(), U.max(), 1e-15))
    exponent = math.floor(math.log10(reach))
    k = 10.0**exponent
    below = Axes((52, 204, 390, 262), x, (-reach / k, reach / k))
    below.ribbon(p.x_fem, -U / k, U / k, "band")
    step = max(s for s in (1, 2, 5) if s <= reach / k * (1 + 1e-9))
    below.grid([-step, 0, step], svg.plain)
    below.base(svg.ticks(*x, 6), svg.plain)
    below.titles(p.x_label, "")
    below.body.append(
        Markup('<text class="label" x="12" y="194">{}, in {}</text>').format(
            svg.lowered(_rest(p)), svg.decade(exponent)
        )
    )
    below.dots(p.x_fem, rest / k, "fe", 2.2)
    label = f"{p.title}: reference on the formula, and their difference"
    return svg.drawing(WIDTH, HEIGHT, top.body + below.body, label, "chart")


def _rest(p: Profile) -> str:
    """Description of the lower part of a profile."""
    difference = f"formula {svg.MINUS} reference"
    if p.scale == 1 and not p.scale_name:
        return difference
    unit = re.search(r"\[([^\]]+)\]$", p.y_label)
    number = svg.plain(float(f"{p.scale:.4g}"))
    return f"({difference})/{p.scale_name or (f'({number} {unit[1]})' if unit else number)}"


def convergence(rows: Sequence[Row]) -> Markup:
    """Distance to the finest value (errors, where an order is judged) over mesh size, log-log.

    One colour an order of theory, so that parallel lines of one colour are the message; rows
    whose levels show no order (noise, oscillation) would only cross them and are left out.
    """
    series = [(row, s) for row in rows if (s := distances(row)) and has_order(row)]
    if not series:
        return Markup("")
    orders = sorted({row.formal_order or 0.0 for row, _ in series}, reverse=True)
    h = sorted({x for _, s in series for x, _ in s})
    d = [y for _, s in series for _, y in s]
    low, high = math.floor(math.log10(min(d))), math.ceil(math.log10(max(d)) + 1e-9)
    axes = Axes(
        (52, 28, 330, 262), (h[0] * 0.85, h[-1] * 1.18), (10.0**low, 10.0 ** max(high, low + 1)),
        log=True,
    )  # fmt: skip
    every = -(-(high - low) // 7) or 1
    axes.grid([10.0**e for e in range(low, high + 1, every)], lambda v: svg.decade(_exponent(v)))
    axes.base(_apart(h, axes), lambda v: f"{v:.3g}")
    finer = "mesh size" if on_meshes([row for row, _ in series]) else "refinement"
    axes.titles(f"{finer}, relative", "difference, relative")
    for row, s in series:
        colour = f"s{_colour(row.formal_order or 0.0)}"
        start = len(axes.body)
        x, y = np.array(s).T
        axes.curve(x, y, f"fit {colour}")
        axes.dots(x, y, colour)
        group = Markup("").join(axes.body[start:])
        axes.body[start:] = [
            Markup("<g><title>{}</title>{}</g>").format(f"{row.quantity} ({_order(row)})", group)
        ]
    axes.body += _legend(axes, orders, series)
    count = f"{len(series)} quantities approach their finest value"
    return svg.drawing(WIDTH, HEIGHT, axes.body, count, "chart")


def on_meshes(rows: Sequence[Row]) -> bool:
    """Whether any of the rows is of finite elements; others refine steps or slices."""
    return any(is_finite_elements(row) for row in rows)


def _apart(h: Sequence[float], axes: Axes) -> list[float]:
    """Mesh sizes, from the coarsest, whose labels do not run into each other."""
    kept: list[float] = []
    for value in sorted(h, reverse=True):
        if not kept or axes.X(kept[-1]) - axes.X(value) > LABEL:
            kept.append(value)
    return kept


def _legend(
    axes: Axes, orders: list[float], series: Sequence[tuple[Row, list[tuple[float, float]]]]
) -> list[Markup]:
    """Name of each colour beside the coarse end of its lines."""
    ends = []
    for i, order in enumerate(orders):
        mine = [s for row, s in series if (row.formal_order or 0.0) == order]
        at = np.median([axes.Y(max(s)[1]) for s in mine])
        ends.append((float(at), i, f"order {order:g}" if order else "no theory", len(mine)))
    found, last = [], 12.0
    for at, i, name, count in sorted(ends):
        last = max(at, last + 30)
        found += [
            svg.text(340, last, name, f"direct s{_colour(orders[i])}"),
            svg.text(340, last + 13, f"{count} row{'s' * (count > 1)}", "tick"),
        ]
    return found


def _colour(order: float) -> int:
    """One colour an order, the same in every plot."""
    return {4.0: 0, 3.0: 1, 2.0: 2, 1.0: 3}.get(order, 4)


def has_order(row: Row) -> bool:
    """Whether the row's levels show an order of convergence."""
    return row.order != "round-off" and (row.grid is None or row.grid.order is not None)


def distances(row: Row) -> list[tuple[float, float]]:
    """Mesh size and relative distance of each level but the last, or the stored errors."""
    if len(row.levels) < 3:
        return []
    if row.kind is Kind.ASYMPTOTIC or (row.kind is Kind.TREND and row.fem != row.order):
        return []  # levels of another parameter than the mesh
    if row.kind is Kind.TREND:
        return [(h, abs(e)) for h, e in row.levels if e]
    finest = row.levels[-1][1]
    scale = row.scale or abs(finest) or 1.0
    return [(h, abs(v - finest) / scale) for h, v in row.levels[:-1] if v != finest]


def dots(d: Dots) -> Markup:
    """Values of one quantity below each other, with half-widths where they have one."""
    ends = [(v - (w or 0), v + (w or 0)) for _, v, w, _ in d.items]
    low, high = min(a for a, _ in ends), max(b for _, b in ends)
    margin = 0.08 * (high - low) or abs(high) * 0.05 or 1.0
    height = 58.0 + 22 * len(d.items)
    axes = Axes((200, 14, 390, height - 44), (low - margin, high + margin), (len(d.items), 0.0))
    for i, (name, value, wide, whose) in enumerate(d.items):
        y = axes.Y(i + 0.5)
        axes.body += [
            svg.line(axes.box[0], y, axes.box[2], y, "grid"),
            svg.text(axes.box[0] - 8, y + 4, name, "tick", "end"),
        ]
        if wide:
            axes.body.append(svg.line(axes.X(value - wide), y, axes.X(value + wide), y, whose))
        axes.body.append(svg.circle(axes.X(value), y, 3.4, whose))
    axes.base(svg.ticks(*axes.x, 5), svg.plain)
    axes.titles(d.label, "")
    return svg.drawing(WIDTH, height, axes.body, d.title, "chart")


def _tick(x: float, y: float, words: str | Markup, anchor: str) -> Markup:
    return Markup('<text class="tick" x="{}" y="{}" text-anchor="{}">{}</text>').format(
        svg.short(x), svg.short(y), anchor, words
    )


def _between(
    value: float, span: tuple[float, float], image: tuple[float, float], log: bool
) -> float:
    low, high = span
    if log:
        value, low, high = (math.log10(max(v, 1e-300)) for v in (value, low, high))
    return image[0] + (value - low) / (high - low) * (image[1] - image[0])


def _exponent(value: float) -> int:
    return round(math.log10(value))


def _order(row: Row) -> str:
    return f"order {row.order:.2f}" if isinstance(row.order, float) else "no order"

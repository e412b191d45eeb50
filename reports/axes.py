"""Plotting area with axes, about 400 units wide and legible on a phone."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.outlines import simplified
from verify.core.figures import Array

WIDTH, HEIGHT = 400.0, 300.0
UNSEEN = 0.05  # pixels: invisible deviation of a line


@dataclass
class Axes:
    """A plotting area (left, top, right, bottom) with the ranges of x and y.

    The SVG elements are collected in `body`.
    """

    box: tuple[float, float, float, float]
    x: tuple[float, float]
    y: tuple[float, float]
    log: bool = False
    body: list[Markup] = field(default_factory=list)
    y_log: bool = False
    x_log: bool = False

    def X(self, value: float) -> float:
        """Abscissa of the value x in the image."""
        return _between(value, self.x, (self.box[0], self.box[2]), self.log or self.x_log)

    def Y(self, value: float) -> float:
        """Ordinate of the value y in the image."""
        return _between(value, self.y, (self.box[3], self.box[1]), self.log or self.y_log)

    def grid(self, values: Sequence[float], name: Callable[[float], str | Markup]) -> None:
        """Add horizontal grid lines with their numbers."""
        left, _, right, _ = self.box
        for v in values:
            self.body += [
                svg.line(left, self.Y(v), right, self.Y(v), "grid"),
                _tick(left - 6, self.Y(v) + 4, name(v), "end"),
            ]

    def base(self, values: Sequence[float], name: Callable[[float], str | Markup]) -> None:
        """Add the horizontal axis with its numbers."""
        left, _, right, bottom = self.box
        self.body.append(svg.line(left, bottom, right, bottom, "axis"))
        for v in values:
            self.body += [
                svg.line(self.X(v), bottom, self.X(v), bottom + 4, "axis"),
                _tick(self.X(v), bottom + 16, name(v), "middle"),
            ]

    def titles(self, x: str, y: str) -> None:
        """Add the titles of both axes."""
        left, top, right, bottom = self.box
        self.body += [svg.text(left - 40, top - 10, y, "label")] if y else []
        self.body += [svg.text(right, bottom + 31, x, "label", "end")] if x else []

    def curve(self, x: Array, y: Array, css: str) -> None:
        """Add a line through points; points that have no visible effect are omitted."""
        self.body.append(svg.polyline(self._line(x, y), css))

    def ribbon(self, x: Array, low: Array, high: Array, css: str) -> None:
        """Add the area between two curves."""
        up, down = self._line(x, high), self._line(x, low)
        self.body.append(svg.polyline([*up, *down[::-1]], css, closed=True))

    def _line(self, x: Array, y: Array) -> Array:
        """Points in the image, reduced to those that the shape of the line requires."""
        points = np.array([(self.X(a), self.Y(b)) for a, b in zip(x, y, strict=True)])
        return simplified(points, UNSEEN) if len(points) > 2 else points

    def dots(self, x: Array, y: Array, css: str, r: float = 2.6, shape: int = 0) -> None:
        """Add marks at points, as dots or in another shape."""
        self.body += [
            svg.marker(self.X(a), self.Y(b), r, css, shape) for a, b in zip(x, y, strict=True)
        ]


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

"""Sketch of a case from its shapes, to scale, with arrows, dimensions and labels."""

import math
import re
from collections.abc import Callable

import numpy as np
from markupsafe import Markup

from reports import svg
from verify.core.figures import Array, Sketch

WIDTH, HEIGHT = 400.0, 300.0
MARGIN = 34.0  # for labels around the drawing
LETTER, LINE = 7.0, 14.0  # width of one in a label, on average, and from line to line
_LABEL = re.compile(r'<text class="[^"]*" x="(\S+)" y="\S+" text-anchor="(\w+)">(.*?)</text>')
_PLACED = re.compile(
    r'(<text class="[^"]*" x="(\S+)" y=")(\S+)(" text-anchor="(\w+)">(.*?)</text>)'
)
SHARE = {"start": 0.0, "middle": 0.5, "end": 1.0}  # of a label that is left of its point
_TAG = re.compile("<[^>]*>|&#?\\w+;")

Points = list[tuple[float, float]]


def sketch(data: Sketch | None) -> Markup:
    """SVG of the sketch, at most 400 by 300; empty without data."""
    if data is None or not data.shapes:
        return Markup("")
    points = np.vstack([np.reshape(s.points, (-1, 2)) for s in data.shapes])
    low, high = points.min(axis=0), points.max(axis=0)
    size = np.maximum(high - low, 1e-300)
    k = min((WIDTH - 2 * MARGIN) / size[0], (HEIGHT - 2 * MARGIN) / size[1])
    left = (WIDTH - k * size[0]) / 2

    def at(xy: Array) -> Points:
        """Points in the image; y points upwards in the sketch."""
        return [
            (left + k * (x - low[0]), MARGIN + k * (high[1] - y))
            for x, y in np.reshape(xy, (-1, 2))
        ]

    body = [DRAW[s.style](at(s.points), s.label) for s in data.shapes]
    height = 2 * MARGIN + k * size[1]
    return _widened(_apart(svg.drawing(WIDTH, height, body, data.title, "sketch"), height))


def _apart(drawn: Markup, height: float) -> Markup:
    """Drawing in which labels that would overlap are moved away from its centre."""
    taken: list[tuple[float, float, float]] = []

    def placed(label: re.Match[str]) -> str:
        x, y, anchor, inner = float(label[2]), float(label[3]), label[5], label[6]
        wide = LETTER * len(_TAG.sub("", inner))
        left = x - wide * SHARE[anchor]
        while any(
            abs(y - base) < LINE and left < right and start < left + wide
            for start, right, base in taken
        ):
            y += math.copysign(LINE, y - height / 2)
        taken.append((left, left + wide, y))
        return f"{label[1]}{svg.short(y)}{label[4]}"

    return Markup(_PLACED.sub(placed, str(drawn)))  # noqa: S704 - numbers alone are changed


def _widened(drawn: Markup) -> Markup:
    """Drawing with space for its longest labels, which would be cut on paper and narrow screens."""
    left, right = 0.0, WIDTH
    for x, anchor, inner in _LABEL.findall(drawn):
        wide = LETTER * len(_TAG.sub("", inner))
        start = float(x) - wide * SHARE[anchor]
        left, right = min(left, start), max(right, start + wide)
    box = f'viewBox="{math.floor(left)} 0 {math.ceil(right) - math.floor(left)} '
    return Markup(str(drawn).replace(f'viewBox="0 0 {WIDTH:g} ', box, 1))  # noqa: S704 - numbers alone


def _closed(css: str) -> Callable[[Points, str], Markup]:
    return lambda points, label: svg.polyline(points, css, closed=True) + _beside(points, label)


def _open(css: str) -> Callable[[Points, str], Markup]:
    return lambda points, label: svg.polyline(points, css) + _beside(points, label)


def _beside(points: Points, label: str) -> Markup:
    """SVG of a label above and to the right of the last point."""
    if not label:
        return Markup("")
    x, y = points[-1]
    return svg.text(x + 5, y - 6, label, "sym")


def _load(points: Points, label: str) -> Markup:
    (x0, y0), (x1, y1) = points[-2], points[-1]
    parts = svg.polyline(points, "load") + svg.arrow_head(x1, y1, x1 - x0, y1 - y0, "head")
    return parts + _away(points[0], (x0 - x1, y0 - y1), label)


def _dimension(points: Points, label: str) -> Markup:
    (x0, y0), (x1, y1) = points[0], points[-1]
    dx, dy = x1 - x0, y1 - y0
    length = math.hypot(dx, dy) or 1.0
    parts = svg.line(x0, y0, x1, y1, "dim")
    parts += svg.arrow_head(x0, y0, -dx, -dy, "dim-head", 6)
    parts += svg.arrow_head(x1, y1, dx, dy, "dim-head", 6)
    if length < 16:  # no room between: beside it
        return parts + svg.text(max(x0, x1) + 7, (y0 + y1) / 2 + 4, label, "sym")
    nx, ny = dy / length, -dx / length
    if ny > 1e-9 or (abs(ny) <= 1e-9 and nx < 0):  # above, or to the right
        nx, ny = -nx, -ny
    upright = abs(dx) < abs(dy)
    if upright:  # on the outer side
        side = math.copysign(1.0, (x0 + x1) / 2 - WIDTH / 2)
        anchor = "start" if side > 0 else "end"
        return parts + svg.text((x0 + x1) / 2 + 7 * side, (y0 + y1) / 2 + 4, label, "sym", anchor)
    x, y = (x0 + x1) / 2 + 7 * nx, (y0 + y1) / 2 + 6 * ny
    return parts + svg.text(x, y, label, "sym", "middle")


def _angle(points: Points, label: str) -> Markup:
    """SVG of an arc with arrow heads at both ends."""
    parts = svg.polyline(points, "dim")
    for tip, before in ((0, 1), (-1, -2)):
        (x, y), (x0, y0) = points[tip], points[before]
        parts += svg.arrow_head(x, y, x - x0, y - y0, "dim-head", 6)
    return parts + _beside(points, label)


def _leader(points: Points, label: str) -> Markup:
    (x0, y0), (x1, y1) = points[0], points[-1]
    parts = svg.line(x0, y0, x1, y1, "dim") + svg.arrow_head(
        x1, y1, x1 - x0, y1 - y0, "dim-head", 6
    )
    return parts + _away((x0, y0), (x0 - x1, y0 - y1), label)


def _clamp(points: Points, _label: str) -> Markup:
    """SVG of a wall, hatched on the left of the direction in which it is drawn."""
    (x0, y0), (x1, y1) = points[0], points[-1]
    length = math.hypot(x1 - x0, y1 - y0) or 1.0
    c, s = (x1 - x0) / length, (y1 - y0) / length
    strokes = [svg.line(x0, y0, x1, y1, "wall")]
    for i in range(max(2, round(length / 6)) + 1):
        t = length * i / max(2, round(length / 6))
        x, y = x0 + c * t, y0 + s * t
        strokes.append(svg.line(x, y, x + 5 * s - 4 * c, y - 5 * c - 4 * s, "hatch"))
    return Markup("").join(strokes)


def _words(points: Points, label: str) -> Markup:
    return svg.text(*points[0], label, "sym", "middle")


def _away(start: tuple[float, float], along: tuple[float, float], label: str) -> Markup:
    """SVG of a label just beyond the start of an arrow."""
    dx, dy = along
    length = math.hypot(dx, dy) or 1.0
    x, y = start[0] + 6 * dx / length, start[1] + 10 * dy / length + 4
    anchor = "start" if dx > 0.3 * length else "end" if dx < -0.3 * length else "middle"
    return svg.text(x, y, label, "sym", anchor) if label else Markup("")


DRAW: dict[str, Callable[[Points, str], Markup]] = {
    "body": _closed("body"),
    "modelled": _closed("modelled"),
    "hole": _closed("hole"),
    "line": _open("leaf"),
    "axis": _open("centre"),
    "faint": _open("faint"),
    "clamp": _clamp,
    "load": _load,
    "dimension": _dimension,
    "leader": _leader,
    "angle": _angle,
    "text": _words,
}

"""Plot of zones with names in a plane, with curves over the zones and a marked point."""

from collections.abc import Sequence

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray

from reports import svg
from reports.axes import HEIGHT, WIDTH, Axes
from reports.curves import key, style
from verify.core.figures import Array, Zone, Zones

LINE = 18.0  # height of a line of the key
LETTER = 7.0  # about the width of a letter of a zone's name
TALL = 15.0  # room that a name needs
EDGE = 6.0
FAR = 1_000_000  # more than any curve's points

Box = tuple[float, float, float, float]  # left, top, right, bottom


def zones(z: Zones) -> Markup:
    """SVG of zones from the lowest to the highest; each name is where its zone is tallest.

    The name of a zone without enough space is omitted.
    """
    x = np.asarray(z.x, dtype=float)
    axes = Axes((52, 28, 390, 262), (float(x[0]), float(x[-1])), (0.0, z.y_top))
    floor, taken, names = np.zeros(x.size), _taken(axes, z), []
    for zone in z.zones:
        top = np.clip(np.nan_to_num(np.asarray(zone.top, dtype=float)), floor, z.y_top)
        if np.any(top > floor):
            axes.ribbon(x, floor, top, zone.tone)
            edge = (top > 0) & (top < z.y_top)
            _edges(axes, x, top, edge)
            names += _name(axes, zone, x, floor, top, taken)
        floor = top
    axes.grid(svg.ticks(*axes.y), svg.plain)
    axes.base(svg.ticks(*axes.x, 6), svg.plain)
    axes.titles(z.x_label, z.y_label)
    for curve in z.curves:
        u, v = np.asarray(curve.x, dtype=float), np.asarray(curve.y, dtype=float)
        seen = (axes.x[0] <= u) & (u <= axes.x[1]) & (v >= 0) & (v <= z.y_top)
        if np.count_nonzero(seen) > 1:
            axes.curve(u[seen], v[seen], style(curve))
    rows = key(axes, z.curves) if z.curves else 0
    axes.body += names
    if z.point is not None:
        axes.body += _mark(axes, z)
    return svg.drawing(WIDTH, HEIGHT + LINE * rows + 4, axes.body, z.title, "chart zones")


def _edges(axes: Axes, x: Array, top: Array, inside: NDArray[np.bool_]) -> None:
    """Draw the upper limit of a zone where it is not at the edge of the plot (`inside`)."""
    ends = np.flatnonzero(np.diff(np.concatenate([[0], inside.astype(int), [0]])))
    for start, stop in ends.reshape(-1, 2):
        part = slice(max(start - 1, 0), min(stop + 1, x.size))
        axes.curve(x[part], top[part], "edge")


def _taken(axes: Axes, z: Zones) -> list[Box]:
    """Places at which no name of a zone is drawn: vertical lines, and the point with its name."""
    found = [
        (axes.X(float(c.x[0])) - 4, 0.0, axes.X(float(c.x[0])) + 4, HEIGHT)
        for c in z.curves if np.ptp(c.x) == 0
    ]  # fmt: skip
    if z.point is not None:
        u, v = _place(axes, *z.point[:2])
        found += [(u - 8, v - 8, u + 8, v + 8), _beside(axes, z)[0]]
    return found


def _name(
    axes: Axes, zone: Zone, x: Array, floor: Array, top: Array, taken: Sequence[Box]
) -> list[Markup]:
    """The name of a zone where it has the largest free height; none if this is too small."""
    left = np.array([axes.X(v) for v in x])
    low = np.array([axes.Y(v) for v in floor])
    high = np.array([axes.Y(v) for v in top])
    half = LETTER * len(zone.name) / 2
    best, place = 0.0, None
    for middle in np.linspace(axes.box[0] + half + EDGE, axes.box[2] - half - EDGE, 40):
        over = np.abs(left - middle) <= half
        if not np.any(over):
            continue
        bottom, ceiling = float(low[over].min()), float(high[over].max())
        y = (bottom + ceiling) / 2
        box = float(middle) - half, y - TALL / 2, float(middle) + half, y + TALL / 2
        free = not any(_meet(box, other) for other in taken)
        if free and bottom - ceiling > max(best, TALL):
            best, place = bottom - ceiling, (float(middle), y + 4)
    return [svg.text(*place, zone.name, "zone", "middle")] if place else []


def _mark(axes: Axes, z: Zones) -> list[Markup]:
    """SVG of the point and its name; a point outside the plot is drawn at the edge."""
    assert z.point is not None
    (left, _, right, bottom), anchor = _beside(axes, z)
    x = left if anchor == "start" else right
    return [
        svg.circle(*_place(axes, *z.point[:2]), 5.0, "mark"),
        svg.text(x, bottom - 4, z.point[2], "named", anchor),
    ]


def _beside(axes: Axes, z: Zones) -> tuple[Box, str]:
    """Box for the name of the point, where it covers the fewest curves, and its text anchor."""
    assert z.point is not None
    u, v = _place(axes, *z.point[:2])
    wide, centre = LETTER * len(z.point[2]), (axes.box[0] + axes.box[2]) / 2
    boxes: list[tuple[int, Box, str]] = []
    for up in (True, False):
        low = v - 3 if up else v + TALL + 7
        for end in (u > centre, u <= centre):
            left = u - 10 - wide if end else u + 10
            box = left, low - TALL, left + wide, low
            out = left < axes.box[0] or left + wide > axes.box[2] or box[1] < axes.box[1]
            worse = FAR if out else _crossing(axes, z, box)
            boxes.append((worse, box, "end" if end else "start"))
    return min(boxes, key=lambda b: b[0])[1:]


def _crossing(axes: Axes, z: Zones, box: Box) -> int:
    """Number of densely interpolated points of the curves that are in a box."""
    count = 0
    for curve in z.curves:
        t = np.linspace(0, len(curve.x) - 1, 20 * len(curve.x))
        at = np.arange(len(curve.x))
        x, y = np.interp(t, at, curve.x), np.interp(t, at, curve.y)
        count += sum(
            box[0] < axes.X(a) < box[2] and box[1] < axes.Y(b) < box[3]
            for a, b in zip(x, y, strict=True)
        )
    return count


def _place(axes: Axes, x: float, y: float) -> tuple[float, float]:
    """Position of a point in the image; a point outside the plot is moved to the edge."""
    return (
        axes.X(min(max(x, axes.x[0]), axes.x[1])), axes.Y(min(max(y, axes.y[0]), axes.y[1])),
    )  # fmt: skip


def _meet(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]

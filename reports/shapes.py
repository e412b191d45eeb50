"""Drawing of several shapes of a thin body, such as a spring, to one scale."""

from collections.abc import Callable
from functools import partial

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.axes import WIDTH
from verify.core.figures import Array, Panel, Shapes

EDGE, GAP, NAME = 8.0, 16.0, 18.0  # around all, between panels, for a panel's name
LETTER = 6.2  # about the width of a letter of a name
LOWEST = 70.0  # panels lower than this go into two rows
TALLEST = 230.0
BAR = 30.0  # for the bar that gives the scale
MOST_ROWS = 3

Placed = Callable[[Array], Array]


def shapes(s: Shapes) -> Markup:
    """SVG of panels in as many rows as keep them legible, with a scale bar."""
    boxes = [_box(panel) for panel in s.panels]
    sizes = [high - low for low, high in boxes]
    scale, rows = _packed(sizes, [panel.name for panel in s.panels])
    body, top = [], EDGE
    for row in rows:
        height = scale * max(sizes[k][1] for k in row)
        left = EDGE
        for k in row:
            panel, corner = s.panels[k], np.array([boxes[k][0][0], boxes[k][1][1]])
            wide = _wide(scale * sizes[k][0], panel.name)
            at = np.array([left + (wide - scale * sizes[k][0]) / 2, top + NAME])
            body.append(svg.text(left + wide / 2, top + 11, panel.name, "tick", "middle"))
            body += _drawn(panel, partial(_place, at, scale, corner), s)
            left += wide + GAP
        top += NAME + height + GAP
    body += _bar(scale, s, top)
    if any(panel.dots is not None and len(panel.dots) for panel in s.panels):
        top += BAR
        body += _key(s.dots_name, top)
    return svg.drawing(WIDTH, top + BAR, body, s.title, "chart shapes")


def _box(panel: Panel) -> tuple[Array, Array]:
    points = np.concatenate([*panel.lines, *panel.faint])
    return points.min(axis=0), points.max(axis=0)


def _wide(width: float, name: str) -> float:
    return max(width, LETTER * len(name))


def _packed(sizes: list[Array], names: list[str]) -> tuple[float, list[list[int]]]:
    """Pixels per unit, and the panels of each row, for the fewest rows with legible panels."""
    scale, split = 1.0, [list(range(len(sizes)))]
    for count in range(1, min(MOST_ROWS, len(sizes)) + 1):
        split = [part.tolist() for part in np.array_split(np.arange(len(sizes)), count)]
        scale = min(_row_scale([sizes[k] for k in row], [names[k] for k in row]) for row in split)
        if scale * max(size[1] for size in sizes) >= LOWEST:
            break
    return scale, split


def _row_scale(sizes: list[Array], names: list[str]) -> float:
    """Largest scale at which the panels and names of a row fit the width, by bisection."""
    room = WIDTH - 2 * EDGE - GAP * (len(sizes) - 1)
    low, high = 0.0, TALLEST / max(max(size[1] for size in sizes), 1e-300)
    for _ in range(60):
        middle = (low + high) / 2
        wide = sum(_wide(middle * size[0], name) for size, name in zip(sizes, names, strict=True))
        low, high = (middle, high) if wide <= room else (low, middle)
    return low


def _place(at: Array, scale: float, corner: Array, points: Array) -> Array:
    """Points of a panel in the picture, with y downwards; the point `corner` is drawn at `at`."""
    return np.asarray(at + scale * (points - corner) * (1, -1), dtype=np.float64)


def _drawn(panel: Panel, place: Placed, s: Shapes) -> list[Markup]:
    body = [svg.polyline(place(line), "fit faint") for line in panel.faint]
    width = float(np.ptp(place(np.array([[0.0, 0.0], [s.thickness, 0.0]]))[:, 0]))
    for line in panel.lines:
        path = svg.polyline(place(line), "strip")
        body.append(Markup('<g stroke-width="{:.2f}">{}</g>').format(max(width, 1.0), path))
    if panel.dots is not None:
        body += [svg.circle(x, y, 2.4, "fe") for x, y in place(panel.dots)]
    return body


def _bar(scale: float, s: Shapes, top: float) -> list[Markup]:
    """SVG of a scale bar with a round length."""
    length = svg.ticks(0.0, 0.3 * WIDTH / scale, 2)[-1]
    y, right = top + 12, EDGE + scale * length
    return [
        svg.line(EDGE, y, right, y, "base"),
        *(svg.line(x, y - 3, x, y + 3, "base") for x in (EDGE, right)),
        svg.text(right + 6, y + 4, f"{svg.plain(length)} {s.unit}", "tick"),
    ]


def _key(name: str, top: float) -> list[Markup]:
    """SVG with the meaning of the dots, below the bar."""
    return [svg.circle(EDGE + 4, top, 2.4, "fe"), svg.text(EDGE + 12, top + 4, name, "tick")]

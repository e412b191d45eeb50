"""Campbell diagram: natural frequencies over the speed, with excitation lines."""

from collections.abc import Sequence

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.axes import WIDTH, Axes
from reports.curves import LINE, key, style
from reports.labels import Box, beside, spread
from verify.core.figures import Array, Band, Campbell, Curve

TOP, BOTTOM, KEY = 44.0, 292.0, 346.0
APART = 5.0  # clear of a name, for the next one
LETTER = 6.2  # about the width of a letter of a name
APART = 12.5  # between lines of names
LEADER = 10.0  # from the end of a branch to its name
WHIRLS = {1: ("forward", "line", 0), -1: ("backward", "dashes", 2), 0: ("neither", "line", 4)}


def campbell(c: Campbell) -> Markup:
    """SVG of the diagram; dots mark intersections of branches and excitation lines."""
    rays = [name for name, _ in c.excitations]
    room = LETTER * max(map(len, [*c.names, *rays]), default=0) + LEADER + 8
    speeds = np.asarray(c.speeds, dtype=float)
    high = float(np.nanmax(c.frequencies)) * 1.05 if c.y_top is None else c.y_top
    axes = Axes(
        (52, TOP, WIDTH - room, BOTTOM), (float(speeds[0]), float(speeds[-1])), (0.0, high or 1.0)
    )
    if c.range is not None:
        left, right = (axes.X(min(max(v, axes.x[0]), axes.x[1])) for v in c.range)
        axes.body.append(svg.rectangle(left, TOP, right - left, BOTTOM - TOP, "band"))
    axes.grid(svg.ticks(*axes.y), svg.plain)
    axes.base(svg.ticks(*axes.x, 6), svg.plain)
    axes.body.append(svg.text(12, 16, c.y_label, "label"))
    axes.titles(c.x_label, "")
    ends = _rays(axes, c)
    branches = np.asarray(c.frequencies, dtype=float).T
    for y, whirl, name in zip(branches, c.whirl, c.names or [""] * len(branches), strict=True):
        end = _branch(axes, speeds, y, whirl)
        if end is not None and name:
            ends.append((*end, name))
    _names(axes, ends)
    if c.peers is not None:
        axes.body += [_cross(axes.X(a), axes.Y(b)) for a, b in zip(*c.peers, strict=True)]
    _critical(axes, c)
    rows = _key(axes, c)
    return svg.drawing(WIDTH, KEY + LINE * (rows - 1) + 8, axes.body, c.title, "chart campbell")


def _rays(axes: Axes, c: Campbell) -> list[tuple[float, float, str]]:
    """Draw excitation lines through the origin; returns names that must be placed to the right.

    All other names are placed above the plot.
    """
    right, above = [], []
    for name, slope in c.excitations:
        low, end = max(axes.x[0], 0.0), axes.x[1]
        if slope <= 0 or end <= 0:
            continue
        out = slope * end > axes.y[1]
        end = axes.y[1] / slope if out else end
        if end <= low:
            continue
        x, y = axes.X(end), axes.Y(slope * end)
        axes.body.append(svg.line(axes.X(low), axes.Y(slope * low), x, y, "ray"))
        if out:
            above.append((x, name))
        else:
            right.append((x, y, name))
    above.sort()
    at = spread([x for x, _ in above], [LETTER * len(name) + 8 for _, name in above])
    for x, (_, name) in zip(at, above, strict=True):
        axes.body.append(svg.text(x, TOP - 5, name, "tick", "middle"))
    return right


def _branch(axes: Axes, x: Array, y: Array, whirl: int) -> tuple[float, float] | None:
    """Draw a branch as far as it is known and within the plot; returns its last point."""
    css = style(_shown(whirl))
    inside = np.isfinite(y) & (y >= axes.y[0]) & (y <= axes.y[1])
    steps = np.flatnonzero(np.diff(np.concatenate([[0], inside.astype(int), [0]])))
    last = None
    for start, stop in steps.reshape(-1, 2):
        if stop - start > 1:
            axes.curve(x[start:stop], y[start:stop], css)
        last = axes.X(float(x[stop - 1])), axes.Y(float(y[stop - 1]))
    return last


def _shown(whirl: int) -> Curve:
    name, how, colour = WHIRLS[whirl]
    return Curve(name=name, x=np.empty(0), y=np.empty(0), style=how, colour=colour)


def _names(axes: Axes, ends: Sequence[tuple[float, float, str]]) -> None:
    """Add names to the right of the plot, without overlap, each with a line to its branch."""
    order = sorted(ends, key=lambda end: end[1])
    right = axes.box[2]
    heights = spread([y for _, y, _ in order], [APART] * len(order), (TOP, BOTTOM))
    for (x, y, name), at in zip(order, heights, strict=True):
        if x >= right - 0.5:
            axes.body.append(svg.line(right + 1, y, right + LEADER, at, "leader"))
        else:  # a branch that leaves the plot, or ends before it does
            axes.body.append(svg.polyline([(x, y), (right + LEADER, at)], "leader"))
        axes.body.append(svg.text(right + LEADER + 3, at + 4, name, "tick"))


def _critical(axes: Axes, c: Campbell) -> None:
    """Add dots at intersections of excitation lines and branches, labelled in free space."""
    seen = [
        (axes.X(x), axes.Y(y), name) for x, y, name in c.critical
        if axes.x[0] <= x <= axes.x[1] and axes.y[0] <= y <= axes.y[1]
    ]  # fmt: skip
    taken: list[Box] = [(x - 4, y - 4, x + 4, y + 4) for x, y, _ in seen]
    for x, y, name in seen:
        axes.body.append(svg.circle(x, y, 3.6, "mark"))
        place, box = beside(x, y, LETTER * len(name), axes.box, taken)
        if name:
            left, bottom, right, top = box
            taken.append((left - APART, bottom - APART, right + APART, top + APART))
            axes.body.append(svg.text(*place[:2], name, "named", place[2]))


def _key(axes: Axes, c: Campbell) -> int:
    """Add a key below the plot for the marks that occur; returns its number of lines."""
    named: list[Curve | Band] = [_shown(w) for w in WHIRLS if w in c.whirl]
    none = np.empty(0)
    if c.range is not None:
        named.append(Band(name="speeds of operation", x=none, lower=none, upper=none, colour=-1))
    if c.peers is not None and c.peers_name:
        named.append(Curve(name=c.peers_name, x=none, y=none, style="cross"))
    return key(axes, named, KEY)


def _cross(x: float, y: float) -> Markup:
    return svg.cross(x, y, 3.0, "cross")

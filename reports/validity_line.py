"""Plot of a formula's signed error over one input, with uncertainty band and limits.

Below the curve there is a strip for each limit; it is filled where the whole band is within the
limit.
"""

import math
from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray

from reports import svg
from reports.axes import Axes
from reports.error_cells import Cells
from reports.measured import Measured, all_within, inside, undecided
from verify.core.figures import Array

EVEN = 0.4  # largest error up to which the axis is even
BEND = 0.05  # where an axis changes from linear to logarithmic
ROUND = (0.02, 0.05, 0.1, *(m * 10.0**k for k in range(-1, 9) for m in (2, 5, 10)))
STRIP, GAP = 7.0, 3.0  # of a limit
FEW = 60  # points; with more points no dots are drawn
APART = 13.0  # lines of text


def validity_line(m: Measured, width: float, height: float) -> Markup:
    """SVG of the curve with its band, the limits, and the strips below."""
    known = np.isfinite(m.error) & np.isfinite(m.U)
    at = np.log10(m.x) if m.log[0] else np.asarray(m.x, dtype=float)
    low, high = _reach(m, known)
    even = max(-low, high) <= EVEN
    ends = (low, high) if even else (float(_bent(low)), float(_bent(high)))
    margin = 0.04 * (ends[1] - ends[0])
    below = 38.0 + (STRIP + GAP) * len(m.limits)
    span = (float(at.min()), float(at.max()))
    axes = Axes(
        (46.0, 20.0, width - 10.0, height - below), span, (ends[0] - margin, ends[1] + margin)
    )
    _limits(axes, m, even=even)
    for some in _pieces(known):
        e, U = m.error[some], m.U[some]
        lower, upper = (e + sign * U if even else _bent(e + sign * U) for sign in (-1, 1))
        axes.ribbon(at[some], lower, upper, "bar")
        axes.curve(at[some], e if even else _bent(e), "error")
    if known.sum() <= FEW:
        axes.dots(at[known], m.error[known] if even else _bent(m.error[known]), "dot", 2.2)
    for x in at[~known]:
        axes.body.append(svg.cross(axes.X(x), axes.box[3] - 6, 3.0, "none"))
    if within := all_within(m.error, m.U):
        middle = (axes.box[0] + axes.box[2]) / 2
        axes.body.append(svg.text(middle, axes.Y(0.0) - 12, within, "label", "middle"))
    _base(axes, m)
    _marked(axes, m)
    _strips(axes, m, at, known)
    axes.titles("", "error [%]")
    axes.body.append(svg.text(axes.box[2], height - 3, m.x_label, "label", "end"))
    return svg.drawing(width, height, axes.body, m.title, "chart validity")


def _bent(error: Array | float) -> Array:
    return np.asarray(np.arcsinh(np.asarray(error) / BEND))


def _reach(m: Measured, known: NDArray[np.bool_]) -> tuple[float, float]:
    """Range of the axis: all error bars, and at least the first limit."""
    least = 1.3 * m.limits[0]
    if not known.any():
        return -least, least
    e, U = m.error[known], m.U[known]
    return min(-least, float((e - U).min())), max(least, float((e + U).max()))


def _limits(axes: Axes, m: Measured, *, even: bool) -> None:
    """Add the zones within the limits, their lines, and the numbers of the axis."""
    low, high = axes.y
    left, _, right, _ = axes.box
    for limit in m.limits:
        ends = [v if even else float(_bent(v)) for v in (-limit, limit)]
        top, bottom = (axes.Y(min(max(v, low), high)) for v in (ends[1], ends[0]))
        axes.body.append(svg.rectangle(left, top, right - left, bottom - top, "within"))
        axes.body += [
            svg.line(left, axes.Y(v), right, axes.Y(v), "limit") for v in ends if low <= v <= high
        ]
    wanted = [0.0, *(s * v for v in (*m.limits, *ROUND) for s in (1, -1))]
    taken: list[float] = []
    for value in wanted:  # limits first: round numbers only where there is room
        v = value if even else float(_bent(value))
        y = axes.Y(v)
        if low <= v <= high and all(abs(y - other) >= APART for other in taken):
            taken.append(y)
            words = svg.plain(float(f"{100 * value:.4g}"))
            axes.body.append(svg.text(left - 6, y + 4, words, "tick", "end"))
    axes.body.append(svg.line(left, axes.Y(0.0), right, axes.Y(0.0), "axis"))


def _pieces(known: NDArray[np.bool_]) -> Iterator[NDArray[np.int64]]:
    """Index runs of at least two consecutive solved points."""
    where = np.flatnonzero(known)
    for some in np.split(where, np.flatnonzero(np.diff(where) > 1) + 1):
        if len(some) > 1:
            yield some


def _marked(axes: Axes, m: Measured) -> None:
    """Add a ring on the axis at the value in the file, which need not be a solved point."""
    if m.nominal is None or not m.x.min() <= m.nominal[0] <= m.x.max():
        return
    x = math.log10(m.nominal[0]) if m.log[0] else m.nominal[0]
    axes.body.append(svg.circle(axes.X(x), axes.box[3], 4.2, "at"))


def _base(axes: Axes, m: Measured) -> None:
    """Add the numbers of the horizontal axis, below the strips."""
    left, _, right, bottom = axes.box
    y = bottom + (STRIP + GAP) * len(m.limits) + 16
    axes.body.append(svg.line(left, bottom, right, bottom, "axis"))
    values = svg.ticks(float(m.x.min()), float(m.x.max()), max(3, round((right - left) / 55)))
    if m.log[0]:
        values = svg.log_ticks(float(m.x.min()), float(m.x.max()))
    last = -math.inf
    for v in values:
        x = axes.X(math.log10(v) if m.log[0] else v)
        if x - last >= 30:
            last = x
            axes.body.append(svg.line(x, bottom, x, bottom + 3, "axis"))
            axes.body.append(svg.text(x, y, svg.plain(float(f"{v:.6g}")), "tick", "middle"))


def _strips(axes: Axes, m: Measured, at: Array, known: NDArray[np.bool_]) -> None:
    """Add a strip for each limit: filled if the band is within it, hatched if it crosses it."""
    left, _, right, bottom = axes.box
    order = np.argsort(at)
    ends = np.concatenate(
        [[at.min()], (at[order][1:] + at[order][:-1]) / 2, [at.max()]]
    )  # halfway to the neighbours
    for k, limit in enumerate(m.limits):
        top = bottom + 4 + (STRIP + GAP) * k
        axes.body.append(svg.rectangle(left, top, right - left, STRIP, "track"))
        axes.body.append(svg.text(left - 6, top + STRIP, f"{100 * limit:.4g} %", "strip", "end"))
        held = inside(m.error, m.U, limit)[order]
        open_ = undecided(m.error, m.U, (limit,))[order]
        for i, (a, b) in enumerate(pairwise(ends)):
            box = axes.X(float(a)), top, axes.X(float(b)), top + STRIP
            one = Cells(box, 1, 1)
            style = "held" if held[i] else "" if known[order][i] else "unsolved"
            if style:
                axes.body.append(one.filled(np.ones((1, 1), dtype=bool), style))
            if open_[i]:
                axes.body.append(one.hatched(np.ones((1, 1), dtype=bool)))

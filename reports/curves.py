"""Plot of several curves on common axes, with a key below.

Each colour has a pattern of strokes and marks, so that curves can be distinguished in black and
white print and without colour vision.
"""

import math
from collections.abc import Sequence

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.axes import HEIGHT, WIDTH, Axes
from verify.core.figures import Array, Band, Curve, Curves

LINE = 18.0  # height of a line of the key
SWATCH = 30.0
LETTER = 6.2  # about the width of a letter of the key
KEY = 316.0  # where the key starts
FEW = 1.5  # decades; shorter axes get marks between the powers of ten


def curves(c: Curves) -> Markup:
    """SVG of lines, dashes and marks in the colours of their groups, clipped to the axes.

    Points that are not finite are omitted, and so are curves without finite points.
    """
    bands = [(b, _kept(c, b.x, b.lower, b.upper)) for b in c.bands]
    held = [(k, _kept(c, k.x, k.y)) for k in c.curves]
    bands, held = [b for b in bands if b[1][0].size], [k for k in held if k[1][0].size]
    points = [p for _, p in bands] + [p for _, p in held]
    axes = _axes(c, [p[0] for p in points], [v for p in points for v in p[1:]])
    if c.x_names:
        names = dict(c.x_names)
        axes.base(list(names), names.__getitem__)
    else:
        axes.base(svg.log_ticks(*axes.x) if c.x_log else svg.ticks(*axes.x, 6), svg.plain)
    axes.titles(c.x_label, c.y_label)
    for band, (u, low, high) in bands:
        axes.ribbon(u, np.clip(low, *axes.y), np.clip(high, *axes.y), f"area s{band.colour}")
    for curve, (u, v) in held:
        seen = (axes.y[0] <= v) & (v <= axes.y[1])
        if curve.style == "dots":
            axes.dots(u[seen], v[seen], f"dot s{curve.colour}", 2.4, curve.colour)
        else:
            axes.curve(u[seen], v[seen], style(curve))
    rows = key(axes, [*(k for k, _ in held), *(b for b, _ in bands)])
    return svg.drawing(WIDTH, HEIGHT + LINE * rows + 4, axes.body, c.title, "chart")


def _kept(c: Curves, *lines: Array) -> list[Array]:
    """Points of x and of one or two y arrays that can be drawn."""
    arrays = [np.asarray(line, dtype=float) for line in lines]
    finite = np.all([np.isfinite(a) for a in arrays], axis=0)
    if c.y_log:
        finite &= np.all([a > 0 for a in arrays[1:]], axis=0)
    if c.x_log:
        finite &= arrays[0] > 0
    return [a[finite] for a in arrays]


def _axes(c: Curves, x: list[Array], y: list[Array]) -> Axes:
    """Axes that contain all points, with a grid of y."""
    low, high = min(v.min() for v in y), max(v.max() for v in y)
    low = min(low, math.inf if c.y_log else 0.0) if c.y_bottom is None else c.y_bottom
    high = high if c.y_top is None else min(high, c.y_top)
    left, right = float(min(v.min() for v in x)), float(max(v.max() for v in x))
    over = high * (high / low) ** 0.06 if c.y_log else high + 0.06 * ((high - low) or 1.0)
    if c.y_log and not over > low:
        low, over = low / 2, low * 2
    axes = Axes(
        (52, 28, 390, 262), (left, right if right > left else left + 1.0),
        (float(low), float(over)), y_log=c.y_log, x_log=c.x_log,
    )  # fmt: skip
    if c.y_log:
        _decades(axes)
    else:
        axes.grid(svg.ticks(*axes.y), svg.plain)
    return axes


def _decades(axes: Axes) -> None:
    """Add grid lines at powers of ten; on a short axis, also at 2 and 5 times each power."""
    low, high = (math.log10(v) for v in axes.y)
    whole = range(math.floor(low), math.ceil(high) + 1)
    if high - low < FEW:
        values = [d * 10.0**e for e in whole for d in (1, 2, 5)]
        axes.grid([v for v in values if axes.y[0] <= v <= axes.y[1]], svg.plain)
        return
    every = -(-len(whole) // 8)
    seen = [10.0**e for e in whole if low - 1e-9 <= e <= high + 1e-9 and e % every == 0]
    axes.grid(seen, lambda v: svg.decade(round(math.log10(v))))


def key(axes: Axes, named: Sequence[Curve | Band], top: float = KEY) -> int:
    """Draw names with their swatches, as many per line as fit; returns the number of lines.

    A curve without a name belongs to the curve before it.
    """
    left, row = 12.0, 0
    for curve in named:
        if not curve.name:
            continue
        wide = SWATCH + 8 + LETTER * len(curve.name) + 14
        if left > 12.0 and left + wide > WIDTH:
            left, row = 12.0, row + 1
        y = top + LINE * row
        axes.body.append(_swatch(curve, left, y - 4))
        axes.body.append(svg.text(left + SWATCH + 6, y, curve.name, "tick"))
        left += wide
    return row + 1


def _swatch(curve: Curve | Band, left: float, y: float) -> Markup:
    """Sample of a curve or a band, drawn before its name in the key."""
    if isinstance(curve, Band):
        css = f"area s{curve.colour}" if curve.colour >= 0 else "band"
        return svg.rectangle(left, y - 5, SWATCH, 10, css)
    if curve.style == "dots":
        return svg.marker(left + SWATCH / 2, y, 2.6, f"dot s{curve.colour}", curve.colour)
    if curve.style == "cross":
        return svg.cross(left + SWATCH / 2, y, 3.0, "cross")
    return svg.line(left, y, left + SWATCH, y, style(curve))


def style(curve: Curve) -> str:
    """CSS classes of a curve: its colour and its line pattern."""
    if curve.style == "member":
        return "member"
    return f"fit s{curve.colour} {'dashes' if curve.style == 'dashes' else 'strokes'}"

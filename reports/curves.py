"""Plot of several curves on the same axes, each named in a key below.

Colours stand for the same with a pattern of their own, of strokes and of marks: a print in black
and white, and an eye that tells no hues, keep curves apart.
"""

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.plots import HEIGHT, WIDTH, Axes
from verify.shown import Curve, Curves

LINE = 18.0  # height of a line of the key
SWATCH = 30.0
LETTER = 6.2  # about the width of a letter of the key
KEY = 316.0  # where the key starts


def curves(c: Curves) -> Markup:
    """Lines, dashes and marks in the colours of their group; what runs off is cut.

    Points that are not finite are left out, and curves that have no others.
    """
    held = [(k, np.isfinite(k.x) & np.isfinite(k.y)) for k in c.curves]
    held = [(k, finite) for k, finite in held if finite.any()]
    x = [np.asarray(k.x, dtype=float)[finite] for k, finite in held]
    y = [np.asarray(k.y, dtype=float)[finite] for k, finite in held]
    low, high = min(min(v.min() for v in y), 0.0), max(v.max() for v in y)
    low = low if c.y_bottom is None else c.y_bottom
    high = high if c.y_top is None else min(high, c.y_top)
    left, right = float(min(v.min() for v in x)), float(max(v.max() for v in x))
    axes = Axes(
        (52, 28, 390, 262),
        (left, right if right > left else left + 1.0),
        (float(low), float(high + 0.06 * ((high - low) or 1.0))),
    )
    axes.grid(svg.ticks(*axes.y), svg.plain)
    if c.x_names:
        names = dict(c.x_names)
        axes.base(list(names), names.__getitem__)
    else:
        axes.base(svg.ticks(*axes.x, 6), svg.plain)
    axes.titles(c.x_label, c.y_label)
    for (curve, _), u, v in zip(held, x, y, strict=True):
        seen = (axes.y[0] <= v) & (v <= axes.y[1])
        if curve.style == "dots":
            axes.dots(u[seen], v[seen], f"dot s{curve.colour}", 2.4, curve.colour)
        else:
            axes.curve(u[seen], v[seen], style(curve))
    rows = key(axes, tuple(curve for curve, _ in held))
    return svg.drawing(WIDTH, HEIGHT + LINE * rows + 4, axes.body, c.title, "chart")


def key(axes: Axes, named: tuple[Curve, ...]) -> int:
    """Draw names with their swatches, as many a line as fit; returns the number of lines.

    A curve without a name belongs to the one before it.
    """
    left, row = 12.0, 0
    for curve in named:
        if not curve.name:
            continue
        wide = SWATCH + 8 + LETTER * len(curve.name) + 14
        if left > 12.0 and left + wide > WIDTH:
            left, row = 12.0, row + 1
        y = KEY + LINE * row
        if curve.style == "dots":
            mark = left + SWATCH / 2, y - 4.0
            axes.body.append(svg.marker(*mark, 2.6, f"dot s{curve.colour}", curve.colour))
        else:
            axes.body.append(svg.line(left, y - 4, left + SWATCH, y - 4, style(curve)))
        axes.body.append(svg.text(left + SWATCH + 6, y, curve.name, "tick"))
        left += wide
    return row + 1


def style(curve: Curve) -> str:
    """CSS classes of a curve: its colour, and the pattern that goes with it."""
    return f"fit s{curve.colour} {'dashes' if curve.style == 'dashes' else 'strokes'}"

"""Parallel coordinates: sets of parameters as lines across vertical axes."""

import math
import re

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.axes import WIDTH, Axes
from reports.curves import LINE, key, style
from verify.core.figures import Array, Curve, Parallel, ParallelAxis

LEFT, RIGHT, TALL = 34.0, 366.0, 190.0
LETTER, APART, ROW = 6.6, 6.0, 14.0  # width of a letter, between words, height of a row of them
TICK = 3.0
POWERS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def parallel(p: Parallel) -> Markup:
    """SVG with a thin line for each set of parameters; highlighted sets have coloured lines.

    Names of axes are in several rows if they would overlap.
    """
    count = len(p.axes)
    x = np.linspace(LEFT, RIGHT, count) if count > 1 else np.array([WIDTH / 2])
    names, tops = _rows([a.name for a in p.axes], x), _rows([_ends(a)[1] for a in p.axes], x)
    lows = _rows([_ends(a)[0] for a in p.axes], x)
    units = _rows([_unit(a) for a in p.axes], x)
    top = ROW * (2 + max(names) + max(tops)) + 10
    bottom = top + TALL
    shares = np.column_stack([_shares(a, p.members[:, i]) for i, a in enumerate(p.axes)])
    chosen = {row: (name, colour) for row, name, colour in p.highlighted}
    y = bottom - TALL * np.clip(shares, 0, 1)
    body = [
        svg.polyline(zip(x, line, strict=True), "member")
        for i, line in enumerate(y) if i not in chosen
    ]  # fmt: skip
    shown = [Curve(name=name, x=x, y=y[i], colour=colour) for i, (name, colour) in chosen.items()]
    body += [svg.polyline(zip(c.x, c.y, strict=True), f"{style(c)} chosen") for c in shown]
    for i, axis in enumerate(p.axes):
        at = float(x[i])
        body += [svg.line(at, bottom, at, top, "axis"), *_ticks(axis, at, top)]
        for words, line, css in (
            (axis.name, ROW * (1 + names[i]), "label"),
            (_ends(axis)[1], top - 8 - ROW * tops[i], "tick"),
            (_ends(axis)[0], bottom + 4 + ROW * (1 + lows[i]), "tick"),
            (_unit(axis), bottom + 4 + ROW * (2 + max(lows) + units[i]),
             "tick"),
        ):  # fmt: skip
            body.append(svg.text(at, line, words, f"{css} halo", "middle"))
    end = bottom + 4 + ROW * (3 + max(lows) + max(units)) + 8
    rest = [Curve(name=p.members_name, x=x, y=x, style="member")] if p.members_name else []
    axes = Axes((LEFT, top, RIGHT, bottom), (0, 1), (0, 1), body=body)
    rows = key(axes, [*shown, *rest], end) if shown or rest else 0
    return svg.drawing(WIDTH, end + LINE * rows - 8, axes.body, p.title, "chart parallel")


def _shares(axis: ParallelAxis, values: Array) -> Array:
    """Position of values between the low end (0) and the high end (1) of the axis."""
    low, high, v = axis.low, axis.high, np.asarray(values, dtype=float)
    if axis.log:
        low, high, v = math.log(low), math.log(high), np.log(np.maximum(v, 1e-300))
    return np.asarray((v - low) / ((high - low) or 1.0))


def _ticks(axis: ParallelAxis, x: float, top: float) -> list[Markup]:
    """SVG of marks at round values, or at powers of ten if the axis is logarithmic."""
    if axis.log:
        low, high = math.log10(axis.low), math.log10(axis.high)
        values = [10.0**e for e in range(math.ceil(low - 1e-9), math.floor(high + 1e-9) + 1)]
    else:
        values = svg.ticks(axis.low, axis.high, 4)
    heights = top + TALL * (1 - _shares(axis, np.array(values)))
    return [svg.line(x - TICK, y, x + TICK, y, "axis") for y in heights]


def _ends(axis: ParallelAxis) -> tuple[str, str]:
    """Texts of both ends of an axis."""
    return _short(axis.low), _short(axis.high)


def _short(value: float) -> str:
    """Text of a number; a large or small number has a power of ten: 2·10⁹."""
    if value == 0 or 1e-3 <= abs(value) < 1e5:
        return svg.plain(float(f"{value:.4g}"))
    digits, _, exponent = f"{value:.2e}".partition("e")
    power = f"10{str(int(exponent)).translate(POWERS)}"
    mantissa = svg.plain(float(digits))
    return power if mantissa == "1" else f"{mantissa}·{power}"


def _unit(axis: ParallelAxis) -> str:
    """Text of the unit as printed, such as kg m²; empty for plain numbers."""
    raised = re.sub(r"\^(-?\d)(?!\.)", lambda power: power[1].translate(POWERS), axis.unit)
    return raised if raised != "1" else ""


def _rows(words: list[str], x: Array) -> list[int]:
    """Row of each word, so that words centred at x do not overlap."""
    ends: list[float] = []
    found = []
    for word, at in zip(words, x, strict=True):
        half = LETTER * len(word.replace("_", "")) / 2
        row = next((i for i, end in enumerate(ends) if at - half > end), len(ends))
        ends[row : row + 1] = [at + half + APART]
        found.append(row)
    return found

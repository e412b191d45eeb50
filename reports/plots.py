"""Plots of profiles along a line, and of single values."""

import math
import re

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.axes import HEIGHT, WIDTH, Axes
from verify.core.figures import Dots, Profile


def profile(p: Profile) -> Markup:
    """SVG of formula and reference, and below of their difference with the uncertainty band."""
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
    label = f"{p.title}: reference and formula; below, {_rest(p)}"
    return svg.drawing(WIDTH, HEIGHT, top.body + below.body, label, "chart")


def _rest(p: Profile) -> str:
    """Description of the lower part of a profile."""
    difference = f"formula {svg.MINUS} reference"
    if p.scale == 1 and not p.scale_name:
        return difference
    unit = re.search(r"\[([^\]]+)\]$", p.y_label)
    number = svg.plain(float(f"{p.scale:.4g}"))
    return f"({difference})/{p.scale_name or (f'({number} {unit[1]})' if unit else number)}"


def dots(d: Dots) -> Markup:
    """SVG of values of one quantity below each other, with half-widths if they have any."""
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

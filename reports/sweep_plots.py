"""Figures of a sample: scatter of a quantity, and the inputs that cause it."""

from dataclasses import dataclass

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.axes import WIDTH, Axes
from verify.core.figures import Array

LETTER = 6.4
ROW, THICK = 36.0, 9.0
MOST_BINS = 40


@dataclass(frozen=True, kw_only=True)
class Histogram:
    """Histogram of `values` (n,), in the unit of the label.

    `quantiles` are pairs of value and name. `limits` of the magnitude of an error are drawn
    with both signs.
    """

    title: str
    label: str
    values: Array
    quantiles: tuple[tuple[float, str], ...] = ()
    limits: tuple[float, ...] = ()
    note: str = ""


@dataclass(frozen=True, kw_only=True)
class Causes:
    """Bar chart of sensitivity indices: for each input its name, first-order and total index.

    Each index is a value with the ends of its interval.
    """

    title: str
    items: tuple[tuple[str, tuple[float, float, float], tuple[float, float, float]], ...]
    note: str = ""


def histogram(h: Histogram) -> Markup:
    """SVG of bars of equal width, with lines at the quantiles."""
    values = h.values[np.isfinite(h.values)]
    low, high = float(values.min()), float(values.max())
    span = reach(values)
    bins = int(np.clip(np.sqrt(len(values)), 5, MOST_BINS))
    within = (low, high) if high > low else span
    counts, ends = np.histogram(values, bins=bins, range=within)
    most = int(counts.max())
    axes = Axes((46, 42, 390, 190), span, (0.0, 1.05 * most))
    axes.grid([v for v in svg.ticks(0, most, 4) if v == round(v)], svg.plain)
    for count, a, b in zip(counts, ends[:-1], ends[1:], strict=True):
        top, left = axes.Y(float(count)), axes.X(float(a))
        axes.body.append(
            svg.rectangle(left + 0.3, top, axes.X(float(b)) - left - 0.6, axes.box[3] - top, "")
        )
    for limit in h.limits:
        for value in (-limit, limit):
            if axes.x[0] < value < axes.x[1]:
                x = axes.X(value)
                axes.body.append(svg.line(x, axes.box[1], x, axes.box[3], "limit"))
    _quantiles(axes, h)
    axes.base(svg.ticks(*axes.x, 5), svg.plain)
    axes.titles(h.label, "")
    axes.body.append(svg.text(6, 12, "points", "label"))  # above the names of the quantiles
    return svg.drawing(WIDTH, 226.0, axes.body, h.title, "chart bars validity")


def reach(values: Array) -> tuple[float, float]:
    """Range of the axis of a histogram: that of all `values`, with a margin."""
    low, high = float(values.min()), float(values.max())
    margin = 0.04 * (high - low) or 0.01 * abs(high) or 1.0
    return low - margin, high + margin


def _quantiles(axes: Axes, h: Histogram) -> None:
    last = -np.inf
    for value, name in sorted(h.quantiles):
        x = axes.X(value)
        axes.body.append(svg.line(x, axes.box[1] - 4, x, axes.box[3], "quantile"))
        if x - last > LETTER * len(name):
            axes.body.append(svg.text(x, axes.box[1] - 8, name, "tick", "middle"))
            last = x


def causes(c: Causes) -> Markup:
    """SVG of two bars with intervals for each input: first-order index and total index."""
    left = 20.0 + LETTER * max(len(name) for name, _, _ in c.items)
    bottom = 30.0 + ROW * len(c.items)
    reach = [v for _, first, total in c.items for v in (*first, *total)]
    span = min(0.0, *reach), max(1.0, *reach)
    axes = Axes((left, 26.0, WIDTH - 10.0, bottom), span, (float(len(c.items)), 0.0))
    for value in svg.ticks(*span, 5):
        x = axes.X(value)
        axes.body.append(svg.line(x, axes.box[1], x, axes.box[3], "grid"))
    for k, (name, first, total) in enumerate(c.items):
        middle = axes.Y(k + 0.5)
        axes.body.append(svg.text(left - 8, middle + 4, name, "tick", "end"))
        for shift, index, css in ((-THICK - 1, first, "first"), (1.0, total, "total")):
            y = middle + shift
            ends = sorted((axes.X(0.0), axes.X(index[0])))
            axes.body.append(svg.rectangle(ends[0], y, ends[1] - ends[0], THICK, css))
            y += THICK / 2
            low, high = axes.X(index[1]), axes.X(index[2])
            axes.body += [svg.line(low, y, high, y, "whisker")] + [
                svg.line(x, y - 2.5, x, y + 2.5, "whisker") for x in (low, high)
            ]
    axes.base(svg.ticks(*span, 5), svg.plain)
    at = 12.0
    for css, words in (
        ("first", "first order (input alone)"),
        ("total", "total (with interactions)"),
    ):
        axes.body.append(svg.rectangle(at, 4, 18, THICK, css))
        axes.body.append(svg.text(at + 24, 12, words, "tick"))
        at += 34 + LETTER * len(words)
    axes.titles("share of the variance", "")
    return svg.drawing(WIDTH, bottom + 36, axes.body, c.title, "chart causes")

"""Convergence plot of the rows of a case over the mesh size."""

import math
from collections.abc import Sequence

import numpy as np
from markupsafe import Markup

from reports import svg
from reports.axes import HEIGHT, WIDTH, Axes
from verify.core.references import is_finite_elements
from verify.core.results import Kind, Row

LABEL = 36.0  # width of a mesh size's label


def convergence(rows: Sequence[Row]) -> Markup:
    """SVG of the distance from the value on the finest mesh, over the mesh size (logarithmic axes).

    For rows with a judged order, the error is drawn. Each theoretical order has one colour, so that
    lines of one colour should be parallel. Rows whose levels have no order (noise, oscillation) are
    omitted.
    """
    series = [(row, s) for row in rows if (s := distances(row)) and has_order(row)]
    if not series:
        return Markup("")
    orders = sorted({row.formal_order or 0.0 for row, _ in series}, reverse=True)
    h = sorted({x for _, s in series for x, _ in s})
    d = [y for _, s in series for _, y in s]
    low, high = math.floor(math.log10(min(d))), math.ceil(math.log10(max(d)) + 1e-9)
    axes = Axes(
        (52, 28, 330, 262), (h[0] * 0.85, h[-1] * 1.18), (10.0**low, 10.0 ** max(high, low + 1)),
        log=True,
    )  # fmt: skip
    every = -(-(high - low) // 7) or 1
    axes.grid([10.0**e for e in range(low, high + 1, every)], lambda v: svg.decade(_exponent(v)))
    axes.base(_apart(h, axes), lambda v: f"{v:.3g}")
    finer = "mesh size" if on_meshes([row for row, _ in series]) else "refinement"
    axes.titles(f"{finer}, relative", "difference, relative")
    for row, s in series:
        colour = f"s{_colour(row.formal_order or 0.0)}"
        start = len(axes.body)
        x, y = np.array(s).T
        axes.curve(x, y, f"fit {colour}")
        axes.dots(x, y, colour)
        group = Markup("").join(axes.body[start:])
        axes.body[start:] = [
            Markup("<g><title>{}</title>{}</g>").format(f"{row.quantity} ({_order(row)})", group)
        ]
    axes.body += _legend(axes, orders, series)
    count = f"{len(series)} quantities converge to their values on the finest level"
    return svg.drawing(WIDTH, HEIGHT, axes.body, count, "chart")


def on_meshes(rows: Sequence[Row]) -> bool:
    """Whether finite elements give any of the rows; other methods refine steps or slices."""
    return any(is_finite_elements(row) for row in rows)


def _apart(h: Sequence[float], axes: Axes) -> list[float]:
    """Mesh sizes, from the coarsest, whose labels do not overlap."""
    kept: list[float] = []
    for value in sorted(h, reverse=True):
        if not kept or axes.X(kept[-1]) - axes.X(value) > LABEL:
            kept.append(value)
    return kept


def _legend(
    axes: Axes, orders: list[float], series: Sequence[tuple[Row, list[tuple[float, float]]]]
) -> list[Markup]:
    """Labels of the colours at the coarse ends of the lines."""
    ends = []
    for i, order in enumerate(orders):
        mine = [s for row, s in series if (row.formal_order or 0.0) == order]
        at = np.median([axes.Y(max(s)[1]) for s in mine])
        ends.append((float(at), i, f"order {order:g}" if order else "no theory", len(mine)))
    found, last = [], 12.0
    for at, i, name, count in sorted(ends):
        last = max(at, last + 30)
        found += [
            svg.text(340, last, name, f"direct s{_colour(orders[i])}"),
            svg.text(340, last + 13, f"{count} row{'s' * (count > 1)}", "tick"),
        ]
    return found


def _colour(order: float) -> int:
    """Colour of an order, the same in every plot."""
    return {4.0: 0, 3.0: 1, 2.0: 2, 1.0: 3}.get(order, 4)


def has_order(row: Row) -> bool:
    """Whether the levels of the row have an order of convergence."""
    return row.order != "round-off" and (row.grid is None or row.grid.order is not None)


def distances(row: Row) -> list[tuple[float, float]]:
    """Pairs of mesh size and relative distance from the value on the finest mesh.

    For a row with a judged order, the distance is replaced by the stored error.
    """
    if len(row.levels) < 3:
        return []
    if row.kind is Kind.ASYMPTOTIC or (row.kind is Kind.TREND and row.fem != row.order):
        return []  # levels of another parameter than the mesh
    if row.kind is Kind.TREND:
        return [(h, abs(e)) for h, e in row.levels if e]
    finest = row.levels[-1][1]
    scale = row.scale or abs(finest) or 1.0
    return [(h, abs(v - finest) / scale) for h, v in row.levels[:-1] if v != finest]


def _exponent(value: float) -> int:
    return round(math.log10(value))


def _order(row: Row) -> str:
    return f"order {row.order:.2f}" if isinstance(row.order, float) else "no order"

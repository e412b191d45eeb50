"""Check whether a figure has anything to draw, and the text drawn otherwise."""

from collections.abc import Iterable

import numpy as np
from markupsafe import Markup
from numpy.typing import ArrayLike

from reports import svg
from reports.axes import WIDTH
from verify.core.figures import (
    Bars,
    Campbell,
    Curves,
    Density,
    Dots,
    Figure,
    Map,
    Parallel,
    Profile,
    Refinement,
    Shapes,
    Whirl,
    Zones,
)

HEIGHT = 90.0


def drawable(figure: Figure) -> bool:
    """Whether a figure has finite points; some points of a curve may be missing."""
    match figure:
        case Curves():
            return _some_points(figure)
        case Profile():
            return _finite((figure.x, figure.y, figure.x_fem, figure.y_fem, figure.y_ref, figure.u))
        case Refinement():
            return _finite((figure.cells, *(errors for _, errors in figure.errors)))
        case Dots():
            return _finite(value for _, value, _, _ in figure.items)
        case Bars():
            return _finite(value for _, value, _ in figure.items)
        case Shapes():
            return _finite(line for panel in figure.panels for line in panel.lines)
        case Zones():
            return _finite((figure.x, figure.y_top))
        case Density():
            return _finite((figure.x, figure.y)) and bool(np.any(np.isfinite(figure.z)))
        case Map():  # without a comparison the cell has a note
            return bool(figure.rows and figure.columns)
        case Whirl():
            lines = [line for mode in figure.modes for line in mode.lines]
            parts = [p for z, x, y in lines for p in (z, x.real, x.imag, y.real, y.imag)]
            some = bool(figure.modes) and all(mode.lines for mode in figure.modes)
            return some and _finite([*parts, *(p for line in figure.outlines for p in line)])
        case Campbell():
            return figure.speeds.size > 1 and bool(np.any(np.isfinite(figure.frequencies)))
        case Parallel():
            return bool(figure.axes) and _finite(
                (figure.members, *((a.low, a.high) for a in figure.axes))
            )


def _some_points(figure: Curves) -> bool:
    """Whether any curve or band has a point (a positive one on a logarithmic axis)."""
    least, first = (0.0 if log else -np.inf for log in (figure.y_log, figure.x_log))
    lines = [(c.x, [c.y]) for c in figure.curves]
    lines += [(b.x, [b.lower, b.upper]) for b in figure.bands]
    return any(
        np.any(
            np.all(
                [np.isfinite(x) & (x > first), *(np.isfinite(v) & (v > least) for v in y)], axis=0
            )
        )
        for x, y in lines
    )


def nothing(title: str) -> Markup:
    """SVG in place of a figure without points."""
    message = "no values to draw with these inputs"
    words = svg.text(WIDTH / 2, HEIGHT / 2 + 4, message, "tick", "middle")
    return svg.drawing(WIDTH, HEIGHT, [words], f"{title}: nothing to draw", "chart")


def _finite(numbers: Iterable[ArrayLike]) -> bool:
    arrays = [np.asarray(n, dtype=float) for n in numbers]
    return bool(arrays) and all(a.size and np.isfinite(a).all() for a in arrays)

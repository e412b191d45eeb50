"""Colours of a formula's signed error by the smallest limit that it meets, for every map.

Orange means that the formula exceeds finite elements; blue means that it is below them. A larger
error has a darker colour. Errors below a quarter of the first limit have no colour, because their
pattern would only show rounding errors.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from markupsafe import Markup
from numpy.typing import NDArray

from reports import svg
from verify.core.figures import Array

DEEPEST = 8  # classes of each sign with a separate colour
UNSOLVED = 99
HIGH = 11.0  # of the scale's colours


def edges(limits: Sequence[float]) -> tuple[float, ...]:
    """Boundaries between the classes of |error|: the limits and values between them."""
    first, last = limits[0], limits[-1]
    found = [first / 4, first / 2, first]
    for low, high in pairwise(limits):
        found += [(low + high) / 2, high]
    return (*found, 2 * last)


def classes(error: Array, limits: Sequence[float]) -> NDArray[np.int64]:
    """Signed class of each error; UNSOLVED if there is no error."""
    size = np.minimum(np.searchsorted(edges(limits), np.abs(error), side="left"), DEEPEST)
    signed = np.where(error < 0, -size, size)
    return np.where(np.isfinite(error), signed, UNSOLVED).astype(np.int64)


def css(number: int) -> str:
    """CSS class of an error class."""
    if number == UNSOLVED:
        return "unsolved"
    return f"{'over' if number > 0 else 'under'}{abs(number)}" if number else "exact"


def scale(left: float, top: float, width: float, limits: Sequence[float]) -> list[Markup]:
    """SVG of all colours side by side, with the limits below."""
    ends = edges(limits)
    step = width / (2 * len(ends) + 1)
    drawn = []
    for number in range(-len(ends), len(ends) + 1):
        x = left + step * (number + len(ends))
        shade = min(abs(number), DEEPEST) * (1 if number > 0 else -1)
        drawn.append(svg.rectangle(x, top, step, HIGH, css(shade)))
    drawn.append(svg.rectangle(left, top, width, HIGH, "border"))
    for limit in limits:
        for sign in (-1, 1):
            x = left + width / 2 + sign * step * (ends.index(limit) + 0.5)
            drawn.append(svg.line(x, top, x, top + HIGH + 3, "axis"))
            words = f"{'+' if sign > 0 else svg.MINUS}{100 * limit:.4g}"
            drawn.append(svg.text(x, top + HIGH + 14, words, "tick", "middle"))
    drawn.append(svg.text(left + width / 2, top + HIGH + 14, "0 %", "tick", "middle"))
    return drawn

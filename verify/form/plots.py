"""Functions for curves of figures, each with name, x, y and colour."""

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from verify.core.figures import Curve, Curves


def curve(name: str, x: ArrayLike, y: ArrayLike, style: str = "line", colour: int = 0) -> Curve:
    """Curve in one style; if x or y is a single number, it applies to all points.

    >>> curve("limit", [0.0, 2.0], 5.0, "dashes").y
    array([5., 5.])
    """
    x_m, y_m = (np.array(a) for a in np.broadcast_arrays(np.atleast_1d(x), np.atleast_1d(y)))
    return Curve(name=name, x=x_m, y=y_m, style=style, colour=colour)


def line(name: str, x: ArrayLike, y: ArrayLike, colour: int = 0) -> Curve:
    """Curve drawn as a solid line."""
    return curve(name, x, y, "line", colour)


def dashes(name: str, x: ArrayLike, y: ArrayLike, colour: int = 0) -> Curve:
    """Curve drawn as a dashed line, for a second theory, a limit or a printed value."""
    return curve(name, x, y, "dashes", colour)


def dots(name: str, x: ArrayLike, y: ArrayLike, colour: int = 0) -> Curve:
    """Curve drawn as single points, for values of the reference."""
    return curve(name, x, y, "dots", colour)


def plot(
    title: str, x_label: str, y_label: str, *parts: Curve | Iterable[Curve], note: str = "",
    **axes: Any,
) -> Curves:  # fmt: skip
    """Figure with curves and groups of curves on the same axes.

    `axes` are further fields of `Curves`.
    """
    curves = tuple(c for part in parts for c in ((part,) if isinstance(part, Curve) else part))
    return Curves(title=title, x_label=x_label, y_label=y_label, curves=curves, note=note, **axes)

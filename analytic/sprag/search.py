"""Normal force at which an increasing quantity first reaches a given value."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array

DOWN = 1e-3  # of `start`: first load of the search
BACK = 1e3
FACTOR = 1.25
PACES = 200
HALVINGS = 60


def first_reach(value: Callable[[Array], Array], goal: Array, *, start: Array) -> Array:
    """Smallest N [N] with value(N) = goal; nan if there is none.

    The search begins at a fraction of `start`, the initial estimate of N. In each step, the load is
    increased by a constant factor, until the goal or the first nan is reached. Bisection on ln N to
    round-off follows. Where `start` is 0, 0 is returned.
    """
    shape = np.broadcast_shapes(np.shape(value(start)), goal.shape)
    start, goal = np.broadcast_to(start, shape), np.broadcast_to(goal, shape)
    sought = start > 0
    low, high = _bracket(value, goal, np.where(sought, DOWN * start, 1.0), sought)
    end = _last(value, low, high)
    reached = value(end) >= goal
    low, high = _halved(lambda N: value(N) >= goal, low, end)
    return np.where(sought, np.where(reached, high, np.nan), 0.0)


def _bracket(
    value: Callable[[Array], Array], goal: Array, low: Array, sought: NDArray[np.bool_]
) -> tuple[Array, Array]:
    """Two consecutive loads between which the value reaches its goal or becomes nan."""
    for _ in range(PACES):
        above = sought & (value(low) >= goal)
        if not above.any():
            break
        low = np.where(above, low / BACK, low)
    high = low * FACTOR
    for _ in range(PACES):
        on = sought & (value(high) < goal)
        if not on.any():
            break
        low, high = np.where(on, high, low), np.where(on, high * FACTOR, high)
    return low, high


def _last(value: Callable[[Array], Array], low: Array, high: Array) -> Array:
    """`high`, or the largest load below `high` at which the value is not nan."""
    ends = np.isnan(value(high))
    if not ends.any():
        return high
    last, _ = _halved(lambda N: np.isnan(value(N)), low, high)
    return np.where(ends, last, high)


def _halved(
    met: Callable[[Array], NDArray[np.bool_]], low: Array, high: Array
) -> tuple[Array, Array]:
    """Bracket of the load above which `met` is true, halved to round-off."""
    for _ in range(HALVINGS):
        middle = np.sqrt(low * high)
        beyond = met(middle)
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    return low, high

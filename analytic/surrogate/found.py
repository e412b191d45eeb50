"""Result of a search for a minimum."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from analytic.contact.checks import Array

Objective = Callable[[Array], Array]  # (n, d) to (n,)


@dataclass(frozen=True, eq=False)
class Found:
    """Smallest value of an objective found by a search, and its position."""

    x: Array  # (d,)
    value: float
    evaluations: int  # points at which the objective was evaluated
    history: Array  # smallest value so far, by generation; the first is the initial population's


def asked(objective: Objective, x: Array) -> Array:
    """Values (n,) of the objective at x (n, d).

    Raises ValueError for a wrong shape, ArithmeticError unless all values are finite.
    """
    values = np.asarray(objective(x), dtype=np.float64)
    if values.shape != (len(x),):
        raise ValueError(
            f"an objective must return one value per point, ({len(x)},) for {len(x)} points, got "
            f"{values.shape}"
        )
    if not np.all(np.isfinite(values)):
        raise ArithmeticError(
            f"the objective must be finite; it is not at {x[~np.isfinite(values)][0]}"
        )
    return values

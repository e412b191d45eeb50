"""Result of a search for the smallest value."""

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
    """Values (n,) of the objective at x (n, d); ArithmeticError unless each is a finite number."""
    values = np.asarray(objective(x), dtype=np.float64)
    if values.shape != (len(x),):
        raise ValueError(f"an objective of {len(x)} points has {len(x)} values, got {values.shape}")
    if not np.all(np.isfinite(values)):
        raise ArithmeticError(f"the objective is not finite at {x[~np.isfinite(values)][0]}")
    return values

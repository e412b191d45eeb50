"""Surrogate of a largest value: each regime kriged for itself, and the largest taken.

If the largest of several quantities passes from one to the other it has a kink, which no smooth
process follows; each quantity alone is smooth. Kriging a power of it helps where the power is the
natural quantity: a Hertzian pressure squared is a force a length.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.distance import cdist

from analytic.contact.checks import Array
from analytic.surrogate.box import Box
from analytic.surrogate.kriging import Kriging, fit


@dataclass(frozen=True, eq=False)
class Largest:
    """The largest of several regimes, each the `power`-th root of its kriging, or 0 below 0."""

    models: tuple[Kriging, ...]
    power: float = 1.0

    def __post_init__(self) -> None:
        if not self.models:
            raise ValueError("the largest of no regimes is not defined: give at least 1")
        if not (np.isfinite(self.power) and self.power > 0):
            raise ValueError(f"power must be positive and finite, got {self.power}")

    def predict(self, x: Array) -> Array:
        """Largest regime (m,) at x (m, d)."""
        return self._largest([model.predict(x) for model in self.models])

    def without(self, x: Array) -> "Largest":
        """Processes without the designs that are in x (m, d)."""
        return Largest(tuple(model.without(x) for model in self.models), self.power)

    def left_out(self, x: Array, values: Sequence[Array]) -> Array:
        """Relative errors (n,) at x (n, d) of the largest regime, each design left out in turn.

        values[k] (n,) are the true values of regime k. A regime that has no such design is asked
        as it is.
        """
        left = []
        for model in self.models:
            predicted = model.predict(x)
            at, of = np.nonzero(cdist(model.box.to_unit(x), model.u) < 1e-9)
            predicted[at] = (model.values - model.left_out())[of]
            left.append(predicted)
        return np.asarray(self._largest(left) / np.max(np.asarray(values), axis=0) - 1)

    def _largest(self, predicted: Sequence[Array]) -> Array:
        return np.asarray(np.maximum(0, np.max(predicted, axis=0)) ** (1 / self.power))


def fit_largest(
    x: Array,
    values: Sequence[Array],
    box: Box,
    *,
    power: float = 2.0,
    present: Sequence[NDArray[np.bool_]] | None = None,
) -> Largest:
    """Each regime's values (n,) at x (n, d), to the `power`, kriged on the designs that have it.

    ValueError for a negative value, or as `fit` has it; values where a regime is not present are
    not looked at.
    """
    x = box.points(x)
    if present is None:
        present = [np.ones(len(x), dtype=bool)] * len(values)
    if len(present) != len(values):
        raise ValueError(f"{len(values)} regimes, but presence is stated for {len(present)}")
    models = []
    if any(np.shape(regime) != (len(x),) for regime in values):
        raise ValueError(f"every regime needs a value for each of the {len(x)} designs")
    for regime, where in zip(values, present, strict=True):
        y = np.asarray(regime, dtype=np.float64)[where]
        if np.any(y < 0):
            raise ValueError(f"values of a regime must not be negative, got {y.min()}")
        models.append(fit(x[where], y**power, box))
    return Largest(tuple(models), power)

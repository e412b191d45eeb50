"""Surrogate of a largest value: each regime is kriged separately, then the largest is taken.

If the largest of several quantities changes from one to another, it has a kink, which no smooth
process represents; each quantity by itself is smooth. Kriging a power helps if the power is the
natural quantity: a Hertzian pressure squared is proportional to force per length.
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
        """Relative errors (n,) of the largest regime at x (n, d), each design left out in turn.

        values[k] (n,) are the true values of regime k. A regime without such a design is evaluated
        as fitted.
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
    """Values (n,) of each regime at x (n, d), to the `power`, kriged on designs with the regime.

    ValueError for a negative value and as in `fit`; values at which a regime is not present are not
    used.
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

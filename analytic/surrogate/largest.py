"""Surrogate of the largest of several quantities: each of them (a regime) is kriged separately.

At a point where another quantity becomes the largest, the largest value has a kink, which a smooth
process cannot represent. Each quantity alone is smooth. A power of a quantity is kriged if this
power is smoother than the quantity; for example, the square of a Hertzian pressure is proportional
to force per length.
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
    """Surrogate of the largest of several regimes.

    Each regime is the `power`-th root of its kriging prediction, and at least 0.
    """

    models: tuple[Kriging, ...]
    power: float = 1.0

    def __post_init__(self) -> None:
        if not self.models:
            raise ValueError("at least one regime must be given")
        if not (np.isfinite(self.power) and self.power > 0):
            raise ValueError(f"power must be positive and finite, got {self.power}")

    def predict(self, x: Array) -> Array:
        """Value (m,) of the largest regime at x (m, d)."""
        return self._largest([model.predict(x) for model in self.models])

    def without(self, x: Array) -> "Largest":
        """Surrogate without the designs that are in x (m, d)."""
        return Largest(tuple(model.without(x) for model in self.models), self.power)

    def left_out(self, x: Array, values: Sequence[Array]) -> Array:
        """Relative errors (n,) of the largest regime at x (n, d) with each design left out in turn.

        values[k] (n,) are the true values of regime k. If a regime was fitted without a design, its
        prediction there is used unchanged.
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
    """Surrogate from values (n,) of each regime at x (n, d); their `power`-th powers are kriged.

    `present` marks the designs at which a regime is present; its values at other designs are not
    used. Raises ValueError for a negative value, and for the same reasons as `fit`.
    """
    x = box.points(x)
    if present is None:
        present = [np.ones(len(x), dtype=bool)] * len(values)
    if len(present) != len(values):
        raise ValueError(
            f"`present` must have one entry per regime, got {len(values)} regimes and "
            f"{len(present)} entries"
        )
    models = []
    if any(np.shape(regime) != (len(x),) for regime in values):
        raise ValueError(f"every regime must have one value for each of the {len(x)} designs")
    for regime, where in zip(values, present, strict=True):
        y = np.asarray(regime, dtype=np.float64)[where]
        if np.any(y < 0):
            raise ValueError(f"values of a regime must not be negative, got {y.min()}")
        models.append(fit(x[where], y**power, box))
    return Largest(tuple(models), power)

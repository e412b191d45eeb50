"""The box of parameters a surrogate is fitted on and searched in."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array


@dataclass(frozen=True)
class Box:
    """Bounds of d parameters, each in its unit.

    >>> box = Box((1.0, 0.4), (5.0, 0.7))
    >>> box.from_unit(np.array([[0.5, 0.0]])).tolist()
    [[3.0, 0.4]]
    """

    low: tuple[float, ...]
    high: tuple[float, ...]

    def __post_init__(self) -> None:
        if not self.low or len(self.low) != len(self.high):
            raise ValueError(
                f"a box needs as many low bounds as high, got {len(self.low)} and {len(self.high)}"
            )
        for low, high in zip(self.low, self.high, strict=True):
            if not (np.isfinite(low) and np.isfinite(high) and low < high):
                raise ValueError(f"bounds must be finite, low below high, got {low} and {high}")

    @property
    def dimension(self) -> int:
        return len(self.low)

    def points(self, x: Array) -> Array:
        """`x` as floats (n, d); ValueError unless finite and of that shape."""
        x = np.asarray(x, dtype=np.float64)
        if x.ndim != 2 or x.shape[1] != self.dimension:
            raise ValueError(f"points must be of shape (n, {self.dimension}), got {x.shape}")
        if not np.all(np.isfinite(x)):
            raise ValueError(f"points must be finite, got {x[~np.isfinite(x).all(axis=1)][0]}")
        return x

    def to_unit(self, x: Array) -> Array:
        """Points (n, d) in the unit cube."""
        low, high = np.array(self.low), np.array(self.high)
        return np.asarray((self.points(x) - low) / (high - low))

    def from_unit(self, u: Array) -> Array:
        """Points (n, d) of the unit cube in the parameters' units; 1 is the high bound exactly."""
        u = self.points(u)
        return np.asarray((1 - u) * np.array(self.low) + u * np.array(self.high))

    def contains(self, x: Array) -> NDArray[np.bool_]:
        """True for the points (n, d) that lie inside or on a bound."""
        x = self.points(x)
        return np.asarray(np.all((x >= self.low) & (x <= self.high), axis=1))

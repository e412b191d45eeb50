"""Box of parameters in which a surrogate is fitted and searched for its minimum."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array


@dataclass(frozen=True)
class Box:
    """Lower and upper bounds of d parameters, each in its unit.

    >>> box = Box((1.0, 0.4), (5.0, 0.7))
    >>> box.from_unit(np.array([[0.5, 0.0]])).tolist()
    [[3.0, 0.4]]
    """

    low: tuple[float, ...]
    high: tuple[float, ...]

    def __post_init__(self) -> None:
        if not self.low or len(self.low) != len(self.high):
            raise ValueError(
                "a box must have as many low bounds as high bounds, at least one, got "
                f"{len(self.low)} and {len(self.high)}"
            )
        for low, high in zip(self.low, self.high, strict=True):
            if not (np.isfinite(low) and np.isfinite(high) and low < high):
                raise ValueError(
                    f"bounds must be finite, and the low bound less than the high one, got {low} "
                    f"and {high}"
                )

    @property
    def dimension(self) -> int:
        return len(self.low)

    def points(self, x: Array) -> Array:
        """`x` as floats (n, d); raises ValueError unless it is finite and has this shape."""
        x = np.asarray(x, dtype=np.float64)
        if x.ndim != 2 or x.shape[1] != self.dimension:
            raise ValueError(f"points must have the shape (n, {self.dimension}), got {x.shape}")
        if not np.all(np.isfinite(x)):
            raise ValueError(f"points must be finite, got {x[~np.isfinite(x).all(axis=1)][0]}")
        return x

    def to_unit(self, x: Array) -> Array:
        """Coordinates (n, d) of the points x (n, d) in the unit cube."""
        low, high = np.array(self.low), np.array(self.high)
        return np.asarray((self.points(x) - low) / (high - low))

    def from_unit(self, u: Array) -> Array:
        """Parameters (n, d) of unit-cube points u (n, d); u = 1 gives the high bound exactly."""
        u = self.points(u)
        return np.asarray((1 - u) * np.array(self.low) + u * np.array(self.high))

    def contains(self, x: Array) -> NDArray[np.bool_]:
        """True for points (n, d) inside the box or on a bound."""
        x = self.points(x)
        return np.asarray(np.all((x >= self.low) & (x <= self.high), axis=1))

"""Force-displacement curve of two straight lines, such as Eq. 10 of Wang et al."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True)
class Lines:
    """Curve F = k1 U + c1 up to the intersection of both lines, and F = k2 U + c2 beyond it.

    >>> lines = Lines(k1=2.0, c1=0.0, k2=3.0, c2=-4.0)
    >>> lines.U, lines.F, lines.force([1.0, 5.0]).tolist()
    (4.0, 8.0, [2.0, 11.0])
    """

    k1: float
    c1: float
    k2: float
    c2: float

    @property
    def U(self) -> float:
        """Displacement [length] at the intersection of both lines."""
        return (self.c1 - self.c2) / (self.k2 - self.k1)

    @property
    def F(self) -> float:
        """Force [force] at the intersection of both lines."""
        return self.k1 * self.U + self.c1

    def force(self, U: ArrayLike) -> NDArray[np.float64]:
        """Forces [force] at the displacements U [length]."""
        U = np.asarray(U, dtype=np.float64)
        return np.where(self.U > U, self.k1 * U + self.c1, self.k2 * U + self.c2)

    def spread(self, u_k1: float, u_c1: float, u_k2: float, u_c2: float) -> tuple[float, float]:
        """Standard uncertainties of U and F at the intersection, from those of the constants.

        >>> Lines(k1=2.0, c1=0.0, k2=3.0, c2=-4.0).spread(0.0, 0.1, 0.0, 0.0)
        (0.1, 0.30000000000000004)
        """
        rise = self.k2 - self.k1
        by_U = (self.U * u_k1, u_c1, self.U * u_k2, u_c2)  # over the difference of the slopes
        by_F = (self.k2 * self.U * u_k1, self.k2 * u_c1, self.k1 * self.U * u_k2, self.k1 * u_c2)
        return math.hypot(*by_U) / rise, math.hypot(*by_F) / rise

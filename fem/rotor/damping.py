"""Damping of the whole rotor, in addition to the damping of its bearings."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigh

from fem.rotor.elements import Array


@dataclass(frozen=True)
class Rayleigh:
    """Rayleigh damping C = alpha M + beta K, with alpha [1/s] and beta [s], both not negative.

    Raises ValueError for negative values.
    """

    alpha: float
    beta: float

    def __post_init__(self) -> None:
        if not (0 <= self.alpha < math.inf and 0 <= self.beta < math.inf):
            raise ValueError(
                "alpha and beta must not be negative, "
                f"got alpha={self.alpha:g} 1/s, beta={self.beta:g} s"
            )

    @classmethod
    def at(cls, first: tuple[float, float], second: tuple[float, float]) -> "Rayleigh":
        """Rayleigh damping from the damping ratios at two frequencies: (omega [rad/s], zeta) each.

        zeta = (alpha/omega + beta omega)/2. Raises ValueError if a coefficient would be negative.
        """
        (w_1, z_1), (w_2, z_2) = first, second
        if not (w_1 > 0 and w_2 > 0 and w_1 != w_2):
            raise ValueError(f"two different frequencies > 0 are required, got {w_1:g}, {w_2:g}")
        alpha, beta = np.linalg.solve([[0.5 / w_1, 0.5 * w_1], [0.5 / w_2, 0.5 * w_2]], [z_1, z_2])
        return cls(float(alpha), float(beta))

    def matrix(self, M: Array, K: Array) -> Array:
        """Damping matrix C (n, n)."""
        return self.alpha * M + self.beta * K


@dataclass(frozen=True)
class Modal:
    """Damping ratios of the modes at zero speed, by ascending frequency.

    The last ratio is used for all higher modes. C = M Phi diag(2 zeta omega) Phi^T M, with Phi^T M
    Phi = 1. Rigid motions are undamped.
    """

    ratios: Sequence[float]

    def __post_init__(self) -> None:
        if not len(self.ratios) or not all(0 <= z < math.inf for z in self.ratios):
            raise ValueError(
                f"damping ratios must be one or more finite values >= 0, got {tuple(self.ratios)}"
            )

    def matrix(self, M: Array, K: Array) -> Array:
        """Damping matrix C (n, n). Raises ValueError if an unknown of the rotor has no mass."""
        try:
            squares, Phi = eigh((K + K.T) / 2, M)
        except np.linalg.LinAlgError:
            raise ValueError(
                "modal damping requires a mass for every unknown: use Rayleigh damping"
            ) from None
        omega = np.sqrt(np.where(squares > 1e-12 * squares[-1], squares, 0.0))
        zeta = np.full(omega.size, float(self.ratios[-1]))
        zeta[: len(self.ratios)] = self.ratios[: omega.size]
        P = M @ Phi
        return np.asarray((P * (2 * zeta * omega)) @ P.T)


Damping = Rayleigh | Modal

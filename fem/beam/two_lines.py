"""Evaluation of a force-displacement curve with a kink where parts of the structure first touch.

A curve (3, k) contains displacements U, forces F and sums N of normal forces; U increases.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

TWICE = 2.0  # force at the end of a curve, over the force at the end of its stroke
TOUCH = 0.004  # relative to the force: tips with this force are certainly in contact
ROUNDING = 1e-9  # relative to a displacement


@dataclass(frozen=True)
class FittedLines:
    """Two straight lines fitted to a curve, one before and one after the first contact.

    `k1`, `k2` [force/length] are the slopes, `c1`, `c2` [force] the constants. `U_A`, `F_A` are
    displacement and force at the first contact. Values that the curve does not reach are NaN.
    """

    k1: float
    c1: float
    k2: float
    c2: float
    U_A: float
    F_A: float

    @property
    def U(self) -> float:
        """Displacement at the intersection of the lines."""
        return (self.c1 - self.c2) / (self.k2 - self.k1)

    def apart(self, other: "FittedLines") -> float:
        """Larger of the relative differences of `k1` and `k2` between this result and `other`."""
        off = [abs(other.k1 / self.k1 - 1), abs(other.k2 / self.k2 - 1)]
        return float(np.nanmax(off)) if np.isfinite(off).any() else np.nan


def fitted(curve: Array, stroke: float) -> FittedLines:
    """Fit both lines by least squares to the points up to the displacement `stroke`.

    Without contact, all values except `k1` and `c1` are NaN.

    >>> U = np.arange(1.0, 9.0)
    >>> pressing = np.maximum(U - 4.0, 0.0)
    >>> found = fitted(np.array([U, 2 * U + pressing, pressing]), 8.0)
    >>> round(found.k1, 9), round(found.k2, 9), round(found.U_A, 9)
    (2.0, 3.0, 4.0)
    """
    U, F, N = curve[:, stroke * (1 + ROUNDING) >= curve[0]]
    U_A, F_A, _ = touching(U, F, N)
    free = U <= U_A if np.isfinite(U_A) else np.ones(len(U), bool)
    if free.sum() < 3:
        return FittedLines(*(np.nan,) * 6)
    k1, c1 = np.polyfit(U[free], F[free], 1)
    k2, c2 = np.polyfit(U[~free], F[~free], 1) if (~free).sum() > 2 else (np.nan, np.nan)
    return FittedLines(float(k1), float(c1), float(k2), float(c2), U_A, F_A)


def touching(U: Array, F: Array, N: Array) -> tuple[float, float, float]:
    """U_A, F_A and the slope after U_A, from the first two states that certainly have contact.

    The contact force N is zero at U_A and increases linearly. The result is NaN without contact.
    """
    i = int(np.argmax(N > TOUCH * F))
    if i == 0 or i + 1 == len(U):
        return (np.nan,) * 3
    return onset(U[i : i + 2], F[i : i + 2], N[i : i + 2])


def onset(U: Array, F: Array, N: Array) -> tuple[float, float, float]:
    """U and F at the onset of the normal force N, from two states, and the slope dF/dU.

    >>> onset(np.array([5.0, 6.0]), np.array([11.0, 14.0]), np.array([1.0, 2.0]))
    (4.0, 8.0, 3.0)
    """
    k = (F[1] - F[0]) / (U[1] - U[0])
    U_A = U[0] - N[0] * (U[1] - U[0]) / (N[1] - N[0])
    return float(U_A), float(F[0] - k * (U[0] - U_A)), float(k)


def on_common(one: Array, other: Array, stroke: float) -> tuple[Array, Array]:
    """Points of `one` and `other` at displacements in both curves (within 1e-6 x `stroke`)."""
    U, V = (np.round(curve[0] / stroke, 6) for curve in (one, other))
    return one[:, np.isin(U, V)], other[:, np.isin(V, U)]


def retraced(U: Array, F: Array) -> float:
    """Largest deviation [1] of unloading forces from loading forces, relative to the latter.

    >>> round(retraced(np.array([1.0, 2.0, 1.0]), np.array([3.0, 6.0, 3.3])), 9)
    0.1
    """
    turn = int(np.argmax(U))
    back = F[turn + 1 :] / np.interp(U[turn + 1 :], U[: turn + 1], F[: turn + 1]) - 1
    return float(abs(back).max())

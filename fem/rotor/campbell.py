"""Natural frequencies over the speed, tracked from speed to speed (Campbell diagram)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from fem.rotor.blocks import Complex
from fem.rotor.branches import branches, check_count, check_speeds, damping_ratios
from fem.rotor.elements import Array
from fem.rotor.model import Rotor


@dataclass(frozen=True)
class Campbell:
    """Branches over `speeds` (m,) [rad/s]: eigenvalues (m, k) [1/s] and sense of whirl (m, k).

    Branches are ordered by their frequency at the first speed. The values of a branch are NaN after
    it ceases to oscillate.
    """

    speeds: Array
    eigenvalues: Complex
    whirl: NDArray[np.int64]

    @property
    def frequencies(self) -> Array:
        """Natural frequencies Im lambda (m, k) [rad/s]."""
        return np.asarray(self.eigenvalues.imag)

    @property
    def damping(self) -> Array:
        """Damping ratios -Re lambda/|lambda| (m, k)."""
        return damping_ratios(self.eigenvalues)

    def crossings(self, ratio: float = 1.0) -> Array:
        """Speeds (j,) [rad/s] at which the frequency of a branch equals `ratio` times the speed.

        The crossings are interpolated by a parabola through the three nearest of `speeds`. The
        error is of third order in the spacing of the speeds.
        """
        found = []
        for branch in self.frequencies.T:
            gap = branch - abs(ratio) * self.speeds
            for i in np.flatnonzero(np.sign(gap[:-1]) * np.sign(gap[1:]) <= 0):
                if gap[i] == gap[i + 1]:
                    continue
                at = slice(max(0, min(i - 1, gap.size - 3)), max(0, min(i - 1, gap.size - 3)) + 3)
                found.append(_root(self.speeds[at], gap[at], self.speeds[i : i + 2]))
        return np.unique(np.round(found, 12))


def campbell(rotor: Rotor, speeds: ArrayLike, count: int = 6, plane: str = "bending") -> Campbell:
    """Branches with the `count` lowest frequencies at the first of the ascending `speeds` [rad/s].

    A branch is tracked by its mode shape, so that it retains its number at a crossing, and by its
    frequency if two branches exchange their shapes. Raises ValueError unless the speeds increase.
    """
    at = check_speeds(speeds)
    if np.any(np.diff(at) <= 0):
        raise ValueError("the speeds of a Campbell diagram must increase")
    found = branches(rotor, at, check_count(count), plane)
    values = np.concatenate([b.values for b in found], axis=1)
    whirl = np.concatenate([b.sense for b in found], axis=1)
    order = np.argsort(values[0].imag, kind="stable")[:count]
    return Campbell(at, values[:, order], whirl[:, order])


def _root(x: Array, y: Array, between: Array) -> float:
    """Root in `between` of the parabola through (x, y), or of the secant if there is none."""
    left, right = between
    roots = np.roots(np.polyfit(x, y, x.size - 1))
    inside = [r.real for r in roots if abs(r.imag) == 0 and left <= r.real <= right]
    if inside:
        return float(inside[0])
    secant = np.interp(between, x, y)
    return float(left - secant[0] * (right - left) / (secant[1] - secant[0]))

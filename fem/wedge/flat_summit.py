"""Flats around a shaft: the clamping angle decreases under load; the torque has a maximum."""

import math
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq, minimize_scalar

from fem.wedge.flat_course import FlatCourse

Array = NDArray[np.float64]


class SummitCourse(FlatCourse):
    """States by increasing normal force, also beyond the maximum of the torque."""

    along: ClassVar[str] = "N"

    @cached_property
    def _square(self) -> CubicSpline:
        """Spline of (T/N)² over the square root of N.

        (T/N)² decreases nearly in proportion to the approaches, with little curvature.
        """
        N = self.at_states["N"]
        return CubicSpline(np.sqrt(N), (self.at_states["T"] / N) ** 2)

    def _T(self, t: Array | float) -> Array:
        """Logarithm of the torque as a function of the logarithm of the normal force."""
        return np.asarray(t + np.log(self._square(np.exp(np.asarray(t) / 2))) / 2)

    def at(self, name: str, value: float, by: str = "") -> float:
        """Value of the quantity `name` in the state in which the quantity `by` is `value`.

        If T occurs twice, the state before its maximum is used.
        """
        if (by or self.by) == "T":
            return self.at(name, math.exp(self._force(value)), "N")
        return math.exp(self._T(math.log(value))) if name == "T" else super().at(name, value, by)

    @property
    def summit(self) -> tuple[float, float]:
        """Normal force [N] and torque [N m] at the maximum of the torque.

        Raises ArithmeticError if the states have no maximum.
        """
        N = self.at_states["N"]
        top = int(np.argmax(self.at_states["T"]))
        if top in (0, N.size - 1):
            raise ArithmeticError(
                "the torque has no maximum among the states: use a wider range of normal forces"
            )
        ends = np.log(N[[top - 1, top + 1]])
        found = minimize_scalar(
            lambda t: -float(self._T(t)),
            bounds=tuple(ends),
            method="bounded",
            options={"xatol": 1e-7},
        )
        return math.exp(found.x), math.exp(-found.fun)

    def log_torque(self, t: Array) -> Array:
        return self._T(t)

    def log_along(self, T: Array) -> Array:
        return np.array([self._force(float(t)) for t in T])

    def _force(self, T: float) -> float:
        """Logarithm of the normal force at the torque T [N m] before the maximum."""
        N, top = np.log(self.at_states["N"]), int(np.argmax(self.at_states["T"]))
        low, high = self.at_states["T"][[0, top]]
        if not low <= T <= high:
            raise ArithmeticError(
                f"T = {T:.4g} is outside the range of the states, whose lowest value is {low:.4g}"
            )
        return float(brentq(lambda t: float(self._T(t)) - math.log(T), N[0], N[top], xtol=1e-13))

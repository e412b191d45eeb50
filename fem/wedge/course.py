"""Series of finite-element states under increasing load, with interpolation."""

from collections.abc import Callable
from itertools import pairwise
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

Array = NDArray[np.float64]

GAUSS = 24  # points of each stretch of an integral over logarithms
GROWING = 1.5  # first to last value, from which on logarithms are splined


class Course:
    """Series of n states, interpolated by cubic splines.

    `at_states` contains the values (n,) of each quantity, by name. Splines are functions of the
    logarithm of a quantity that increases from state to state. For values that increase by more
    than a factor `GROWING`, the logarithm is interpolated: its slope hardly changes, because
    deflections of bodies in contact are nearly powers of the loads. `by` is the name of the default
    abscissa.
    """

    by: ClassVar[str] = "N"
    at_states: dict[str, Array]

    def logarithm(self, name: str, by: str) -> CubicSpline:
        """Logarithm of the quantity `name` as a function of the logarithm of the quantity `by`."""
        return CubicSpline(np.log(self.at_states[by]), np.log(self.at_states[name]))

    def over(self, name: str, by: str) -> Callable[[Array], Array]:
        """Quantity `name` as a function of the logarithm of the quantity `by`."""
        y = self.at_states[name]
        if y[-1] > GROWING * y[0] > 0:
            power = self.logarithm(name, by)
            return lambda t: np.asarray(np.exp(power(t)))
        spline = CubicSpline(np.log(self.at_states[by]), y)
        return lambda t: np.asarray(spline(t))

    def at(self, name: str, value: float, by: str = "") -> float:
        """Value of the quantity `name` in the state in which the quantity `by` is `value`.

        Raises ArithmeticError outside the range of the states.
        """
        by = by or self.by
        low, high = self.at_states[by][[0, -1]]
        if not low <= value <= high:
            raise ArithmeticError(
                f"{by} = {value:.4g} is outside the range of the states, whose lowest value is "
                f"{low:.4g}"
            )
        return float(self.over(name, by)(np.log(value)))

    def integral(self, slope: Callable[[Array], Array], along: str, ends: Array) -> Array:
        """Integrals (m,) of `slope` over the logarithm of the quantity `along`, from zero load.

        The upper limits `ends` (m,) are logarithms. Below the first state, a power law with the
        slope at the first state is used.
        """
        first = float(np.log(self.at_states[along][0]))
        x, w = np.polynomial.legendre.leggauss(GAUSS)
        parts = []
        for low, high in pairwise(np.concatenate([[first], np.atleast_1d(ends)])):
            t = low + (high - low) * (x + 1) / 2
            parts.append(float((high - low) / 2 * w @ slope(t)))
        step = 1e-3
        at = slope(np.array([first, first + step]))
        tail = at[0] / (np.log(at[1] / at[0]) / step)
        return np.asarray(tail + np.cumsum(parts))

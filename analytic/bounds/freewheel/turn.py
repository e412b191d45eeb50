"""Expected error of dalpha/dX: sensitivity of a loaded clamping angle to the flats' position."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from scipy.optimize import brentq

from analytic.bounds.freewheel.intervals import SMALLEST, Interval
from analytic.bounds.freewheel.parts import FreewheelParts
from analytic.bounds.freewheel.star import StarBounds

FAR = 5.0  # the normal force is searched within this factor of the one that is given


@dataclass(frozen=True)
class Moved:
    """Star with displaced flats, whose approaches [length] are functions of N [force]."""

    star: FreewheelParts
    approaches: Callable[[float], tuple[float, float]]

    def angle(self, F_t: float, N: float, f_i: float, f_o: float) -> float:
        """Angle [rad] under F_t = N tan(alpha), with the approaches multiplied by `f_i` and `f_o`.

        `N` [force] is an initial estimate.
        """

        def at(force: float) -> float:
            d_i, d_o = self.approaches(force)
            return float(self.star.alpha(d_i=f_i * d_i, d_o=f_o * d_o))

        force = brentq(lambda x: x * np.tan(at(x)) / F_t - 1, N / FAR, FAR * N, rtol=1e-13)
        return at(force)


def turned(
    ends: Sequence[Moved], bounds: StarBounds, *, off: float, F_t: float, f_i: float, f_o: float
) -> float:
    """Sensitivity dalpha/dX [rad/length] from two stars `ends` with flats displaced by ±`off`.

    `f_i` and `f_o` are factors of the approaches.
    """
    low, high = (end.angle(F_t, bounds.at.N, f_i, f_o) for end in ends)
    return (high - low) / (2 * off)


def of_turn(ends: Sequence[Moved], bounds: StarBounds, *, off: float, F_t: float) -> Interval:
    """Interval of the error of dalpha/dX at F_t, if the approaches lie within their `bounds`.

    The flats of `ends` are displaced by -`off` and `off` [length].
    """
    own = bounds.at.d_i, bounds.at.d_o
    factors = [[end / d for end in within]
               for d, within in zip(own, (bounds.d_i, bounds.d_o), strict=True)]  # fmt: skip

    def at(f_i: float, f_o: float) -> float:
        return turned(ends, bounds, off=off, F_t=F_t, f_i=f_i, f_o=f_o)

    ratio = [at(1.0, 1.0) / at(*pair) - 1 for pair in product(*factors)]
    return min(*ratio, -SMALLEST), max(*ratio, SMALLEST)

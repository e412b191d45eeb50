"""Many sets of parameters with the same given critical speeds.

There are many such sets, because a few speeds do not determine all parameters. Initial values are
Sobol points in the ranges (log-uniform). From each point, least-norm steps lead to a system with
these speeds.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from fem.rotor.elements import Array
from fem.rotor.fitted_speeds import fitted, gradients
from fem.rotor.whirl_systems import WhirlSystems

BATCH = 64  # starts solved together
MOST_BATCHES = 32

Systems = Callable[[Array], WhirlSystems]  # of parameters (m, k)


@dataclass(frozen=True)
class Ranges:
    """Logarithmic ranges of parameters from `low` (k,) to `high` (k,).

    >>> Ranges(np.array([1.0]), np.array([100.0])).parameters(np.array([[0.5]])).round(9).tolist()
    [[10.0]]
    """

    low: Array
    high: Array

    @property
    def width(self) -> Array:
        """Widths (k,) of the ranges of the logarithms."""
        return np.asarray(np.log(self.high / self.low))

    def parameters(self, x: Array) -> Array:
        """Parameters (m, k) at the relative positions x (m, k) in the ranges, from 0 to 1."""
        return np.asarray(self.low * np.exp(x * self.width))

    def places(self, p: Array) -> Array:
        """Relative positions (m, k) of the parameters (m, k) in the ranges."""
        return np.asarray(np.log(p / self.low) / self.width)


@dataclass(frozen=True)
class Ensemble:
    """Sets of parameters `members` (m, k), and masks that mark initial points of the search.

    `met` marks the initial points from which the speeds were reached. `kept` marks the points
    of `met` whose final parameters are within the ranges.
    """

    members: Array
    met: NDArray[np.bool_]
    kept: NDArray[np.bool_]


def ensemble(
    ranges: Ranges, speeds: tuple[float, ...], systems: Systems, members: int, *, seed: int
) -> Ensemble:
    """At least `members` sets of parameters whose lowest critical speeds are `speeds` [rad/s].

    There are fewer sets if 32 batches of initial points do not give as many.
    """
    count = len(ranges.low)
    sobol = qmc.Sobol(count, scramble=True, rng=np.random.default_rng(seed))
    x = np.zeros((0, count))
    met = kept = np.zeros(0, bool)
    while kept.sum() < members and len(x) < BATCH * MOST_BATCHES:
        found, hit = fitted(sobol.random(BATCH), speeds, lambda x: systems(ranges.parameters(x)))
        inside = hit & np.all((found >= 0) & (found <= 1), axis=1)
        x = np.concatenate([x, found])
        met, kept = np.concatenate([met, hit]), np.concatenate([kept, inside])
    return Ensemble(ranges.parameters(x[kept]), met, kept)


def elasticities(ranges: Ranges, p: Array, systems: Systems, count: int) -> Array:
    """Relative change (m, count, k) of critical speeds per relative change of parameters (m, k)."""
    _, shapes = systems(p).critical_speeds(count)
    at_places = gradients(ranges.places(p), shapes, lambda x: systems(ranges.parameters(x)))
    return np.asarray(at_places / ranges.width)

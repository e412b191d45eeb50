"""The sector of a drawn-cup clutch over its load, past the summit of its torque.

Overlaps are given, not torques: from next to nothing to beyond the torque T, and on towards the
overlap at which the rollers go through. The normal force grows all the way, the torque does not.
"""

import math
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq, minimize_scalar

from verify.cases.contact.errors import fem_errors
from verify.cases.freewheel.bodies import OneClutch
from verify.cases.freewheel.fem import Place
from verify.cases.freewheel.sweep import COARSE, FIRST, Start, Sweep, after, rigid_force

Array = NDArray[np.float64]

SHARES = (0.03, 0.09, 0.22, 0.45, 0.75, 1.04)  # of the overlap under T
ONWARD = (
    0.018,
    0.045,
    0.1,
    0.22,
    0.36,
    0.5,
    0.6,
    0.68,
    0.76,
)  # of that at which rollers go through
APART = 1.1  # of the overlap under T, from where on these count
INNER = 0.37  # part of the shaft's contact, about
NEAR, MOST = 2e-2, 12  # how near T the search comes, and in how many steps
GIVEN = 0.25  # of the overlap at which rollers go through, at the angle that is given
STEEP, FLAT = 1.1, 0.25  # d ln(T)/d ln(overlap) of a rigid angle; and no less


def through(q: OneClutch) -> float:
    """The overlap [m] at which the rollers go through."""
    return q.race + 2 * q.r - q.flat


def given_angle(q: OneClutch) -> float:
    """The angle psi [rad] at which contacts overlap by `GIVEN` of what lets rollers through."""
    d = GIVEN * through(q) / 2
    return Place.overlapping(q, d, d).psi


@lru_cache(maxsize=16)
def starts(q: OneClutch) -> tuple[Start, ...]:
    """Starts of all states from light to heavy, from coarse meshes."""
    under = under_torque(q)
    d = sum(under.d)
    onward = [share * through(q) for share in ONWARD]
    wanted = [share * d for share in SHARES] + [D for D in onward if APART * SHARES[-1] * d < D]
    found, now = [], under
    for D in sorted(wanted, reverse=True):
        now = after(now.scaled(D / sum(now.d)).state(q, COARSE))
        found.append(now)
    return tuple(reversed(found))


def under_torque(q: OneClutch) -> Start:
    """A start that bears the torque T, about."""
    D, most = FIRST * rigid_force(q) / q.L * (1 - q.nu**2) / q.E, through(q)
    D = min(D, 0.3 * most)
    d = INNER * D, (1 - INNER) * D
    now = Start(d, (math.sqrt(q.r * d[0] / 3), math.sqrt(q.r * d[1] / 3)), (0.0, 0.0))
    for _ in range(MOST):
        state = now.state(q, COARSE)
        now, D = after(state), sum(now.d)
        miss = math.log(q.T / (state.torque * q.L))
        if abs(miss) < NEAR:
            return now
        steepness = max(STEEP - D / (2 * (most - D)), FLAT)
        share = math.exp(float(np.clip(miss / steepness, -1.5, 0.5)))
        now = now.scaled(min(share, (D + 0.5 * (most - D)) / D))
    raise fem_errors().NotFoundError(
        f"T = {q.T:g} N m is missed by {miss:.1%}: the torque has its summit near"
    )


class CupSweep(Sweep):
    """States over the normal force, which grows where the torque falls again."""

    along = "N"

    def __init__(self, q: OneClutch, cells: int) -> None:
        self._take(q, [start.state(q, cells) for start in starts(q)])

    @cached_property
    def _square(self) -> CubicSpline:
        """(T/N)² over the root of N: it falls nearly as the approaches grow, without a bend."""
        N = self.at_states["N"]
        return CubicSpline(np.sqrt(N), (self.at_states["T"] / N) ** 2)

    def _T(self, t: Array | float) -> Array:
        """Logarithm of the torque over that of the normal force."""
        return np.asarray(t + np.log(self._square(np.exp(np.asarray(t) / 2))) / 2)

    def at(self, name: str, value: float, by: str = "") -> float:
        """As for a star; where T has a value before its summit."""
        if (by or self.by) == "T":
            return self.at(name, math.exp(self._force(value)), "N")
        return math.exp(self._T(math.log(value))) if name == "T" else super().at(name, value, by)

    @property
    def summit(self) -> tuple[float, float]:
        """Normal force [N] and torque [N m] at the summit; ArithmeticError where it is not met."""
        N = self.at_states["N"]
        top = int(np.argmax(self.at_states["T"]))
        if top in (0, N.size - 1):
            raise ArithmeticError("the torque has no summit among the states")
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
        """Logarithm of the normal force under a torque [N m] before the summit."""
        N, top = np.log(self.at_states["N"]), int(np.argmax(self.at_states["T"]))
        low, high = self.at_states["T"][[0, top]]
        if not low <= T <= high:
            raise ArithmeticError(f"T = {T:.4g} lies beyond the states from {low:.4g} on")
        return float(brentq(lambda t: float(self._T(t)) - math.log(T), N[0], N[top], xtol=1e-13))

"""Sprag clutch as a spring between its races: torque as a function of their relative rotation.

Rolling contacts couple the motion of the sprags to the relative rotation theta of the races. If the
mass of the sprags is neglected, the clutch is a spring with T(theta) and N(theta). The moment of
the energizing springs, which press the sprags on the races, is subtracted from T.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from scipy.interpolate import CubicSpline

from analytic.contact.checks import Array
from analytic.sprag.closure import Wedged, wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.course import energy, rolled
from analytic.sprag.start import spring_equilibrium
from analytic.sprag.table import INTERVALS, Table, tabulated

CACHE_SIZE = 64  # clutches in memory
STATES = 401  # from no load to the end of the profile
SHARE = 1.3  # relative to the energy put in, which the end of the table must store
LONGEST = 60  # times that the largest load is raised


@dataclass(frozen=True, kw_only=True)
class Blades:
    """Energizing springs of stiffness `K_r` [N m/rad], unloaded at the sprag rotation `alpha_max`.

    The profile of the sprag ends at the rotation `alpha_max` [rad] from first contact.
    """

    K_r: float
    alpha_max: float


@dataclass(frozen=True, eq=False)
class RaceSpring:
    """States (n,) of a clutch up to the normal force `end`, and rotation theta [rad] of the races.

    `ends` is True if the last state is the end of the profile, and False if the states end before.
    """

    blades: Blades
    clutch: SpragClutch
    states: Wedged
    theta: Array
    ends: bool

    @property
    def n_s(self) -> int:
        """Number of sprags."""
        return self.clutch.n_s

    @property
    def end(self) -> float:
        """Largest normal force [N] of the states."""
        return float(self.states.N[-1])

    def table(self, intervals: int = INTERVALS) -> Table:
        """Table of the clutch over the sprag rotation, up to the normal force `end`."""
        return _table(self, intervals)

    @property
    def pushed(self) -> Array:
        """Torque of the energizing springs [N m] at the rotations of the races, (n,)."""
        now = self.states
        turn = now.OC_e / now.OB * np.gradient(now.alpha_b, self.theta, edge_order=2)
        left = self.blades.alpha_max - now.alpha
        return np.asarray(self.n_s * self.blades.K_r * left * turn)

    def force(self) -> CubicSpline:
        """Spline of the normal force N [N] over the rotation theta [rad]."""
        return CubicSpline(self.theta, self.states.N)

    def resistance(self) -> CubicSpline:
        """Spline over the rotation theta [rad] of the sprags' torque T [N m].

        The torque of the energizing springs is subtracted from T.
        """
        return CubicSpline(self.theta, self.states.T - self.pushed)

    @cached_property
    def pressed(self) -> Wedged:
        """State in which only the energizing springs press the sprags on the races."""
        blades = self.blades
        N, _ = spring_equilibrium(self.clutch, K_r=blades.K_r, alpha_max=blades.alpha_max)
        return N

    @property
    def start(self) -> float:
        """Rotation theta [rad] of the state in which only the energizing springs act."""
        return float(np.interp(self.pressed.N, self.states.N, self.theta))


@lru_cache(maxsize=CACHE_SIZE)
def _table(w: RaceSpring, intervals: int) -> Table:
    return tabulated(w.clutch, N_end=w.end, intervals=intervals)


def reached(
    made: Callable[[float], SpragClutch], N: float, *, T: float, kinetic: float, blades: Blades
) -> RaceSpring:
    """Clutch as a spring, up to the largest load of an engagement or to the end of the profile.

    `made` returns a clutch whose contact laws are valid up to a force [N]. Beginning with `N`, this
    force is doubled until the elastic energy of the clutch exceeds the sum of the work of the
    torque `T` [N m], the `kinetic` energy [J] of the races and the work of the energizing springs.
    Raises ValueError if no force is sufficient.
    """
    for _ in range(LONGEST):
        found = made(N)
        states = wedged(found, N * np.linspace(0, 1, STATES) ** 2)
        turned = states.alpha - states.alpha[0]
        if not (np.isfinite(states.alpha) & (turned <= blades.alpha_max)).all():
            return _to_profile_end(found, N, blades)
        put_in = T * rolled(found, N) + kinetic + _sprung(blades, found.n_s, states.alpha)
        if found.n_s * energy(found, N) > SHARE * put_in:
            return _of(found, N, blades, ends=False)
        N *= 2
    raise ValueError(f"no normal force of the sprags can transmit the torque T = {T:g} N m")


def _sprung(blades: Blades, n_s: int, alpha: Array) -> float:
    """Work [J] of the energizing springs from the first to the last rotation in `alpha`."""
    left = blades.alpha_max - alpha
    return float(n_s * blades.K_r * (left[0] ** 2 - left[-1] ** 2) / 2)


def _to_profile_end(found: SpragClutch, N: float, blades: Blades) -> RaceSpring:
    low, high = 0.0, N
    first = float(wedged(found, 0.0).alpha)
    for _ in range(60):
        middle = (low + high) / 2
        alpha = float(wedged(found, middle).alpha) - first
        low, high = (middle, high) if alpha <= blades.alpha_max else (low, middle)
    return _of(found, low, blades, ends=True)


def _of(found: SpragClutch, N: float, blades: Blades, *, ends: bool) -> RaceSpring:
    loads = N * np.linspace(0, 1, STATES) ** 2
    return RaceSpring(blades, found, wedged(found, loads), rolled(found, loads), ends)

"""Limits of a clutch's torque at constant axial load, and of its axial load at constant torque.

SI units.
"""

import math
from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array
from analytic.freewheel import criterion, state, tilt
from analytic.freewheel.clutch import RollerClutch
from analytic.freewheel.limits import RollerClutchLimits, roller_torque_limits
from analytic.freewheel.state import RollerClutchState

LIFT_OFF = 1 / 6  # e/L from which on a linear line load lifts off one end
NONE = 10.0  # pressure over E for no limit of pressure: no contact reaches it
LEAST, POINTS, ROUNDS = 1e-7, 400, 3  # of the largest torque; torques of a search, its rounds

WORDS = {
    "slip": "the contacts slip",
    "bears": "at lower torques, friction does not transmit the axial load",
    "pressure_inner": "the inner contacts reach p_lim",
    "pressure_outer": "the outer contacts reach p_lim",
    "corner": "the rollers reach the ends of the cam flats",
    "pop_through": "the rollers pop through between flat and shaft",
    "hertz": "the contacts are as wide as the rollers' radius (limit of the formulas)",
    "tilt": "the tilting couple shifts the contact forces by (e/L)_lim",
    "tilt_lift": "the tilting couple lifts the rollers off at one end",
    "pressure": "the pressure at the rollers' ends reaches p_lim",
}
SEVERITY = ("pop_through", "corner", "hertz", "slip", "pressure_inner", "pressure_outer",
            "pressure", "tilt_lift", "tilt")  # fmt: skip


@dataclass(frozen=True)
class Limit:
    """Limit of the torque [N m] or of the axial load [N]: its key in `WORDS` and its value."""

    key: str
    at: float

    @property
    def words(self) -> str:
        """Description of the limit in words."""
        return WORDS[self.key]


@dataclass(frozen=True, kw_only=True, eq=False)
class Duty:
    """Clutch with the friction mu under a torque and an axial load (both for the whole clutch).

    T [N m] is positive in the locking direction; F_ax [N] is not negative. `p_lim` [Pa] is the
    permissible pressure, if there is one. `e_lim` is the largest permissible e/L of tilted rollers
    (see `tilt`); by default, it is the value at which one end lifts off.
    """

    clutch: RollerClutch
    T: float
    F_ax: float
    mu: float
    p_lim: float | None = None
    e_lim: float | None = None

    @cached_property
    def under(self) -> RollerClutchState | None:
        """State under the torque T; None if T <= 0 or if there is no equilibrium."""
        if self.T <= 0:
            return None
        now = state.loaded(self.clutch, self.T)
        return now if np.isfinite(now.N) else None

    def required(self, T: Array | float, alpha: Array | float) -> Array:
        """Required friction mu_req under F_ax and T [N m] at the angle alpha [rad] (Eq. 9)."""
        R = self.clutch.cam.race
        return criterion.required_friction(alpha=alpha, T=T, F_ax=self.F_ax, R=R)

    @cached_property
    def of_torque_alone(self) -> RollerClutchLimits:
        """Limits of the torque that do not depend on the axial load."""
        p_lim = self.p_lim or NONE * float(np.asarray(self.clutch.roller.E))
        return roller_torque_limits(self.clutch, mu=self.mu, p_lim=p_lim)

    @property
    def end(self) -> float:
        """Largest torque [N m] with an equilibrium."""
        found = self.of_torque_alone
        return float(min(found.pop_through, found.hertz))

    @cached_property
    def friction_holds(self) -> tuple[tuple[float, float], ...]:
        """Torque ranges [N m] in which friction transmits T and F_ax; an upper end may be inf."""
        T = np.geomspace(LEAST * self.end, (1 - 1e-9) * self.end, POINTS)
        held = self._held(T)
        found, ends = [], np.flatnonzero(np.diff(np.concatenate([[0], held.astype(int), [0]])))
        for start, stop in ends.reshape(-1, 2):
            low = 0.0 if start == 0 else self._crossing(T[start - 1], T[start])
            high = math.inf if stop == T.size else self._crossing(T[stop - 1], T[stop])
            found.append((low, high))
        return tuple(found)

    def _held(self, T: Array) -> NDArray[np.bool_]:
        return np.asarray(self.required(T, state.loaded(self.clutch, T).alpha) <= self.mu)

    def _crossing(self, low: float, high: float) -> float:
        """Torque [N m] between `low` and `high` at which the clutch begins or ceases to hold."""
        for _ in range(ROUNDS):
            T = np.linspace(low, high, POINTS)
            held = self._held(T)
            k = int(np.argmax(held != held[0]))
            low, high = float(T[k - 1]), float(T[k])
        return (low + high) / 2

    @property
    def _range(self) -> tuple[tuple[float, float], ...]:
        """Range of `friction_holds` that contains the torque T; empty if there is none."""
        return tuple(one for one in self.friction_holds if one[0] <= self.T <= one[1])

    @property
    def least_torque(self) -> float:
        """Torque [N m] above which friction transmits the axial load; 0 without a lower limit.

        The result is nan if no range of `friction_holds` contains T.
        """
        return next((low for low, _ in self._range), math.nan)

    @property
    def of_torque(self) -> list[Limit]:
        """Limits of the torque [N m] at the axial load of the duty, in ascending order."""
        alone = self.of_torque_alone
        names = (f.name for f in fields(alone) if f.name != "release")
        found = [Limit(name, float(getattr(alone, name))) for name in names]
        found += [Limit("slip", high) for _, high in self._range]
        return sorted((limit for limit in found if math.isfinite(limit.at)), key=lambda x: x.at)

    @property
    def allowed_shift(self) -> float:
        """Largest permissible e/L: `e_lim` if given, otherwise the value at lift-off of one end."""
        return LIFT_OFF if self.e_lim is None else self.e_lim

    @property
    def of_axial_load(self) -> list[Limit]:
        """Limits of the axial load [N] at the torque of the duty, in ascending order."""
        if (now := self.under) is None:
            return []
        cam = self.clutch.cam
        slip = criterion.largest_axial_load(alpha=now.alpha, T=self.T, R=cam.race, mu=self.mu)
        found = [Limit("slip", 0.0 if np.isnan(slip) else float(slip))]
        # F_ax over e/L
        one = tilt.offset(F_a=1.0, F_n=now.N, r=cam.roller, alpha=now.alpha)
        per_shift = float(cam.count * np.asarray(self.clutch.L) / one)
        key = "tilt_lift" if self.e_lim is None else "tilt"
        found.append(Limit(key, self.allowed_shift * per_shift))
        if self.p_lim is not None:
            share = uneven(self.p_lim / float(max(now.p_i, now.p_o)))
            found.append(Limit("pressure", share * per_shift))
        return sorted(found, key=lambda x: x.at)

    def largest_axial_load(self, T: Array) -> Array:
        """Largest axial load [N] under T [N m], limited by the pressure p_lim and `allowed_shift`.

        The result is nan if there is no equilibrium at T.
        """
        now, cam = state.loaded(self.clutch, T), self.clutch.cam
        share = np.full(T.shape, self.allowed_shift)
        if self.p_lim is not None:
            factors = self.p_lim / np.maximum(now.p_i, now.p_o)
            share = np.minimum(share, [uneven(float(x)) for x in factors])
        N = np.where(np.isfinite(now.N), now.N, 1.0)
        offset = tilt.offset(F_a=1.0, F_n=N, r=cam.roller, alpha=now.alpha)
        return np.asarray(share * cam.count * np.asarray(self.clutch.L) / offset)


def uneven(factor: float) -> float:
    """Ratio e/L at which the pressure at an end is `factor` times that under a uniform line load.

    The ratio is 0 if `factor` < 1.

    >>> uneven(2**0.5), uneven(2.0)  # line load at the end: 2 and 4 times its mean
    (0.16666666666666674, 0.33333333333333337)
    """
    peak = factor**2
    if peak <= 1:
        return 0.0
    return (peak - 1) / 6 if peak <= 2 else (1 - 4 / (3 * peak)) / 2

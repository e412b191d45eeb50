"""What ends a clutch's work first: as its torque grows under its axial load, and the reverse."""

import math
from dataclasses import dataclass, fields
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from analytic.freewheel import criterion, limits, state, tilt
from analytic.freewheel.limits import Limits
from analytic.freewheel.state import State
from verify.cases.freewheel.clutch.inputs import ClutchInputs

Array = NDArray[np.float64]

LIFT_OFF = 1 / 6  # e/L from which on a linear line load lifts off one end
NONE = 10.0  # pressure over E that stands for no limit of pressure
SMALLEST, POINTS, ROUNDS = 1e-7, 400, 3  # of the largest torque; torques of a search, its rounds

WORDS = {
    "slip": "the contacts slip",
    "bears": "below it friction no longer bears the axial load",
    "pressure_inner": "the inner contacts reach p_lim",
    "pressure_outer": "the outer contacts reach p_lim",
    "corner": "the rollers reach the ends of the cam flats",
    "pop_through": "the rollers go through between flat and shaft",
    "hertz": "contacts as wide as the rollers' radius, where the formulas end",
    "tilt": "the tilting couple moves the contact forces by (e/L)_lim",
    "tilt_lift": "the tilting couple lifts the rollers off at one end",
    "pressure": "the pressure at the rollers' ends reaches p_lim",
}


SEVERITY = ("pop_through", "corner", "hertz", "slip", "pressure_inner", "pressure_outer",
            "pressure", "tilt_lift", "tilt")  # fmt: skip


@dataclass(frozen=True)
class Limit:
    """A limit of the torque [N m] or the axial load [N]: its key in `WORDS` and its value."""

    key: str
    at: float

    @property
    def words(self) -> str:
        return WORDS[self.key]


@lru_cache(maxsize=8)
def under(q: ClutchInputs) -> State | None:
    """The state under the torque; None where the clutch overruns, rests or has no state."""
    if q.T <= 0:
        return None
    now = state.loaded(q.clutch, q.T)
    return now if np.isfinite(now.N) else None


@lru_cache(maxsize=8)
def of_torque_alone(q: ClutchInputs) -> Limits:
    """Limits of the torque that do not look at the axial load."""
    return limits.limits(q.clutch, mu=q.mu, p_lim=q.p_lim or NONE * q.E)


def end(q: ClutchInputs) -> float:
    """The largest torque [N m] that has a state."""
    found = of_torque_alone(q)
    return float(min(found.pop_through, found.hertz))


@lru_cache(maxsize=8)
def friction_holds(q: ClutchInputs) -> tuple[tuple[float, float], ...]:
    """Ranges of the torque [N m] in which friction bears it and F_ax; inf at an open end."""
    last = end(q)
    T = np.geomspace(SMALLEST * last, (1 - 1e-9) * last, POINTS)
    held = _held(q, T)
    found, ends = [], np.flatnonzero(np.diff(np.concatenate([[0], held.astype(int), [0]])))
    for start, stop in ends.reshape(-1, 2):
        low = 0.0 if start == 0 else _crossing(q, T[start - 1], T[start])
        high = math.inf if stop == T.size else _crossing(q, T[stop - 1], T[stop])
        found.append((low, high))
    return tuple(found)


def _held(q: ClutchInputs, T: Array) -> NDArray[np.bool_]:
    alpha = state.loaded(q.clutch, T).alpha
    asked = criterion.required_friction(alpha=alpha, T=T, F_ax=q.F_ax, R=q.cam.race)
    return np.asarray(asked <= q.mu)


def _crossing(q: ClutchInputs, low: float, high: float) -> float:
    """Where friction begins or ends to hold, between two torques [N m]."""
    for _ in range(ROUNDS):
        T = np.linspace(low, high, POINTS)
        held = _held(q, T)
        k = int(np.argmax(held != held[0]))
        low, high = float(T[k - 1]), float(T[k])
    return (low + high) / 2


def as_torque_grows(q: ClutchInputs) -> list[Limit]:
    """Limits of the torque [N m] at this axial load, the first one first."""
    alone = of_torque_alone(q)
    found = [
        Limit(f.name, float(getattr(alone, f.name))) for f in fields(alone) if f.name != "release"
    ]
    found += [Limit("slip", high) for low, high in friction_holds(q) if low <= q.T <= high]
    return sorted((limit for limit in found if math.isfinite(limit.at)), key=lambda x: x.at)


def allowed_shift(q: ClutchInputs) -> float:
    """e/L up to which the rollers do not tilt."""
    return LIFT_OFF if q.e_lim is None else q.e_lim


def largest_axial_load(q: ClutchInputs, T: Array) -> Array:
    """F_ax [N] at which the rollers' ends reach p_lim, or tilt, at T [N m]; nan without a state."""
    now = state.loaded(q.clutch, T)
    share = np.full(T.shape, allowed_shift(q))
    if q.p_lim is not None:
        factors = q.p_lim / np.maximum(now.p_i, now.p_o)
        share = np.minimum(share, [uneven(float(x)) for x in factors])
    offset = tilt.offset(F_a=1.0, F_n=np.where(np.isfinite(now.N), now.N, 1.0), r=q.r,
                         alpha=now.alpha)  # fmt: skip
    return np.asarray(share * q.z * q.L / offset)


def least_torque(q: ClutchInputs) -> float:
    """The torque [N m] above which friction bears the axial load; nan where it does nowhere near.

    0 where any torque will do.
    """
    return next((low for low, high in friction_holds(q) if low <= q.T <= high), math.nan)


def as_axial_load_grows(q: ClutchInputs) -> list[Limit]:
    """Limits of the axial load [N] at this torque, the first one first."""
    now = under(q)
    if now is None:
        return []
    most = float(criterion.largest_axial_load(alpha=now.alpha, T=q.T, R=q.cam.race, mu=q.mu))
    found = [Limit("slip", 0.0 if math.isnan(most) else most)]
    key = "tilt_lift" if q.e_lim is None else "tilt"
    found.append(Limit(key, allowed_shift(q) * per_offset(q)))
    if q.p_lim is not None:
        share = uneven(q.p_lim / float(max(now.p_i, now.p_o)))
        found.append(Limit("pressure", share * per_offset(q)))
    return sorted(found, key=lambda x: x.at)


def per_offset(q: ClutchInputs) -> float:
    """Axial load [N] on the clutch over e/L."""
    now = under(q)
    assert now is not None
    return float(q.z * q.L / tilt.offset(F_a=1.0, F_n=now.N, r=q.r, alpha=now.alpha))


def uneven(factor: float) -> float:
    """e/L at which Hertz's pressure at one end is `factor` times the even one; 0 where below 1."""
    peak = factor**2
    if peak <= 1:
        return 0.0
    return (peak - 1) / 6 if peak <= 2 else (1 - 4 / (3 * peak)) / 2

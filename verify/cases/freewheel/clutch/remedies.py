"""What to change so that a freewheel holds, and how far one that holds is from slipping."""

import math
from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from analytic.freewheel import criterion, state
from analytic.freewheel.clutch import Clutch
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.cases.freewheel.clutch.limits import end, under

Array = NDArray[np.float64]

GOALS = (1.0, 1.1)  # of mu/mu_req: what holds by Coulomb's law, and with a tenth to spare
FINE, NARROW = 1e-8, 0.1  # for a derivative [m], at most this of what a wedge has
FARTHEST, POINTS = 0.999, 400  # of the way to no wedge; places along it
STIFFEST, HALVINGS = 4.0, 30  # times R_a, beyond which a housing does no more
LONGEST = 10.0  # times L that are advised at most


def shifted(q: ClutchInputs, name: str, by: Array) -> Clutch:
    """Clutches whose X, r or R are off `by` [m]."""
    field = {"X": "X" if q.is_star else "X_o", "R": "R" if q.is_star else "R_s"}.get(name, name)
    cam = q.cam
    return replace(q.clutch, cam=replace(cam, **{field: getattr(cam, field) + by}))


def ratios(q: ClutchInputs, clutch: Clutch) -> Array:
    """mu/mu_req of `clutch` under the loads of `q`; 0 where it releases itself or bears no T."""
    now = state.loaded(clutch, q.T)
    asked = criterion.required_friction(alpha=now.alpha, T=q.T, F_ax=q.F_ax, R=clutch.cam.race)
    x, _ = clutch.cam.centre(d_i=now.d_i, d_o=now.d_o)
    lost = criterion.self_releasing(alpha=clutch.cam.alpha0, mu=q.mu) | (x > clutch.cam.corner)
    return np.where(lost | np.isnan(asked), 0.0, q.mu / asked)


@lru_cache(maxsize=16)
def moved_to(q: ClutchInputs, goal: float) -> float:
    """The least dX [m] outwards at which mu/mu_req is `goal`; nan where none is enough."""
    dX = np.linspace(0.0, FARTHEST * q.room, POINTS)
    enough = ratios(q, shifted(q, "X", dX)) >= goal
    if not np.any(enough):
        return math.nan
    k = int(np.argmax(enough))
    if k == 0:
        return 0.0
    fine = np.linspace(dX[k - 1], dX[k], POINTS)
    return float(fine[np.argmax(ratios(q, shifted(q, "X", fine)) >= goal)])


@lru_cache(maxsize=8)
def to_spare(q: ClutchInputs) -> float:
    """How far [m] flats may be nearer to the axis until it no longer holds; nan if never."""
    dX = -np.linspace(0.0, FARTHEST * q.room, POINTS)
    slips = ratios(q, _nearer(q, dX)) < 1
    if slips[0] or not np.any(slips):
        return math.nan
    k = int(np.argmax(slips))
    fine = np.linspace(dX[k - 1], dX[k], POINTS)
    return -float(fine[np.argmax(ratios(q, _nearer(q, fine)) < 1)])


@lru_cache(maxsize=8)
def until_pop_through(q: ClutchInputs) -> float:
    """How far [m] flats may be farther from the axis until no state bears T; nan if never."""

    def is_lost(dX: Array) -> NDArray[np.bool_]:
        return ~np.isfinite(state.loaded(shifted(q, "X", dX), q.T).N)

    dX = np.linspace(0.0, FARTHEST * q.room, POINTS)
    lost = is_lost(dX)
    if lost[0] or not np.any(lost):
        return math.nan
    k = int(np.argmax(lost))
    fine = np.linspace(dX[k - 1], dX[k], POINTS)
    return float(fine[np.argmax(is_lost(fine))])


def _nearer(q: ClutchInputs, dX: Array) -> Clutch:
    """Clutches with their flats nearer; those past a corner stay at the last that is not."""
    for share in np.linspace(1.0, 0.0, 50):
        try:
            return shifted(q, "X", np.maximum(dX, share * dX.min()))
        except ValueError:
            continue
    return q.clutch


def friction_for(q: ClutchInputs, goal: float) -> float:
    """Friction at which mu/mu_req is `goal`, or more where only that keeps the rollers in."""
    now = under(q)
    assert now is not None
    asked = criterion.required_friction(alpha=now.alpha, T=q.T, F_ax=q.F_ax, R=q.cam.race)
    return max(goal * float(asked), math.tan(float(q.cam.alpha0)))


@lru_cache(maxsize=8)
def per_micrometre(q: ClutchInputs) -> dict[str, float]:
    """Relative change of mu/mu_req by 1 µm on X, r and R; empty without a state."""
    now = under(q)
    if now is None:
        return {}
    found, step = {}, min(FINE, NARROW * q.room)
    for name in ("X", "r", "R"):
        try:
            clutch = shifted(q, name, step * np.array([-1.0, 1.0]))
        except ValueError:  # at a flat's corner, or rollers that touch
            return {}
        alpha = state.loaded(clutch, q.T).alpha
        low, high = criterion.required_friction(alpha=alpha, T=q.T, F_ax=q.F_ax, R=clutch.cam.race)
        found[name] = float((low - high) / (low + high)) * 1e-6 / step
    return found


def bearing(q: ClutchInputs) -> list[tuple[str, float]]:
    """R_a, L and X [m] of clutches that just bear T, where `q` has no state; those that there are.

    All torques grow with L; R_a is that of the part with its housing.
    """
    found = [("L", q.L * q.T / end(q))] if LONGEST * end(q) > q.T else []
    for name, worst in (("R_a", q.R_a * STIFFEST), ("X", q.X - q.room)):
        if (value := _towards(q, name, worst)) is not None:
            found.append((name, value))
    return found


def _towards(q: ClutchInputs, name: str, last: float) -> float | None:
    """The value of `name` between that of `q` and `last` from which on T is borne."""

    def bears(value: float) -> bool:
        other = q.model_copy(update={name: value})
        return bool(np.isfinite(state.loaded(other.clutch, q.T).N))

    near, far = float(getattr(q, name)), last
    try:
        if not bears(far):
            return None
        for _ in range(HALVINGS):
            middle = (near + far) / 2
            near, far = (near, middle) if bears(middle) else (middle, far)
    except ValueError:
        return None
    return far

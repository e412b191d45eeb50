"""Changes after which a clutch holds, and the margins of a clutch that holds. Lengths in m."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array
from analytic.freewheel import criterion, state
from analytic.freewheel.clutch import RollerClutch
from analytic.freewheel.duty import Duty
from analytic.freewheel.geometry import InnerCam

FINE, NARROW = 1e-8, 0.1  # step of a derivative [m], and its largest share of the wedge
MAX_SHIFT, POINTS = 0.999, 400  # of the room that a wedge has; places in it
STIFFEST, HALVINGS = 4.0, 30  # times R_a, beyond which a housing does no more
LONGEST = 10.0  # times L that are advised at most

Named = dict[str, str]


def field_of(clutch: RollerClutch, name: str) -> str:
    """Name of the cam's field for `name` X, r or R; an outer cam has X_o, r and R_s."""
    outer: Named = {"X": "X_o", "R": "R_s"}
    return name if isinstance(clutch.cam, InnerCam) else outer.get(name, name)


def shifted(clutch: RollerClutch, name: str, by: Array | float) -> RollerClutch:
    """Clutches whose X, r or R deviates by `by` [m]; raises ValueError if a clutch has no wedge."""
    cam, field = clutch.cam, field_of(clutch, name)
    return replace(clutch, cam=replace(cam, **{field: getattr(cam, field) + by}))


def ratios(duty: Duty, clutch: RollerClutch) -> Array:
    """Ratio mu/mu_req of `clutch` under the loads of `duty`.

    The ratio is 0 if the clutch releases itself, if it has no equilibrium at T, or if its rollers
    are beyond the corners.
    """
    now = state.loaded(clutch, duty.T)
    asked = criterion.required_friction(
        alpha=now.alpha, T=duty.T, F_ax=duty.F_ax, R=clutch.cam.race
    )
    x, _ = clutch.cam.centre(d_i=now.d_i, d_o=now.d_o)
    lost = criterion.self_releasing(alpha=clutch.cam.alpha0, mu=duty.mu) | (x > clutch.cam.corner)
    return np.where(lost | np.isnan(asked), 0.0, duty.mu / asked)


def moved_to(duty: Duty, goal: float) -> float:
    """Smallest outward shift dX [m] of the flats with mu/mu_req >= `goal`; nan if there is none."""
    return _first(duty, 1.0, lambda dX: ratios(duty, shifted(duty.clutch, "X", dX)) >= goal)


def to_spare(duty: Duty) -> float:
    """Largest inward shift [m] of the flats at which the clutch holds.

    The result is nan if the shift has no limit, and if the clutch does not hold without a shift.
    """
    far = -_first(duty, -1.0, lambda dX: ratios(duty, _nearer(duty, dX)) < 1)
    return far if far > 0 else math.nan


def until_pop_through(duty: Duty) -> float:
    """Largest outward shift [m] of the flats with an equilibrium at T.

    The result is nan if the shift has no limit, and if there is no equilibrium without a shift.
    """

    def is_lost(dX: Array) -> NDArray[np.bool_]:
        return ~np.isfinite(state.loaded(shifted(duty.clutch, "X", dX), duty.T).N)

    far = _first(duty, 1.0, is_lost)
    return far if far > 0 else math.nan


def _first(duty: Duty, sense: float, met: Callable[[Array], NDArray[np.bool_]]) -> float:
    """First shift dX [m] in the direction `sense` at which `met` is true; nan if there is none.

    The search ends when the wedge has nearly disappeared.
    """
    dX = sense * np.linspace(0.0, MAX_SHIFT * duty.clutch.cam.room, POINTS)
    there = met(dX)
    if not np.any(there):
        return math.nan
    if (k := int(np.argmax(there))) == 0:
        return 0.0
    fine = np.linspace(dX[k - 1], dX[k], POINTS)
    return float(fine[np.argmax(met(fine))])


def _nearer(duty: Duty, dX: Array) -> RollerClutch:
    """Clutches with flats shifted by dX; impossible shifts are set to the last possible shift."""
    for share in np.linspace(1.0, 0.0, 50):
        try:
            return shifted(duty.clutch, "X", np.maximum(dX, share * dX.min()))
        except ValueError:
            continue
    return duty.clutch


def friction_for(duty: Duty, goal: float) -> float:
    """Friction coefficient at which mu/mu_req is `goal`, but at least tan(alpha0).

    With less friction than tan(alpha0), rollers slip out of the wedge.

    Raises ValueError if no equilibrium exists at the torque.
    """
    if (now := duty.under) is None:
        raise ValueError(f"no equilibrium exists at T = {duty.T:g} N m")
    return max(goal * float(duty.required(duty.T, now.alpha)),
               math.tan(float(duty.clutch.cam.alpha0)))  # fmt: skip


def per_micrometre(duty: Duty) -> dict[str, float]:
    """Relative change of mu/mu_req if X, r or R grows by 1 µm, by name; empty if no equilibrium."""
    if duty.under is None:
        return {}
    found, step = {}, min(FINE, NARROW * float(duty.clutch.cam.room))
    for name in ("X", "r", "R"):
        try:
            clutch = shifted(duty.clutch, name, step * np.array([-1.0, 1.0]))
        except ValueError:  # at a flat's corner, or rollers that touch
            return {}
        alpha = state.loaded(clutch, duty.T).alpha
        low, high = criterion.required_friction(
            alpha=alpha, T=duty.T, F_ax=duty.F_ax, R=clutch.cam.race
        )
        found[name] = float((low - high) / (low + high)) * 1e-6 / step
    return found


def bearing(duty: Duty) -> list[tuple[str, float]]:
    """Values of L, R_a and X [m], each of which alone gives a clutch an equilibrium at T.

    With the listed value, T is the largest torque with an equilibrium. Dimensions without such a
    value are omitted. All torques are proportional to L; R_a is the outer radius of the part
    including its housing.
    """
    clutch, cam = duty.clutch, duty.clutch.cam
    L, R_a, X = (float(np.asarray(x)) for x in (clutch.L, clutch.R_a, cam.flat))
    flat = field_of(clutch, "X")
    found = [("L", L * duty.T / duty.end)] if LONGEST * duty.end > duty.T else []
    ways: tuple[tuple[str, float, float, Callable[[float], RollerClutch]], ...] = (
        ("R_a", R_a, R_a * STIFFEST, lambda value: replace(clutch, R_a=value)),
        (
            "X",
            X,
            X - float(cam.room),
            lambda value: replace(clutch, cam=replace(cam, **{flat: value})),
        ),
    )
    for name, own, last, made in ways:
        if (value := _towards(duty.T, own, last, made)) is not None:
            found.append((name, value))
    return found


def _towards(
    T: float, near: float, far: float, made: Callable[[float], RollerClutch]
) -> float | None:
    """Value between `near` and `far` beyond which `made(value)` transmits T [N m].

    The value is found by bisection. None if the clutch does not transmit T at `far`.
    """

    def bears(value: float) -> bool:
        return bool(np.isfinite(state.loaded(made(value), T).N))

    try:
        if not bears(far):
            return None
        for _ in range(HALVINGS):
            middle = (near + far) / 2
            near, far = (near, middle) if bears(middle) else (middle, far)
    except ValueError:
        return None
    return far

"""Torques at which a clutch reaches its limits, and the limit that is reached first.

A torque is infinite if the limit is not reached up to the last equilibrium. The last equilibrium is
the torque maximum of an outer cam, beyond which the rollers pop through, or the state in which the
half-width of a contact reaches r/2.
"""

from collections.abc import Callable
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.checks import Array, not_negative
from analytic.freewheel import state
from analytic.freewheel.clutch import RollerClutch
from analytic.freewheel.criterion import friction
from analytic.freewheel.state import RollerClutchState

HALVINGS = 60
LEAST = 1e-9  # relative to the largest normal force, from which limits are searched

MEANINGS = {
    "release": "the rollers slip out: tan(alpha) exceeds mu",
    "pressure_inner": "the inner contact reaches the pressure limit",
    "pressure_outer": "the outer contact reaches the pressure limit",
    "corner": "the rollers reach the corners of the flats",
    "pop_through": "the rollers pop through between flat and shaft",
    "hertz": "the contacts are wider than half the roller's radius",
}


@dataclass(frozen=True, kw_only=True, eq=False)
class RollerClutchLimits:
    """Torques [force x length] at the limits; `MEANINGS` describes the limits."""

    release: Array
    pressure_inner: Array
    pressure_outer: Array
    corner: Array
    pop_through: Array
    hertz: Array

    @property
    def torque(self) -> Array:
        """Smallest of the torques [force x length]."""
        return np.asarray(self._all.min(axis=0))

    @property
    def first(self) -> NDArray[np.str_]:
        """Name of the limit with the smallest torque."""
        names = np.array([field.name for field in fields(self)])
        return np.asarray(names[self._all.argmin(axis=0)])

    def passed(self, T: ArrayLike) -> NDArray[np.str_]:
        """Message on the limit that the torque T exceeds; empty if T is within all limits."""
        messages = np.array([MEANINGS[field.name] for field in fields(self)])[
            self._all.argmin(axis=0)
        ]
        return np.where(not_negative(T, "torque", "N m") > self.torque, messages, "")

    @property
    def _all(self) -> Array:
        return np.array(np.broadcast_arrays(*(getattr(self, f.name) for f in fields(self))))


Limits = RollerClutchLimits  # its name in version 0.1


def roller_torque_limits(
    clutch: RollerClutch, *, mu: ArrayLike, p_lim: ArrayLike
) -> RollerClutchLimits:
    """Torque limits of `clutch` for friction coefficient mu and permissible pressure [stress]."""
    mu, cam = friction(mu), clutch.cam
    L = np.asarray(clutch.L)
    last = _last(clutch)
    summit = _summit(clutch, last)
    corner = _first(clutch, last, lambda now: now.alpha + 0 * cam.corner > _corner_angle(now))
    end = np.minimum(summit, last)

    def torque(N: Array) -> Array:
        within = end >= N
        found = state.at_normal_force(clutch, np.where(within, N, 0.0)).T
        return np.where(within, found, np.inf)

    P_i, P_o = clutch.loads_at_pressure(p_lim)
    hertz = np.where(np.isfinite(summit), np.inf, torque(last))
    return RollerClutchLimits(
        release=_release(clutch, mu), pressure_inner=torque(P_i * L),
        pressure_outer=torque(P_o * L), corner=torque(corner), pop_through=torque(summit),
        hertz=hertz,
    )  # fmt: skip


limits = roller_torque_limits  # its name in version 0.1


def pop_through(clutch: RollerClutch) -> Array:
    """Maximum torque [force x length], at pop-through; infinite if there is no maximum."""
    last = _last(clutch)
    summit = _summit(clutch, last)
    within = last >= summit
    found = state.at_normal_force(clutch, np.where(within, summit, 0.0)).T
    return np.where(within, found, np.inf)


def _last(clutch: RollerClutch) -> Array:
    """Normal force [force] at which a contact reaches the half-width limit of Hertz's theory."""
    widths = clutch.loads_at_half_width(state.WIDEST * clutch.cam.roller)
    return np.asarray(np.asarray(clutch.L) * np.minimum(*widths))


def _summit(clutch: RollerClutch, last: Array) -> Array:
    """Normal force [force] above which the torque no longer increases; infinite if none."""
    return _first(clutch, last, lambda now: np.isnan(now.alpha) | (_growth(now) <= 0))


def _release(clutch: RollerClutch, mu: Array) -> Array:
    """Torque at which tan(alpha) = mu: 0 if exceeded without load, infinite if never reached."""
    at = state.at_angle(clutch, 2 * np.arctan(mu))
    started = np.tan(clutch.cam.alpha0) > mu
    reached = np.where(clutch.cam.sense > 0, at.T, np.inf)
    return np.where(started, 0.0, np.where(np.isnan(reached), np.inf, reached))


def _growth(now: RollerClutchState) -> Array:
    """Ratio of dT/dN to T/N."""
    N = np.where(np.isfinite(now.N), now.N, 0.0)  # beyond the last state: any value
    tangent, slope = now.bodies.tangent(N)
    return np.asarray(1 + N * slope / tangent)


def _corner_angle(now: RollerClutchState) -> Array:
    """Half of the angle psi [rad] at which the contact is at the corner of the flat."""
    cam = now.bodies.clutch.cam
    _, y = cam.centre(d_i=now.d_i, d_o=now.d_o)
    return np.asarray(np.arctan(cam.corner / y) / 2)


def _first(
    clutch: RollerClutch, last: Array, met: Callable[[RollerClutchState], NDArray[np.bool_]]
) -> Array:
    """Smallest normal force [force] at which `met` is true, by bisection; infinite if none."""
    shape = np.broadcast_shapes(last.shape, clutch.cam.alpha0.shape)
    low, high = np.broadcast_to(LEAST * last, shape), np.broadcast_to(last, shape)
    never = ~met(state.at_normal_force(clutch, high))
    for _ in range(HALVINGS):
        middle = np.sqrt(low * high)
        beyond = met(state.at_normal_force(clutch, middle))
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    return np.where(never, np.inf, low)

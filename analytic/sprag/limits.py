"""Limits of the torque of a sprag clutch (friction, end of the spiral), and contact pressures.

A limit that is not reached up to the last state is infinite (laws of slices end at their largest
load). A limit that is exceeded without load is 0.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.checks import Array, positive
from analytic.freewheel.criterion import friction
from analytic.sprag.closure import Wedged, wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.parts import SpragClutchParts
from analytic.sprag.search import first_reach


@dataclass(frozen=True, kw_only=True, eq=False)
class SpragClutchLimits:
    """Torque [N m] at which tan(nu) reaches mu, and torque at the end of the spiral."""

    slip: Array
    end_of_cam: Array

    @property
    def torque(self) -> Array:
        """Smaller of both torques [N m]."""
        return np.asarray(np.minimum(self.slip, self.end_of_cam))


Limits = SpragClutchLimits  # its name in version 0.1


def sprag_torque_limits(
    clutch: SpragClutch, *, mu: ArrayLike, theta_max: ArrayLike
) -> SpragClutchLimits:
    """Torque limits for the friction coefficient mu and the spiral angle theta_max [rad].

    theta_max is measured from first contact. The inner contact slips first, because nu is larger
    than omega.
    """
    mu, theta_max = friction(mu), positive(theta_max, "angle theta_max of the spiral", "rad")
    return SpragClutchLimits(
        slip=_torque(clutch, lambda now: np.asarray(np.tan(now.nu)), mu),
        end_of_cam=_torque(clutch, lambda now: now.turned, theta_max),
    )


limits = sprag_torque_limits  # its name in version 0.1


def _torque(clutch: SpragClutch, quantity: Callable[[Wedged], Array], limit: Array) -> Array:
    """Torque [N m] at which `quantity` of the state first reaches its limit."""
    past = quantity(wedged(clutch, 0.0)) > limit
    N = first_reach(lambda N: quantity(wedged(clutch, N)), limit, start=np.where(past, 0.0, 1.0))
    return np.asarray(np.where(np.isnan(N), np.inf, wedged(clutch, N).T))


def slips(state: Wedged, *, mu: ArrayLike) -> NDArray[np.bool_]:
    """True if the inner contact slides: tan(nu) > mu."""
    return np.asarray(np.tan(state.nu) > friction(mu))


def pressures(parts: SpragClutchParts, state: Wedged) -> tuple[Array, Array]:
    """Hertz's peak pressures p_i, p_o [Pa] of uniform loads, with the radius of the spiral at A.

    Loads are uniform along the sprag. Each contact is evaluated under its normal force. Crowns
    increase the pressure in the middle.
    """
    l, r_i = np.asarray(parts.l), state.rho * np.hypot(1, parts.sprag.m)  # noqa: E741
    inner = 1 / (1 / r_i + 1 / np.asarray(parts.sprag.R_i))
    p_i = np.sqrt(state.N / l * parts.E_star / (np.pi * inner))
    p_o = np.sqrt(state.N_e / l * parts.E_star / (np.pi * parts.R_contact_e))
    return np.asarray(p_i), np.asarray(p_o)

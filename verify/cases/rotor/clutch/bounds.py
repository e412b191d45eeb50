"""Errors of Eqs. 3 to 11 that are expected, and the couplings of a tilted clutch summed anew.

Sprags of that clutch stand from half a pitch on. Slice k of sprag j is pressed by d_jk =
(dx + x_k gamma) cos psi_j + R_i tan nu g, with the power 10/9 of which its force grows. The twist g
bears T, and the couplings are sums of the slope times -x_k sin^2 psi_j and x_k cos^2 psi_j.
"""

import math
from typing import Any

import numpy as np
from scipy.optimize import brentq

from analytic.rotor.clutch import LINE_CONTACT
from verify.cases.rotor.clutch.inputs import SpragLink
from verify.core.figures import Array

POWER = 10 / 9  # of a line contact
SERIES = 4e-3  # that a series may be uncertain by
SHARE = 0.05  # of what Eq. 3 leaves out, that expectations are given to
Interval = tuple[float, float]


def summed(q: SpragLink, dx: float, tilt: float) -> dict[str, float]:
    """Couplings [N] of a force along y with a tilt about x, and of one along x with one about y.

    The offset dx [m] is along x, the tilt [rad] about y.
    """
    psi = 2 * math.pi * (np.arange(q.Z) + 0.5)[:, None] / q.Z
    x = q.L * ((np.arange(q.n_s) + 0.5) / q.n_s - 0.5)
    lever = q.R_i * math.tan(q.nu)
    uneven = (dx + tilt * x) * np.cos(psi)

    def pressed(twist: float) -> Array:
        return np.asarray(np.maximum(uneven + lever * twist, 0.0))

    def excess(twist: float) -> float:
        """Torque over T [1], less one."""
        return float(lever * q.k_n / q.n_s * (pressed(twist) ** POWER).sum() / q.T - 1)

    even = (q.T / (q.Z * lever * q.k_n)) ** (1 / POWER)  # what an even load presses
    most = even + np.abs(uneven).max()
    twist = float(brentq(excess, 0.0, most / lever, xtol=1e-13 * most / lever))
    slope = POWER * q.k_n / q.n_s * pressed(twist) ** (POWER - 1)
    return {
        "K_y_tilt_x": float(-(slope * x * np.sin(psi) ** 2).sum()),
        "K_x_tilt_y": float((slope * x * np.cos(psi) ** 2).sum()),
    }


def inclined(state: Any, entry: str) -> Interval:
    """Interval of formula/struts - 1: the general formulas over the same corrected for ν.

    What both have in common cancels, so that no fault of a formula moves it.
    """
    K = state.inclined(entry)
    left_out = state.leaning if entry == "K_tilt" else 0.0
    width = SHARE * (math.tan(state.nu) ** 2 + left_out / K)
    m = state.general(entry) / (K - left_out) - 1
    return m - width, m + width


def first_order(q: Any) -> Interval | None:
    """The same for the coupling's first term in eps = dx/delta_0; squares of eps^2 left out.

    The next term of the sum over cos psi, and the yield that the torque takes back; nothing where
    eps is too large for a first term, or sprags too few for fourth powers to sum to 3/8 of Z.
    """
    n, eps = LINE_CONTACT, q.e / q.delta_0
    after = ((n - 2) * (n - 3) / 8 + (2 - n) * (n - 1) / 4) * eps**2
    neglected = math.tan(q.nu) ** 2
    width = (neglected + eps**2) ** 2
    if width > SERIES or q.Z < 5:
        return None
    return -after - neglected - width, -after - neglected + width


def leading(q: Any) -> Interval:
    """Eq. 3 alone: cos^2 for cos^2 + tan^2 nu sin^2 of every sprag, and the next term twice."""
    neglected = math.tan(q.nu) ** 2
    return -neglected, -neglected + 2 * neglected**2


def held_ends(q: Any) -> Interval:
    """The same with struts held in both races: their forces turn with them, by Q/l; squares off."""
    length = q.R_e - q.R_i
    terms = (math.tan(q.nu) ** 2, q.delta_0 / (LINE_CONTACT * length))
    return terms[1] - terms[0] - sum(terms) ** 2, terms[1] - terms[0] + sum(terms) ** 2

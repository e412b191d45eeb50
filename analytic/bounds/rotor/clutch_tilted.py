"""Expected errors of coupling stiffnesses of a tilted clutch, and their second calculation.

The first sprag of the clutch is at half a pitch. The deflection of slice k of sprag j is
d_jk = (dx + x_k gamma) cos psi_j + R_i tan nu g; its force is proportional to the power 10/9 of
d_jk, with the slope s_jk. The twist g follows from T. One coupling is the sum of
-s_jk x_k sin^2 psi_j, the other the sum of s_jk x_k cos^2 psi_j.
"""

import math
from dataclasses import replace
from typing import Literal

import numpy as np
from scipy.optimize import brentq

from analytic.rotor.clutch import Array, SpragCoupling, even_angles
from analytic.rotor.clutch_state import under_torque

POWER = 10 / 9  # of a line contact
SHARE = 0.05  # uncertainty of an expected error, as a share of the omitted terms
Entry = Literal["K_y_tilt_x", "K_x_tilt_y"]
PLACES: dict[Entry, tuple[int, int]] = {"K_y_tilt_x": (1, 2), "K_x_tilt_y": (0, 3)}


def summed(
    clutch: SpragCoupling, *, T: float, dx: float, tilt: float, n_s: int
) -> dict[Entry, float]:
    """Couplings [N]: force along y per tilt about x, and force along x per tilt about y.

    The offset dx [m] is along x, the tilt [rad] about y, the torque is T [N m]. The sprags have
    `n_s` slices without a crown; only the dimensions of `clutch` are used.
    """
    Z, k_n = clutch.Z, clutch.k_n
    psi = 2 * math.pi * (np.arange(Z) + 0.5)[:, None] / Z
    x = clutch.L * ((np.arange(n_s) + 0.5) / n_s - 0.5)
    lever = clutch.R_i * math.tan(clutch.nu)
    uneven = (dx + tilt * x) * np.cos(psi)

    def pressed(twist: float) -> Array:
        return np.asarray(np.maximum(uneven + lever * twist, 0.0))

    def excess(twist: float) -> float:
        """Relative error [1] of the torque: torque/T - 1."""
        return float(lever * k_n / n_s * (pressed(twist) ** POWER).sum() / T - 1)

    even = (T / (Z * lever * k_n)) ** (1 / POWER)  # deformation under a uniform load
    most = even + uneven.max()  # above any twist: `uneven` has the mean 0
    twist = float(brentq(excess, 0.0, most / lever, xtol=1e-13 * most / lever))
    slope = POWER * k_n / n_s * pressed(twist) ** (POWER - 1)
    return {
        "K_y_tilt_x": float(-(slope * x * np.sin(psi) ** 2).sum()),
        "K_x_tilt_y": float((slope * x * np.cos(psi) ** 2).sum()),
    }


def left_out(
    entry: Entry, clutch: SpragCoupling, *, T: float, dx: float, tilt: float, n_s: int
) -> tuple[float, float]:
    """Interval of the error of a coupling against struts whose contact points tilt with the race.

    `clutch` must have sufficiently many slices; the formula has `n_s` slices. The value of the
    formula is computed again by `summed`, so that an error of the formula does not change the
    interval. Points of the race at R_i rotate by a = gamma_y cos(psi + nu) about their tangent.
    They move away from the sprag by R_i a^2/2 and along the axis by R_i a, which changes the lever
    arm of a tilt.
    """
    nu, R_i = clutch.nu, clutch.R_i
    plain = replace(clutch, psi=even_angles(Z=clutch.Z, psi_0=math.pi / clutch.Z + nu))
    direction = np.stack([np.cos(plain.psi), np.sin(plain.psi)]) / math.cos(nu)
    a = tilt * direction[0]
    sinking = replace(plain, interference=-R_i * a**2 / 2)
    stretched = (dx / math.cos(nu), 0, 0, tilt / math.cos(nu))
    at = under_torque(sinking, T=T, offset=stretched)
    inclined = float(sinking.stiffness(at)[PLACES[entry]]) / math.cos(nu) ** 2
    along, sign = (1, 1) if entry == "K_y_tilt_x" else (0, -1)
    moved = float(sinking.slopes(at).sum(-1) @ (sign * R_i * a * direction[along] ** 2))
    m = summed(clutch, T=T, dx=dx, tilt=tilt, n_s=n_s)[entry] / (inclined + moved) - 1
    width = SHARE * (math.tan(nu) ** 2 + abs(moved / inclined))
    return m - width, m + width

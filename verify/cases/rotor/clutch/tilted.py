"""A clutch held aside and tilted at once: what bending forces and tilts have to do with each other.

At one end of the sprags the offset is twice as large, at the other there is none, so that the load
is uneven around and along. Eq. 7 then couples a force along y with a tilt about x, and one along x
with a tilt about y; even loads, or uneven ones around alone, couple neither.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.rotor.clutch import Array, Clutch, even_angles
from analytic.rotor.clutch_state import under_torque
from verify.cases.rotor.clutch.bounds import summed
from verify.cases.rotor.clutch.inputs import SpragLink

FINE = 401  # slices that stand for none
LARGEST = 0.25  # of the yield, so that every slice keeps in contact
SHARE = 0.05  # of what the formula leaves out, that expectations are given to
TILTS = {"K_y_tilt_x": (1, 2), "K_x_tilt_y": (0, 3)}


def aside(q: SpragLink, delta_0: float) -> tuple[float, float]:
    """Offset along x [m] and tilt about y [rad]."""
    dx = min(q.e, LARGEST * delta_0)
    return dx, 2 * dx / q.L


def couplings(q: Any) -> dict[str, float]:
    """Both entries [N] by Eqs. 3 to 11."""
    dx, tilt = aside(q, q.delta_0)
    clutch = _turned(q.clutch(), q, 0.0)
    K = clutch.stiffness(under_torque(clutch, T=q.T, offset=(dx, 0, 0, tilt)))
    return {entry: float(K[at]) for entry, at in TILTS.items()}


def left_out(entry: str, q: Any) -> tuple[float, float]:
    """Interval of formula/struts - 1: forces along the struts, at points that sink with the tilt.

    The formula's side is summed anew, so that a slip of its value does not move the interval.
    Points of the race at R_i turn by a = gamma_y cos(psi + nu) about their tangent: they sink by
    R_i a^2/2 off the sprag, and move along the axis by R_i a, which changes a tilt's lever.
    """
    dx, tilt = aside(q, q.delta_0)
    plain = _turned(q.clutch(n_s=FINE), q, q.nu)
    direction = np.stack([np.cos(plain.psi), np.sin(plain.psi)]) / math.cos(q.nu)
    a = tilt * direction[0]
    sinking = replace(plain, interference=-q.R_i * a**2 / 2)
    stretched = (dx / math.cos(q.nu), 0, 0, tilt / math.cos(q.nu))
    at = under_torque(sinking, T=q.T, offset=stretched)
    inclined = float(sinking.stiffness(at)[TILTS[entry]]) / math.cos(q.nu) ** 2
    along, sign = (1, 1) if entry == "K_y_tilt_x" else (0, -1)
    moved = float(sinking.slopes(at).sum(-1) @ (sign * q.R_i * a * direction[along] ** 2))
    m = summed(q, dx, tilt)[entry] / (inclined + moved) - 1
    width = SHARE * (math.tan(q.nu) ** 2 + abs(moved / inclined))
    return m - width, m + width


def _turned(clutch: Clutch, q: SpragLink, angle: float) -> Clutch:
    """The same with sprags from half a pitch on: four of them at 0° would couple nothing."""
    psi: Array = even_angles(Z=q.Z, psi_0=math.pi / q.Z + angle)
    return replace(clutch, psi=psi)

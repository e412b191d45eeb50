"""Eqs. 2 to 8 of a clutch aside and tilted, summed anew: what its couplings are held to.

Sprags stand from half a pitch on. Slice k of sprag j is pressed by d_jk = (dx + x_k gamma) cos
psi_j + R_i tan nu g, with the power 10/9 of which its force grows. The twist g bears T, and the
couplings are sums of the slope times -x_k sin^2 psi_j and x_k cos^2 psi_j.
"""

import math

import numpy as np
from scipy.optimize import brentq

from verify.cases.rotor.clutch.inputs import ClutchInputs
from verify.core.figures import Array

POWER = 10 / 9  # of a line contact


def summed(q: ClutchInputs, dx: float, tilt: float) -> dict[str, float]:
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
        "K_y,γx": float(-(slope * x * np.sin(psi) ** 2).sum()),
        "K_x,γy": float((slope * x * np.cos(psi) ** 2).sum()),
    }

"""Initial state of an engagement: only the energizing springs press the sprags on the races."""

import numpy as np
from scipy.optimize import brentq

from analytic.contact.checks import Array
from analytic.sprag.motion import Motion, Speeds
from analytic.sprag.table import Table


def at_rest(table: Table, motion: Motion, speeds: Speeds) -> Array:
    r"""Initial angles theta_i, theta_e, phi, alpha [rad] and their speeds [rad/s], (8,).

    N and T_e balance the moment of the energizing springs; T_i = 0. With c_e = OB - b_e

    .. math:: T_e = -\frac{h N}{c_e}, \qquad K_r(\alpha_{max} - \alpha) = h N - b_e T_e.

    Raises ValueError if the energizing springs would rotate the sprag to the end of its profile.
    """
    slack = motion.alpha_max - table.origin

    def excess(alpha: float) -> float:
        g = table.at(alpha)
        moment = g["h"] * g["N"] * g["OB"] / (g["OB"] - g["b_e"])
        return float(moment - motion.K_r * (slack - alpha))

    if excess(table.end) <= 0:
        raise ValueError(
            "the energizing springs must not rotate the sprag to the end of its profile at "
            f"{table.end:.4g} rad, got K_r={motion.K_r} N m/rad, alpha_max={motion.alpha_max} rad"
        )
    alpha = brentq(excess, 0.0, table.end, xtol=1e-15) if excess(0.0) < 0 else 0.0
    g = table.at(alpha)
    T_e = -g["h"] * g["N"] / (g["OB"] - g["b_e"])
    theta_e = float(table.n_s * g["OB"] * T_e / motion.k_out)
    return np.array([0.0, theta_e, 0.0, alpha, speeds.inner, speeds.outer, speeds.phi, 0.0])

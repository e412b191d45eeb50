"""Errors of Eq. 6 that are expected of the Fourier ring and of an indentation by integration."""

import numpy as np
from scipy.integrate import quad

from verify.case import Expected, Quantity
from verify.cases.ring.loads.formulas import SpragLoads

ACCEPTED = 1e-3
PART = 0.05  # of the displacement at the load: of less a ratio says nothing
DEPTH = {"dent": 1.0, "dent_half": 0.5}  # over the wall
BY_FOURIER = (
    "derived: the Fourier ring's own value, which knows nothing of these finite elements; the dent "
    "from McEwen's stresses, integrated along the axis of the contact"
)


def expected(q: SpragLoads, formula: Quantity, at: Quantity, less: Quantity | None) -> Expected:
    """formula/(Fourier ring - indentation) - 1, give or take the acceptance figure.

    Both from the Fourier ring, whose mean is Lamé's ring, so that a slip in Eq. 6 shows, and the
    indentation by integration, so that one in its formula does.
    """
    reference = getattr(q, at.name) - (integrated_dent(q, DEPTH[less.name]) if less else 0.0)
    if abs(reference) < PART * q.load:
        return Expected(0.0, 0.0, BY_FOURIER, sharp=False)
    added = integrated_dent(q, DEPTH["dent"]) if formula.name == "with_dent" else 0.0
    ratio = (q.mean + added) / reference
    slack = ACCEPTED * abs(ratio)
    return Expected(ratio - 1 - slack, ratio - 1 + slack, BY_FOURIER)


def integrated_dent(q: SpragLoads, share: float) -> float:
    """Shortening [m] of the axis below a patch down to `share` of the wall, plane stress."""
    a, depth = q.half_width, share * (q.r_o - q.r_i)
    p_0 = 2 * q.P / (np.pi * a)

    def strain(z: float) -> float:
        root = np.hypot(a, z)
        sigma_z = -p_0 * a / root
        sigma_x = -p_0 * ((a**2 + 2 * z**2) / (a * root) - 2 * z / a)
        return float(sigma_z - q.nu * sigma_x) / q.E

    return -float(quad(strain, 0.0, depth, points=(a,))[0])

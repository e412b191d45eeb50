"""Stiffness of a spring that finite elements pull with 1 N."""

from typing import Any

import numpy as np

ROUND_OFF = 10 * float(np.finfo(float).eps)  # of sums over hundreds of elements


def stiffness(solved: Any) -> tuple[float, float]:
    """Stiffness [N/m] of a solution under 1 N, and its uncertainty by round-off."""
    k = -1 / (2 * solved.potential_energy)
    return k, abs(k) * max(solved.residual, ROUND_OFF)  # shares of energy

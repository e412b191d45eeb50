"""Stiffness of a linear structure, from its potential energy under a unit force."""

from typing import Protocol

import numpy as np

ROUND_OFF = 10 * float(np.finfo(float).eps)  # of sums over hundreds of elements


class Solved(Protocol):
    """Common interface of solutions of frames and bodies."""

    @property
    def potential_energy(self) -> float:
        """Strain energy minus the work of the loads."""
        ...

    @property
    def residual(self) -> float:
        """Energy of the solver's last correction, relative to the energy of the solution."""
        ...


def stiffness(solved: Solved) -> tuple[float, float]:
    """Stiffness [force/length], from the solution under a unit force, and uncertainty by round-off.

    The relative error of the energy is the square of the relative error of the displacements.
    """
    k = -1 / (2 * solved.potential_energy)
    return k, abs(k) * max(solved.residual, ROUND_OFF)  # shares of energy

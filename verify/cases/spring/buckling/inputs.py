"""Inputs of case spring-buckling, and parameters of the other springs that it computes."""

import math
from typing import Literal

from verify.cases.spring.inputs import SpringInputs, length_of
from verify.cases.spring.limits import Share
from verify.core.inputs import quantity

TAILS: tuple[Literal["arc"], Literal["mid-leaf"]] = ("arc", "mid-leaf")
KEYS = {"arc": "", "mid-leaf": "_mid_leaf"}  # end the names of numbers
DRIFT = (Share(0.5), Share(0.9))  # loads over P at which the drift is compared
THICKNESSES = (0.5, 1.0, 1.5, 2.0)  # thicknesses over b
MANY = (16, 24, 36, 54)  # units, increasing
RATIO = 240.0  # L_0/b of Eq. 13
SAME_RATIO = (8, 12, 20)  # units at that ratio
MAP_N = (6, 8, 10, 14, 20)
MAP_L1 = (0.5, 1.0, 1.5, 2.0)  # lengths over L_1


class BucklingInputs(SpringInputs):
    """Inputs of a spring and its working force."""

    F: float | None = quantity(
        None, "N", "F", "working force, compared with the buckling force", omitted=None, gt=0,
        example="0.5 N",
    )  # fmt: skip

    @property
    def length(self) -> float:
        """Length [m] along the axis, from the leaf of the head to that of the tail."""
        return self.length_of(self.n, self.L1)

    def length_of(self, n: int, L1: float) -> float:
        """Length [m] of a spring with n segments and leaves of the length L1 [m]."""
        return length_of(n, L1, self.R, self.alpha)

    @property
    def P(self) -> float:
        """Scale of loads [N]: Euler load of a cantilever column of the length of the spring.

        The column has the bending compliance of the unfolded strip.
        """
        unfolded = (self.n - 2) * (self.leaf + 2 * self.R * self.alpha)
        EI = self.E * self.h * self.b**3 / 12
        return math.pi**2 / 4 * EI / (unfolded * self.length)

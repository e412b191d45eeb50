"""Inputs of the accordion spring as a strip of finite width: how its ends are held."""

import math

from analytic.spring.frame import Head, Tail
from verify.cases.spring.inputs import SpringInputs
from verify.core.inputs import word


class WidthInputs(SpringInputs):
    """The accordion spring between its head and where its tail is held."""

    head: Head = word(
        "guided", "boundary condition of the head: guided, neither sideways motion nor rotation"
    )
    tail: Tail = word(
        "mid-leaf", "where the clamp of the tail begins: in its middle, or at its arc"
    )

    @property
    def leaf(self) -> float:
        """Straight length [m] of the middle units."""
        return (self.L1 + 2 * self.R * math.cos(self.alpha)) / math.sin(self.alpha)

    @property
    def widest(self) -> float:
        """The factor of a strip much wider than its leaves are long."""
        return 1 / (1 - self.nu**2)

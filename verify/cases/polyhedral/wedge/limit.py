"""Where friction no longer holds a roller that only its contacts hold: the solver says so."""

import math

import numpy as np
from numpy.typing import NDArray

from verify.cases.polyhedral.wedge.inputs import WedgeInputs
from verify.cases.polyhedral.wedge.model import Geometry, Wedge, fem_mesh

Array = NDArray[np.float64]

BELOW, ABOVE = 2e-4, 4e-4  # of T/N: ends of the bracket in which the limit is searched
BISECTIONS = 5
COARSE = 6  # cells on the half-width: forces do not depend on it
HELD = 0.9  # of N: more is left of it, or the roller is on its way out
ANY = 0.5  # the same where approaches are alike and forces are not, wedge by wedge
LOST = 1e-6  # of N: less is what round-off leaves of a contact that has opened
ANGLES = (0.1, 0.3, 0.5, 0.7, 0.9, 0.98, 1.02, 1.2, 1.45)  # tan(alpha/2)/mu of the sweep


class Limit:
    """Rollers under races that come down as far as under N, for any angle and friction."""

    def __init__(self, q: WedgeInputs, down: float) -> None:
        self.q, self.down = q, down
        self.mesh = fem_mesh(self._geometry(q.half), COARSE)

    def left(self, mu: float) -> float:
        """Part of N that is left under the friction `mu`: about all, or next to nothing."""
        return self._pressed(Wedge(self._geometry(self.q.half), self.mesh, E=self.q.E,
                                   nu=self.q.nu, mu=mu))[0]  # fmt: skip

    def friction(self, share: float) -> tuple[float, float]:
        """The least friction that holds the roller, by bisection, and half of the last bracket.

        The first bracket lies about `share`, the T/N that friction must bear. Not a number where
        the roller is held at both its ends, or at none.
        """
        low, high = share * (1 - BELOW), share * (1 + ABOVE)
        if self.left(low) > HELD or self.left(high) < HELD:
            return math.nan, 0.0
        for _ in range(BISECTIONS):
            middle = (low + high) / 2
            low, high = (low, middle) if self.left(middle) > HELD else (middle, high)
        return (low + high) / 2, (high - low) / 2

    def around(self) -> Array:
        """What is left of N (2,) with friction 1 % below and above tan(alpha/2)."""
        return np.array([self.left(share * math.tan(self.q.half)) for share in (0.99, 1.01)])

    def over_angles(self) -> Array:
        """tan(alpha/2)/mu, part of N that is left, T/(mu N) or 0 where it is none (3, m)."""
        found = []
        for share in ANGLES:
            geometry = self._geometry(math.atan(share * self.q.mu))
            wedge = Wedge(
                geometry, fem_mesh(geometry, COARSE), E=self.q.E, nu=self.q.nu, mu=self.q.mu
            )
            left, ratio = self._pressed(wedge)
            found.append((share, left, ratio / self.q.mu if left > ANY else 0.0))
        return np.array(found).T

    def _geometry(self, half: float) -> Geometry:
        return Geometry(self.q.R, half, self.q.a)

    def _pressed(self, wedge: Wedge) -> tuple[float, float]:
        """N over the given one, and T/N; zeros where the roller has lost its contact."""
        N, T = wedge.forces(wedge.at(self.down))
        left = N / self.q.line_load
        return (left, T / N) if left > LOST else (0.0, 0.0)

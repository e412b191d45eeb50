"""Where a frame touches itself or an obstacle in one accepted state."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fem.beam.section import Array, Bodies, Indices

OBSTACLE = -1


@dataclass(frozen=True)
class Record:
    """The k places that press: the probes' `elements` and their `partners` (-1: an obstacle).

    `at` (k, 2) is the touching surface, `n` (k, 2) points from the partner to the probe's
    element, which `normal` (k,) pushes along n and friction `tangential` (k,) against its slip
    along t, n turned by -90 deg. `gap` (k,) is negative where surfaces overlap.
    """

    elements: Indices
    partners: Indices
    at: Array
    n: Array
    gap: Array
    normal: Array
    tangential: Array
    sticking: NDArray[np.bool_]

    @property
    def penetration(self) -> float:
        """Deepest overlap, 0 without any."""
        return max(0.0, -float(self.gap.min(initial=0.0)))

    @property
    def force(self) -> Array:
        """Force (k, 2) on the probes' elements."""
        t = np.column_stack([self.n[:, 1], -self.n[:, 0]])
        return self.normal[:, None] * self.n - self.tangential[:, None] * t

    def between(self, bodies: Bodies) -> dict[tuple[str, str], tuple[float, float]]:
        """Force (x, y) on the first of two bodies by the second, for pairs in the bodies' order."""
        force, found = self.force, {}
        names = list(bodies)
        for i, one in enumerate(names):
            for other in names[i:]:
                there = self._pair(bodies[one], bodies[other])
                back = self._pair(bodies[other], bodies[one])
                if one == other:
                    back = np.zeros_like(there)
                if np.any(there | back):
                    x, y = force[there].sum(axis=0) - force[back].sum(axis=0)
                    found[one, other] = float(x), float(y)
        return found

    def pressing(self, bodies: Bodies) -> dict[tuple[str, str], float]:
        """Sum of normal forces between two bodies, for pairs in the bodies' order."""
        names, found = list(bodies), {}
        for i, one in enumerate(names):
            for other in names[i:]:
                both = self._pair(bodies[one], bodies[other])
                both |= self._pair(bodies[other], bodies[one])
                if both.any():
                    found[one, other] = float(self.normal[both].sum())
        return found

    def _pair(self, one: Indices, other: Indices) -> NDArray[np.bool_]:
        pair: NDArray[np.bool_] = np.isin(self.elements, one) & np.isin(self.partners, other)
        return pair

"""Contacts of a frame with itself or with an obstacle in one accepted state."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations_with_replacement

import numpy as np
from numpy.typing import NDArray

from fem.beam.section import Array, Bodies, Indices

OBSTACLE = -1


@dataclass(frozen=True)
class Record:
    """The k contacts of probed `elements` with their `partners` (-1: an obstacle).

    `at` (k, 2) is the point on the surface; `n` (k, 2) points from the partner to the element of
    the probe. The force on this element has the components `normal` (k,) along n and `tangential`
    (k,) along -t, where t is n rotated by -90°. `gap` (k,) is negative for overlap.
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
        """Largest overlap; 0 without overlap."""
        return max(0.0, -float(self.gap.min(initial=0.0)))

    @property
    def force(self) -> Array:
        """Forces (k, 2) on the elements of the probes."""
        t = np.column_stack([self.n[:, 1], -self.n[:, 0]])
        return self.normal[:, None] * self.n - self.tangential[:, None] * t

    def between(self, bodies: Bodies) -> dict[tuple[str, str], tuple[float, float]]:
        """For each pair of bodies in contact, the force (x, y) of the second body on the first.

        The names in a pair have the order of `bodies`.
        """
        force, found = self.force, {}
        for pair, there, back in self._pairs(bodies):
            if pair[0] == pair[1]:
                back[:] = False
            x, y = force[there].sum(axis=0) - force[back].sum(axis=0)
            found[pair] = float(x), float(y)
        return found

    def pressing(self, bodies: Bodies) -> dict[tuple[str, str], float]:
        """For each pair of bodies in contact, the sum of the normal forces.

        The names in a pair have the order of `bodies`.
        """
        return {
            pair: float(self.normal[there | back].sum())
            for pair, there, back in self._pairs(bodies)
        }

    def _pairs(
        self, bodies: Bodies
    ) -> Iterator[tuple[tuple[str, str], NDArray[np.bool_], NDArray[np.bool_]]]:
        """Pairs of bodies in contact, each with two masks (k,) of its contacts.

        In the first mask, the probes are on the first body of the pair; in the second mask, they
        are on the second body.
        """
        own = {name: np.isin(self.elements, body) for name, body in bodies.items()}
        their = {name: np.isin(self.partners, body) for name, body in bodies.items()}
        for one, other in combinations_with_replacement(bodies, 2):
            there, back = own[one] & their[other], own[other] & their[one]
            if np.any(there | back):
                yield (one, other), there, back

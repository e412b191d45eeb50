"""Results of the true model for evaluated crowns: maximum forces and pressures in engagements."""

from dataclasses import dataclass, replace

import numpy as np

from verify.core.figures import Array
from verify.studies.design_sprag.inputs import Contacts

SHARP = 3.0  # factor on the pressure of the strip at a loaded end


@dataclass(frozen=True, eq=False)
class Known:
    """Results of the true model for n crowns (n, 3) under m torques.

    `N_max` (n, m) [N] are the maximum normal forces; all pressures [Pa] are those under these
    forces. `slices` (n, m, slices) are the pressures of the slices of the clutch. `strips`
    contains, for each torque, the pressures (n, strips) on a half-space, with the number of strips
    that the contact requires.
    """

    crowns: Array
    N_max: Array
    slices: Array
    strips: tuple[Array, ...]

    def __len__(self) -> int:
        return len(self.crowns)

    def __getitem__(self, which: slice) -> "Known":
        return Known(self.crowns[which], self.N_max[which], self.slices[which],
                     tuple(p[which] for p in self.strips))  # fmt: skip

    def with_(self, more: "Known") -> "Known":
        """Results of this object followed by those of `more`, as one object."""
        return replace(
            self,
            crowns=np.vstack([self.crowns, more.crowns]),
            N_max=np.vstack([self.N_max, more.N_max]),
            slices=np.concatenate([self.slices, more.slices]),
            strips=tuple(np.vstack(pair) for pair in zip(self.strips, more.strips, strict=True)),
        )

    def along(self, contacts: Contacts, torque: int) -> Array:
        """Pressures (n, slices or strips) [Pa] along the sprag under torque number `torque`."""
        return self.strips[torque] if contacts == "strips" else self.slices[:, torque]

    def counted(self, contacts: Contacts, torque: int) -> Array:
        """Pressures [Pa] along the sprag, scaled at loaded ends for comparison in the search.

        On a half-space, the pressure at a loaded end increases without limit, with the inverse
        square root of the strip width. The search therefore scales the pressures of end strips from
        a width of b/3 to b/27, where b is the half-width of the contact. Pressures of slices are
        not scaled, as in the paper.
        """
        p = self.along(contacts, torque)
        if contacts == "slices":
            return p
        return np.column_stack([SHARP * p[:, 0], p[:, 1:-1], SHARP * p[:, -1]])

    def largest(self, contacts: Contacts) -> Array:
        """Largest pressures (n, m) [Pa], scaled as in `counted` for comparison in the search."""
        m = self.N_max.shape[1]
        return np.column_stack([self.counted(contacts, k).max(axis=1) for k in range(m)])

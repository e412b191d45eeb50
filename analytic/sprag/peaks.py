"""Largest pressures of crowned sprags under torques, in the end slice and in all other slices.

The slices of Eqs. 2-5 do not represent the end of a sprag well. Their optimal crown loads the ends.
At loaded ends, strips on a half-space have a pressure peak that increases with the number of
strips. Therefore, a crown for manufacture is evaluated by strips, and its ends must be unloaded. If
the contact ends inside the sprag, the last strip of the contact is partly unloaded and carries less
than the others. If the contact reaches the end of the sprag, the last strip carries more, and its
load increases without limit as strips become narrower.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from analytic.contact.checks import Array

# weight of the end strip: its force may be (2/3)^2 = 44 % of the largest one
END = 1.5

By = Literal["slices", "strips"]


@dataclass(frozen=True, eq=False)
class Peaks:
    """Peak forces and pressures of n crowns (n, 3) under m torques [N m], at inner contacts.

    `N_max` [N] has the shape (n, m). `pressure` [Pa] contains the pressures of all slices or strips
    under N_max from one end to the other, (n, m, slices).
    """

    crowns: Array
    torques: Array
    N_max: Array
    pressure: Array
    by: By = "slices"

    @property
    def largest(self) -> Array:
        """Largest pressure Pre_max [Pa] of Eq. 17, (n, m)."""
        return np.asarray(self.pressure.max(axis=-1))

    @property
    def regimes(self) -> tuple[Array, Array]:
        """Weighted pressure of the end slice, and largest pressure of other slices [Pa], (n, m).

        The surrogate interpolates both separately. For strips, the weight is END, so that crowns
        with loaded ends are avoided; for slices, it is 1.
        """
        return (END if self.by == "strips" else 1.0) * self.end, self.inside

    @property
    def objective(self) -> Array:
        """Objective to be minimised [Pa], (n, m): the larger of both `regimes`.

        It equals `largest` for slices, and for strips if the ends are unloaded.
        """
        return np.maximum(*self.regimes)

    @property
    def end(self) -> Array:
        """Pressure [Pa] of the first slice, at one end, (n, m); 0 if this end is unloaded."""
        return np.asarray(self.pressure[..., 0])

    @property
    def inside(self) -> Array:
        """Largest pressure [Pa] of all other slices, (n, m)."""
        return np.asarray(self.pressure[..., 1:-1].max(axis=-1))

    def of(self, torque: int) -> "Peaks":
        """Peaks under the torque with the index `torque`."""
        only = slice(torque, torque + 1)
        return Peaks(
            self.crowns, self.torques[only], self.N_max[:, only], self.pressure[:, only], self.by
        )

"""Largest pressures of crowns under torques, and the criterion of a design: its ends or the rest.

The slices of Eqs. 2-5 hardly represent the end of a sprag: their optimal crown loads the ends, for
which strips on a half-space have a pressure peak that increases with the number of strips. A crown
for manufacture is therefore evaluated by strips, with unloaded ends. If a contact ends before the
sprag, the last strip is partly unloaded and carries less than the others; if the contact reaches
the end, the last strip carries more, without limit as strips become narrower.
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
    """Peaks of n crowns (n, 3) under m torques [N m], at the inner contacts.

    `N_max` [N] (n, m), and under it the `pressure` [Pa] of each slice or strip from one end to the
    other, (n, m, slices).
    """

    crowns: Array
    torques: Array
    N_max: Array
    pressure: Array
    by: By = "slices"

    @property
    def largest(self) -> Array:
        """Pre_max [Pa] of Eq. 17, (n, m)."""
        return np.asarray(self.pressure.max(axis=-1))

    @property
    def regimes(self) -> tuple[Array, Array]:
        """Weighted pressures of the end and of the rest [Pa], each (n, m): regimes for a surrogate.

        A crown with loaded ends is not accepted by strips: see END.
        """
        return (END if self.by == "strips" else 1.0) * self.end, self.inside

    @property
    def objective(self) -> Array:
        """The larger regime [Pa], (n, m), to be minimised by a crown.

        Value of `largest` for slices, and for strips if the ends are unloaded.
        """
        return np.maximum(*self.regimes)

    @property
    def end(self) -> Array:
        """Pressure [Pa] of the first slice, at an end; 0 if the ends are unloaded, (n, m)."""
        return np.asarray(self.pressure[..., 0])

    @property
    def inside(self) -> Array:
        """Largest pressure [Pa] of all other slices, (n, m)."""
        return np.asarray(self.pressure[..., 1:-1].max(axis=-1))

    def of(self, torque: int) -> "Peaks":
        """Peaks under the torque with this number."""
        only = slice(torque, torque + 1)
        return Peaks(
            self.crowns, self.torques[only], self.N_max[:, only], self.pressure[:, only], self.by
        )

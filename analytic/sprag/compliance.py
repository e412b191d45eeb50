r"""Deflections of contacts, races and sprag under the normal force of one sprag (Eqs. 2 to 8).

H, the relative displacement of the normal forces, is the sum of five deflections; half of the
deflection of the sprag counts for each side:

.. math::
    H = \underbrace{\delta_{BI} + \delta_{HI} + \tfrac12\delta_g}_{\text{inner}}
      + \underbrace{\delta_{BE} + \delta_{HE} + \tfrac12\delta_g}_{\text{outer}}

H excludes the growth delta_ce of the outer race under rotation, which also exists without load.
"""

from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, not_negative
from analytic.sprag.laws import Law


@dataclass(frozen=True, kw_only=True, eq=False)
class Yields:
    """Deflections of contacts, races and sprag under N, and growth d_ce of the rotating bore [m].

    The paper denotes them by HI, HE (contacts), BI, BE (races) and g (sprag).
    """

    contact_i: Array
    contact_e: Array
    race_i: Array
    race_e: Array
    sprag: Array
    d_ce: Array

    @property
    def inner(self) -> Array:
        """Sum of deflections [m] from the middle of the sprag to the inner race."""
        return np.asarray(self.race_i + self.contact_i + self.sprag / 2)

    @property
    def outer(self) -> Array:
        """Sum of deflections [m] from the middle of the sprag to the outer race, without d_ce."""
        return np.asarray(self.race_e + self.contact_e + self.sprag / 2)

    @property
    def H(self) -> Array:
        """Sum of the five deflections [m] under load."""
        return np.asarray(self.inner + self.outer)


@dataclass(frozen=True, kw_only=True, eq=False)
class Compliance:
    """Contact laws (N to approach), compliances of races and sprag [m/N], bore growth d_ce [m]."""

    contact_i: Law
    contact_e: Law
    race_i: ArrayLike
    race_e: ArrayLike
    sprag: ArrayLike
    d_ce: ArrayLike = 0.0

    def __post_init__(self) -> None:
        for name in ("race_i", "race_e", "sprag"):
            not_negative(getattr(self, name), f"compliance of {name}", "m/N")
        not_negative(self.d_ce, "growth d_ce", "m")

    def yields(self, N: ArrayLike) -> Yields:
        """Deflections [m] under N [N]; nan if N is nan or beyond the range of a contact law."""
        N = np.asarray(N, dtype=np.float64)
        return Yields(
            contact_i=self.contact_i(N), contact_e=self.contact_e(N),
            race_i=np.asarray(N * self.race_i), race_e=np.asarray(N * self.race_e),
            sprag=np.asarray(N * self.sprag), d_ce=np.asarray(self.d_ce, dtype=np.float64),
        )  # fmt: skip

    def rigid_races(self) -> Self:
        """Compliance with races that have no ring deflection (Liu's model)."""
        return replace(self, race_i=0.0, race_e=0.0)

"""Sprag clutch for statics: geometry, number, compliance and centroid of its sprags."""

from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite
from analytic.freewheel.rules import rollers
from analytic.sprag.compliance import Compliance
from analytic.sprag.geometry import LogSprag


@dataclass(frozen=True, kw_only=True, eq=False)
class SpragClutch:
    """Sprag clutch with n_s sprags and their compliance.

    (c_x, c_y) [m] is the vector from the pole C_e to the centroid at first contact, with y along OB
    and x towards the side of A. With None, the centroid is midway between both contacts.
    """

    sprag: LogSprag
    n_s: int
    compliance: Compliance
    c_x: ArrayLike | None = None
    c_y: ArrayLike | None = None

    def __post_init__(self) -> None:
        rollers(self.n_s)
        finite(self.centroid[0], "centroid's c_x", "m")
        finite(self.centroid[1], "centroid's c_y", "m")

    @property
    def centroid(self) -> tuple[Array, Array]:
        """Coordinates c_x, c_y [m] of the centroid relative to the pole C_e at first contact."""
        sprag = self.sprag
        R_i, beta = np.asarray(sprag.R_i), sprag.beta_0
        x = R_i * np.sin(beta) / 2 if self.c_x is None else self.c_x
        y = (
            (R_i * np.cos(beta) + np.asarray(sprag.R_e)) / 2 - sprag.OC_e
            if self.c_y is None else self.c_y
        )  # fmt: skip
        return np.asarray(x, dtype=np.float64), np.asarray(y, dtype=np.float64)

    def rigid_races(self) -> Self:
        """Clutch whose races have no ring deflection (Liu's model)."""
        return replace(self, compliance=self.compliance.rigid_races())


Clutch = SpragClutch  # its name in version 0.1

"""A sprag clutch for statics: geometry, number and compliance of its sprags, their centroid."""

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
    """n_s sprags with their compliance.

    (c_x, c_y) [m] leads from the pole C_e to the centroid at first contact, y along OB and x to
    the side of A; None is the middle of both contacts.
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
        """c_x, c_y [m]."""
        sprag = self.sprag
        R_i, beta = np.asarray(sprag.R_i), sprag.beta_0
        x = R_i * np.sin(beta) / 2 if self.c_x is None else self.c_x
        y = (
            (R_i * np.cos(beta) + np.asarray(sprag.R_e)) / 2 - sprag.OC_e
            if self.c_y is None else self.c_y
        )  # fmt: skip
        return np.asarray(x, dtype=np.float64), np.asarray(y, dtype=np.float64)

    def rigid_races(self) -> Self:
        """Clutch with races without ring deflection (Liu's model)."""
        return replace(self, compliance=self.compliance.rigid_races())


Clutch = SpragClutch  # its name in version 0.1

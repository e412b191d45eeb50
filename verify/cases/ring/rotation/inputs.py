"""Inputs of a rotating race: an outer race at speed, and the sprags in it."""

import numpy as np
from pydantic import model_validator

from verify.core.inputs import Inputs, count, quantity

FASTEST = 0.05  # strain beyond which small-strain elasticity says nothing


class RotationInputs(Inputs):
    """An outer race at speed, and the sprags in it."""

    r_i: float = quantity(
        "19.44 mm", "mm", "R_e", "bore radius", gt=0, le=1e5, claims="huang2018:table1-r-e"
    )
    r_o: float = quantity(
        "26.23 mm", "mm", "R_ed", "outer radius", gt=0, le=1e5, claims="huang2018:table1-r-ed"
    )
    omega: float = quantity("3000 r/min", "r/min", "n", "speed (none is printed)", gt=0, le=1e7)
    rho: float = quantity("7850 kg/m^3", "kg/m^3", "ρ", "density (none is printed)", gt=0, le=1e5)
    E: float = quantity("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    n: int = count(
        12, "n_s", "number of sprags", ge=1, le=10_000, claims="huang2018:table1-number-of-sprags"
    )
    F: float = quantity(
        "3407 N", "N", "N_be", "force of a sprag (identified, not printed)", gt=0, le=1e9
    )
    L: float = quantity("9 mm", "mm", "l", "its length (identified, not printed)", gt=0, le=1e4)
    R_p: float | None = quantity(
        None, "MPa", "R_p", "yield strength, for the warning", omitted=None, gt=0,
        example="1200 MPa",
    )  # fmt: skip

    @model_validator(mode="after")
    def _ring(self) -> "RotationInputs":
        if not self.r_i < self.r_o:
            raise ValueError(
                f"a ring needs R_e < R_ed, got r_i = {self.r_i * 1e3:g} mm, "
                f"r_o = {self.r_o * 1e3:g} mm"
            )
        if self.r_o - self.r_i < 1e-3 * self.r_o:
            raise ValueError(
                f"a wall of {(self.r_o - self.r_i) * 1e3:g} mm is below a thousandth of r_o = "
                f"{self.r_o * 1e3:g} mm: a shell, not a thick ring"
            )
        strain = self.rho * (self.omega * self.r_o) ** 2 / self.E
        if strain > FASTEST:
            raise ValueError(
                f"{self.omega * 30 / np.pi:.6g} r/min strains the ring by {strain:.0%}: it flies "
                "apart, and small-strain elasticity says nothing"
            )
        return self

    @property
    def P(self) -> float:
        """Force of a sprag per length [N/m]."""
        return self.F / self.L

"""Inputs of a roller between two rigid flats."""

import math
from typing import Self

from pydantic import model_validator

from verify.case import Quantity, given
from verify.cases.contact.line.hertz import LineContact


def softness(E: float, nu: float) -> float:
    """Plane-strain compliance (1 - nu^2)/E [1/Pa]; E may be infinite."""
    return (1 - nu**2) / E


class FlatInputs(LineContact):
    """Inputs of a roller between two rigid flats."""

    R: float = given(
        "4.02 mm", "mm", "R", "radius of the roller", gt=0, le=1e5, claims="huang2018:table1-r-i1"
    )
    E: float = given("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    F: float = given("643 N", "N", "F", "normal load; 643 N gives a/R = 0.01", gt=0, le=1e9)

    @model_validator(mode="after")
    def _load(self) -> Self:
        self.check_load(f"R = {self.R * 1e3:g} mm")
        return self

    @Quantity("E*", "GPa", "contact modulus, plane strain", role="step", source="Hertz",
              tex=r"\frac{E}{1 - \nu^2}")  # fmt: skip
    def E_star(self) -> float:
        return self.E / (1 - self.nu**2)

    @property
    def relative(self) -> float:
        return self.R

    @property
    def radii(self) -> tuple[float, float]:
        return self.R, math.inf

    @property
    def softness(self) -> float:
        return softness(self.E, self.nu)

    @property
    def smallest(self) -> float:
        return self.R

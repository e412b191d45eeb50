"""Bodies of the line contacts: a roller between flats, and two bodies of their own materials."""

from typing import Self

from pydantic import model_validator

from analytic.contact import hertz_line
from verify.case import Quantity, given
from verify.cases.contact.line.hertz import HERTZ, LineContact


def softness(E: float, nu: float) -> float:
    """(1 - nu^2)/E [1/Pa], infinite E allowed."""
    return (1 - nu**2) / E


class FlatInputs(LineContact):
    """A roller between two rigid flats."""

    R: float = given(
        "4.02 mm", "mm", "R", "radius of the roller", gt=0, le=1e5, claims="huang2018:table1-r-i1"
    )
    E: float = given("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    F: float = given("643 N", "N", "F", "normal load, for a/R = 0.01", gt=0, le=1e9)

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
    def upper(self) -> float:
        return self.R

    @property
    def curvature(self) -> float:
        return 1 / self.R

    @property
    def softness(self) -> float:
        return softness(self.E, self.nu)

    @property
    def smallest(self) -> float:
        return self.R


class TwoBodies(LineContact):
    """Materials of two bodies in contact."""

    E_1: float = given("206 GPa", "GPa", "E_1", "Young's modulus, roller", gt=0, le=1e5)
    nu_1: float = given(0.3, "1", "ν_1", "Poisson's ratio, roller", ge=0, le=0.45)
    E_2: float = given("206 GPa", "GPa", "E_2", "Young's modulus, partner", gt=0, le=1e5)
    nu_2: float = given(0.3, "1", "ν_2", "Poisson's ratio, partner", ge=0, le=0.45)

    @Quantity("E*", "GPa", "contact modulus, plane strain", role="step", source="Hertz",
              tex=r"\frac{1}{\frac{1 - \nu_1^2}{E_1} + \frac{1 - \nu_2^2}{E_2}}")  # fmt: skip
    def E_star(self) -> float:
        return float(hertz_line.contact_modulus(**self.materials, assumption="plane strain"))

    @Quantity("a", "µm", "half-width, Hertz", source=HERTZ,
              tex=r"\sqrt{\frac{4 P R'}{\pi E*}}")  # fmt: skip
    def a(self) -> float:
        return float(hertz_line.half_width(P=self.P, R=self.relative, E_star=self.E_star))

    @property
    def softness(self) -> float:
        return softness(self.E_1, self.nu_1) + softness(self.E_2, self.nu_2)

    @property
    def materials(self) -> dict[str, float]:
        """Moduli and Poisson's ratios as the formulas name them."""
        return {"E_1": self.E_1, "nu_1": self.nu_1, "E_2": self.E_2, "nu_2": self.nu_2}

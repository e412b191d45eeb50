"""Inputs of a uniform shaft that rotates in short bearings at both ends."""

from typing import Self

from pydantic import model_validator

from analytic.rotor.cylinder import Cylinder
from analytic.rotor.shafts import Theory, UniformShaft, hutchinson
from verify.case import Case, Quantity, given

THEORIES: tuple[Theory, ...] = ("euler", "rayleigh", "timoshenko")
MODES = (1, 2, 3)
BEAMS = 4  # elements along the shaft, times the level
SLENDER = 0.03  # diameter over length of the shaft on which beams are accepted
RATIOS = (0.015, 0.03, 0.05, 0.09, 0.15)  # diameters over lengths towards the limit
STUBBY = 0.5  # diameter over length beyond which no beam theory is meant


class TurningShaft(Case):
    """A uniform shaft, solid or hollow, simply supported at both ends."""

    L: float = given(
        "600 mm", "mm", "L", "distance between the bearings (not printed)", gt=0, le=1e5
    )
    d_o: float = given("60 mm", "mm", "d_o", "outer diameter (not printed)", gt=0, le=1e5)
    d_i: float = given(
        "30 mm", "mm", "d_i", "bore diameter; 0 for a solid shaft", omitted=0.0, ge=0
    )
    n: float = given("10000 r/min", "r/min", "n", "speed of rotation", ge=0, le=1e7)
    rho: float = given("7850 kg/m^3", "kg/m^3", "ρ", "density (not printed)", gt=0, le=1e5)
    E: float = given("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)

    @model_validator(mode="after")
    def _shaft(self) -> Self:
        if not self.d_i < 0.98 * self.d_o:
            raise ValueError(
                f"d_i must be below 0.98 d_o, got d_i = {self.d_i * 1e3:g} mm, d_o = "
                f"{self.d_o * 1e3:g} mm"
            )
        if 0 < self.d_i < 0.05 * self.d_o:
            raise ValueError(
                f"d_i must be 0 or at least d_o/20, got d_i = {self.d_i * 1e3:g} mm, d_o = "
                f"{self.d_o * 1e3:g} mm: set d_i = 0 for a solid shaft"
            )
        if self.d_o > STUBBY * self.L:
            raise ValueError(
                f"d_o/L = {self.d_o / self.L:.2g} must not be above {STUBBY:g}: beam theory "
                "requires a slender shaft"
            )
        return self

    @Quantity("m", "1", "ratio of bore diameter to outer diameter", role="geometry")
    def m(self) -> float:
        return self.d_i / self.d_o

    def shaft(self, *, kappa: float | None = None, L: float | None = None) -> UniformShaft:
        """The shaft for closed forms; the default shear coefficient is Hutchinson's."""
        return UniformShaft(
            L=self.L if L is None else L, d_o=self.d_o, d_i=self.d_i, E=self.E, nu=self.nu,
            rho=self.rho, kappa=hutchinson(nu=self.nu, m=self.m) if kappa is None else kappa,
        )  # fmt: skip

    def cylinder(self) -> Cylinder:
        """The shaft as an elastic cylinder."""
        return Cylinder(
            r_o=self.d_o / 2, r_i=self.d_i / 2, E=self.E, nu=self.nu, rho=self.rho
        )  # fmt: skip

"""Inputs of races under evenly spaced sprags or rollers: outer race (bore), inner race (rim)."""

import math
from typing import ClassVar, Literal, Self

from pydantic import model_validator

from verify.case import Case, Quantity, count, given
from verify.cases.ring import walls

Wall = Literal["bore", "rim"]
WIDEST = 0.3  # half-width over the wall or the roller: beyond, no line contact
CLOSEST = 0.5  # half-width over half a pitch
FIT = 0.9  # largest share of the bore for a roller
THINNEST, THICKEST = 1.02, 10.0  # r_o/r_i that finite elements follow
NARROWEST = 1e-4  # half-width over the loaded radius, likewise
MOST = 200  # loads, likewise


class LoadsInputs(Case):
    """A ring under n rollers of its material; long bodies, so that Hertz is in plane strain."""

    loaded: ClassVar[Wall] = "bore"
    names: ClassVar[tuple[str, str]] = ("r_i", "r_o")  # in the paper

    r_i: float = given("19.44 mm", "mm", "r_i", "bore radius", gt=0, le=1e5)
    r_o: float = given("26.23 mm", "mm", "r_o", "outer radius", gt=0, le=1e5)
    n: int = count(
        12, "n", "number of sprags", ge=2, le=10_000, claims="huang2018:table1-number-of-sprags"
    )
    F: float = given("3407 N", "N", "N", "force of a sprag (identified, not printed)", gt=0, le=1e9)
    L: float = given("9 mm", "mm", "l", "its length (identified, not printed)", gt=0, le=1e4)
    R: float = given(
        "4.02 mm", "mm", "R", "radius of its contact", gt=0, le=1e5, claims="huang2018:table1-r-i1"
    )
    E: float = given("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    R_p: float | None = given(
        None, "MPa", "R_p", "yield strength, for the warnings", omitted=None, gt=0,
        example="2000 MPa",
    )  # fmt: skip

    @Quantity("P", "N/mm", "load per length", role="geometry")
    def P(self) -> float:
        return self.F / self.L

    @Quantity("r", "mm", "radius of the loaded wall", role="geometry")
    def radius(self) -> float:
        return self.r_i if self.loaded == "bore" else self.r_o

    @Quantity("d", "mm", "thickness of the wall", role="geometry")
    def wall(self) -> float:
        return self.r_o - self.r_i

    @property
    def half_width(self) -> float:
        """Half-width of Hertz's contact [m], used as the patch of the finite elements."""
        bend = 1 / self.R + (-1 if self.loaded == "bore" else 1) / self.radius
        return math.sqrt(8 * self.P * (1 - self.nu**2) / (math.pi * self.E * bend))

    def room_for(self, n: int) -> bool:
        """Whether n patches cover at most half of the wall."""
        return 2 * n * self.half_width <= math.pi * self.radius

    @model_validator(mode="after")
    def _fits(self) -> Self:
        walls.check_wall(self.r_i, self.r_o)
        wall = self.r_o - self.r_i
        if self.loaded == "bore" and FIT * self.r_i < self.R:
            raise ValueError(
                f"the roller must be smaller than {FIT} of the bore, got R = {self.R * 1e3:g} mm, "
                f"r_i = {self.r_i * 1e3:g} mm: a closer fit is no line contact"
            )
        a, least = self.half_width, min(wall, self.R)
        if a > WIDEST * least:
            raise ValueError(
                f"F = {self.F:g} N on L = {self.L * 1e3:g} mm: the half-width of the contact, "
                f"{a * 1e3:.3g} mm, exceeds {WIDEST:g} of the wall or the radius (a wall of "
                f"{wall * 1e3:g} mm, R = {self.R * 1e3:g} mm): no line contact"
            )
        pitch = math.pi * self.radius / self.n
        if a > CLOSEST * pitch:
            raise ValueError(
                f"n = {self.n} patches of half-width {a * 1e3:.3g} mm are too close on a wall with "
                f"{2 * pitch * 1e3:.3g} mm for each: a may be {CLOSEST:g} of half of that"
            )
        return self

    def refusal(self) -> str:
        """Why finite elements refuse these inputs, or nothing."""
        ratio, alpha = self.r_o / self.r_i, self.half_width / self.radius
        if not THINNEST <= ratio <= THICKEST:
            return (
                f"r_o/r_i = {ratio:.4g} lies outside {THINNEST:g} to {THICKEST:g}: too many cells, "
                "check it without --fem"
            )
        if self.n > MOST:
            return (
                f"n = {self.n} is more than {MOST}: too many cells in depth, check it without --fem"
            )
        if alpha < NARROWEST:
            return (
                f"a = {self.half_width * 1e3:.3g} mm is {alpha:.1g} of the race, less than "
                f"{NARROWEST:g}: finite elements lose too many digits there, check it without --fem"
            )
        return ""

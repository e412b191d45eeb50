"""Inputs of races under equally spaced sprags: outer race (bore), inner race (rim)."""

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
    """Inputs of a ring and n sprags of the same material; Hertz's contact is in plane strain."""

    loaded: ClassVar[Wall] = "bore"
    names: ClassVar[tuple[str, str]] = ("r_i", "r_o")  # in the paper

    r_i: float = given("19.44 mm", "mm", "r_i", "bore radius", gt=0, le=1e5)
    r_o: float = given("26.23 mm", "mm", "r_o", "outer radius", gt=0, le=1e5)
    n: int = count(
        12, "n", "number of sprags", ge=2, le=10_000, claims="huang2018:table1-number-of-sprags"
    )
    F: float = given("3407 N", "N", "N", "force of a sprag (identified, not printed)", gt=0, le=1e9)
    L: float = given(
        "9 mm", "mm", "l", "length of the sprags (identified, not printed)", gt=0, le=1e4
    )
    R: float = given(
        "4.02 mm",
        "mm",
        "R",
        "radius of curvature of the sprag at the contact",
        gt=0,
        le=1e5,
        claims="huang2018:table1-r-i1",
    )
    E: float = given("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    R_p: float | None = given(
        None, "MPa", "R_p", "yield strength", omitted=None, gt=0,
        example="2000 MPa",
    )  # fmt: skip

    @Quantity("P", "N/mm", "load per length", role="geometry")
    def P(self) -> float:
        return self.F / self.L

    @Quantity("r", "mm", "radius of the loaded surface", role="geometry")
    def radius(self) -> float:
        return self.r_i if self.loaded == "bore" else self.r_o

    @Quantity("d", "mm", "thickness of the wall", role="geometry")
    def wall(self) -> float:
        return self.r_o - self.r_i

    @property
    def half_width(self) -> float:
        """Half-width [m] of Hertz's contact, and of the loaded patch in the finite elements."""
        bend = 1 / self.R + (-1 if self.loaded == "bore" else 1) / self.radius
        return math.sqrt(8 * self.P * (1 - self.nu**2) / (math.pi * self.E * bend))

    def room_for(self, n: int) -> bool:
        """Whether n contact patches cover at most half of the loaded surface."""
        return 2 * n * self.half_width <= math.pi * self.radius

    @model_validator(mode="after")
    def _fits(self) -> Self:
        walls.check_wall(self.r_i, self.r_o)
        wall = self.r_o - self.r_i
        if self.loaded == "bore" and FIT * self.r_i < self.R:
            raise ValueError(
                f"R must not exceed {FIT} r_i, got R = {self.R * 1e3:g} mm, "
                f"r_i = {self.r_i * 1e3:g} mm: the contact of a closer fit is too wide; reduce R"
            )
        a, least = self.half_width, min(wall, self.R)
        if a > WIDEST * least:
            raise ValueError(
                f"F = {self.F:g} N on L = {self.L * 1e3:g} mm: the half-width of the contact, "
                f"{a * 1e3:.3g} mm, must not exceed {WIDEST:g} times the wall or the radius R "
                f"(wall {wall * 1e3:g} mm, R = {self.R * 1e3:g} mm): reduce F or increase L"
            )
        pitch = math.pi * self.radius / self.n
        if a > CLOSEST * pitch:
            raise ValueError(
                f"n = {self.n} patches of half-width {a * 1e3:.3g} mm are too close on the "
                f"wall (pitch {2 * pitch * 1e3:.3g} mm): the half-width must not exceed "
                f"{CLOSEST:g} times pitch/2; reduce n or F"
            )
        return self

    def refusal(self) -> str:
        """Reason for not solving these inputs with finite elements; "" if there is none."""
        ratio, alpha = self.r_o / self.r_i, self.half_width / self.radius
        if not THINNEST <= ratio <= THICKEST:
            return (
                f"r_o/r_i = {ratio:.4g} must be {THINNEST:g} to {THICKEST:g} for finite elements: "
                "otherwise, they need too many cells; run `check` without --fem"
            )
        if self.n > MOST:
            return f"n = {self.n} exceeds {MOST}: too many cells; run `check` without --fem"
        if alpha < NARROWEST:
            return (
                f"a = {self.half_width * 1e3:.3g} mm is {alpha:.1g} of the race radius; "
                f"finite elements require {NARROWEST:g} because of round-off: run `check` "
                "without --fem"
            )
        return ""

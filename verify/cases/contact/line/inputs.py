"""Inputs of the line contacts: a roller on a flat, on another roller, and in a race."""

import math

from pydantic import model_validator

from verify.core.inputs import Inputs, quantity

NARROWEST = 1e-4  # and down to which round-off leaves them sharp
WIDEST = 0.3  # a over the smallest radius up to which finite elements follow


class LineInputs(Inputs):
    """What the line contacts share: the load along a length; long bodies, so plane strain."""

    F: float = quantity("3407 N", "N", "F", "normal load", gt=0, le=1e9)
    L: float = quantity("9 mm", "mm", "L", "length of the contact", gt=0, le=1e4)
    R_p: float | None = quantity(
        None, "MPa", "R_p", "yield strength, for the warning", omitted=None, gt=0,
        example="2000 MPa",
    )  # fmt: skip

    @property
    def P(self) -> float:
        """Load per length [N/m]."""
        return self.F / self.L

    @property
    def curvature(self) -> float:
        """Relative curvature of the surfaces [1/m]."""
        raise NotImplementedError

    @property
    def softness(self) -> float:
        """Sum of (1 - nu^2)/E of the bodies [1/Pa]."""
        raise NotImplementedError

    @property
    def smallest(self) -> float:
        """The length that a is to be small against [m]."""
        raise NotImplementedError

    @property
    def smallest_name(self) -> str:
        """What that length is."""
        return "the roller's radius"

    @property
    def guess(self) -> float:
        """About the half-width [m]: the size of the finest cells, which decides no result."""
        return math.sqrt(4 * self.P * self.softness / (math.pi * self.curvature))


def softness(E: float, nu: float) -> float:
    """(1 - nu^2)/E [1/Pa], infinite E allowed."""
    return (1 - nu**2) / E


class FlatInputs(LineInputs):
    """A roller between two rigid flats."""

    R: float = quantity(
        "4.02 mm", "mm", "R", "radius of the roller", gt=0, le=1e5, claims="huang2018:table1-r-i1"
    )
    E: float = quantity("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    F: float = quantity("643 N", "N", "F", "normal load, for a/R = 0.01", gt=0, le=1e9)

    @property
    def curvature(self) -> float:
        return 1 / self.R

    @property
    def softness(self) -> float:
        return softness(self.E, self.nu)

    @property
    def smallest(self) -> float:
        return self.R

    @model_validator(mode="after")
    def _load(self) -> "FlatInputs":
        check_load(self, f"R = {self.R * 1e3:g} mm")
        return self


class TwoBodies(LineInputs):
    """Materials of two bodies in contact."""

    E_1: float = quantity("206 GPa", "GPa", "E_1", "Young's modulus, roller", gt=0, le=1e5)
    nu_1: float = quantity(0.3, "1", "ν_1", "Poisson's ratio, roller", ge=0, le=0.45)
    E_2: float = quantity("206 GPa", "GPa", "E_2", "Young's modulus, partner", gt=0, le=1e5)
    nu_2: float = quantity(0.3, "1", "ν_2", "Poisson's ratio, partner", ge=0, le=0.45)

    @property
    def softness(self) -> float:
        return softness(self.E_1, self.nu_1) + softness(self.E_2, self.nu_2)

    @property
    def materials(self) -> dict[str, float]:
        """Moduli and Poisson's ratios as the formulas name them."""
        return {"E_1": self.E_1, "nu_1": self.nu_1, "E_2": self.E_2, "nu_2": self.nu_2}


class PairInputs(TwoBodies):
    """Two rollers with parallel axes."""

    R_1: float = quantity(
        "4.02 mm", "mm", "R_1", "radius of the upper roller", gt=0, le=1e5,
        claims="huang2018:table1-r-i1",
    )  # fmt: skip
    R_2: float = quantity(
        "11.11 mm", "mm", "R_2", "radius of the lower roller or convex race", gt=0, le=1e5,
        claims="huang2018:table1-r-i",
    )  # fmt: skip

    @property
    def curvature(self) -> float:
        return 1 / self.R_1 + 1 / self.R_2

    @property
    def smallest(self) -> float:
        return min(self.R_1, self.R_2)

    @property
    def smallest_name(self) -> str:
        return "the upper roller's radius" if self.R_1 <= self.R_2 else "the lower roller's radius"

    @model_validator(mode="after")
    def _load(self) -> "PairInputs":
        if not 1e-3 <= self.R_1 / self.R_2 <= 1e3:
            raise ValueError(
                f"radii may differ by a factor of 1000, got R_1 = {self.R_1 * 1e3:g} mm, "
                f"R_2 = {self.R_2 * 1e3:g} mm: take contact-flat"
            )
        check_load(self, f"R_1 = {self.R_1 * 1e3:g} mm, R_2 = {self.R_2 * 1e3:g} mm")
        return self


class RaceInputs(TwoBodies):
    """A roller in a concave race whose rim is held."""

    R: float = quantity(
        "4.02 mm", "mm", "R", "radius of the roller", gt=0, le=1e5, claims="huang2018:table1-r-i1"
    )
    r_i: float = quantity(
        "19.44 mm", "mm", "r_i", "bore radius of the race", gt=0, le=1e5,
        claims="huang2018:table1-r-e",
    )  # fmt: skip
    r_o: float = quantity(
        "26.23 mm", "mm", "r_o", "outer radius of the race", gt=0, le=1e5,
        claims="huang2018:table1-r-ed",
    )  # fmt: skip

    @property
    def curvature(self) -> float:
        return 1 / self.R - 1 / self.r_i

    @property
    def smallest(self) -> float:
        return min(self.R, self.r_o - self.r_i)

    @property
    def smallest_name(self) -> str:
        return "the roller's radius" if self.smallest == self.R else "the race's wall"

    @model_validator(mode="after")
    def _fits(self) -> "RaceInputs":
        if self.R / self.r_i > 0.9:
            raise ValueError(
                f"the roller must be smaller than 0.9 of the bore, got R = {self.R * 1e3:g} mm, "
                f"r_i = {self.r_i * 1e3:g} mm: a closer fit is no line contact"
            )
        if not self.r_i < self.r_o:
            raise ValueError(
                f"a race needs r_i < r_o, got r_i = {self.r_i * 1e3:g} mm, "
                f"r_o = {self.r_o * 1e3:g} mm"
            )
        check_load(
            self, f"R = {self.R * 1e3:g} mm and a wall of {(self.r_o - self.r_i) * 1e3:g} mm"
        )
        return self


def too_small(q: LineInputs) -> str:
    """Contacts so narrow lose too many digits among the displacements of their bodies."""
    ratio = q.guess / q.smallest
    if ratio >= NARROWEST:
        return ""
    return (
        f"a = {q.guess * 1e3:.3g} mm is {ratio:.1g} of the bodies, less than {NARROWEST:g}: finite "
        "elements lose too many digits there, check it without --fem"
    )


def check_load(q: LineInputs, sizes: str) -> None:
    """ValueError where the contact would be as wide as the bodies."""
    if q.guess > WIDEST * q.smallest:
        raise ValueError(
            f"F = {q.F:g} N on L = {q.L * 1e3:g} mm flattens a = {q.guess * 1e3:.3g} mm, more than "
            f"{WIDEST:g} of the bodies ({sizes}): no line contact"
        )

"""Inputs of finite line contacts: a roller with or without crown or tilt, on a race."""

from math import pi, sqrt
from typing import NamedTuple

import numpy as np
from pydantic import model_validator

from analytic.contact.crown import logarithmic
from verify.case import Case, Quantity, count, given
from verify.core.figures import Array

WIDEST = 0.1  # largest half-width over the length of the roller
FEWEST, MOST = 41, 401  # strips
STRETCH = 20.0  # magnification across in pictures of the patch
FLATTEST = 50  # largest relative radius over the length of the roller


class Design(NamedTuple):
    """Parameters of a crown of Eq. 1; z_m [m]."""

    K_1: float
    K_2: float
    z_m: float

    def __format__(self, _: str) -> str:
        """Name of the design in texts, such as "(1, 0.7, 10 µm)"."""
        return f"({self.K_1:g}, {self.K_2:g}, {self.z_m * 1e6:g} µm)"

    def __str__(self) -> str:
        """Name of the design in keys of results, such as "1_0d7_10"."""
        return f"{self.K_1:g}_{self.K_2:g}_{self.z_m * 1e6:g}".replace(".", "d")


DESIGNS = tuple(Design(*one) for one in (  # that the paper prints
    (1, 0.7, 10e-6), (5, 0.7, 15e-6), (1, 0.4, 10e-6), (3, 0.4, 10e-6), (1, 0.5, 8e-6),
    (5, 0.5, 15e-6), (2.1507, 0.6763, 12.1e-6), (2.80, 0.7, 11.8e-6),
))  # fmt: skip


EVEN = {"Lundberg": "Lundberg's crown", "Johns": "Johns and Gohar's crown"}  # uniform pressure


def ending(name: str) -> str:
    """Suffix of keys of a crown for uniform pressure; empty for Lundberg's crown."""
    return "" if name == "Lundberg" else f"_{name}"


class Roller(Case):
    """Inputs of a roller without crown on a longer race."""

    F: float = given("3407 N", "N", "F", "normal load", gt=0, le=1e9)
    L: float = given("9 mm", "mm", "l", "length of the roller", gt=0, le=1e4)
    R_1: float = given(
        "4.02 mm", "mm", "R_1", "radius of the roller", gt=0, le=1e5,
        claims="huang2018:table1-r-i1",
    )  # fmt: skip
    R_2: float = given(
        "11.11 mm", "mm", "R_2", "radius of the race, negative for a bore", ge=-1e9, le=1e9,
        claims="huang2018:table1-r-i",
    )  # fmt: skip
    E_1: float = given("206 GPa", "GPa", "E_1", "Young's modulus, roller", gt=0, le=1e5)
    nu_1: float = given(0.3, "1", "ν_1", "Poisson's ratio, roller", ge=0, lt=0.5)
    E_2: float = given("206 GPa", "GPa", "E_2", "Young's modulus, race", gt=0, le=1e5)
    nu_2: float = given(0.3, "1", "ν_2", "Poisson's ratio, race", ge=0, lt=0.5)
    d: float = given(
        "0.5 mm", "mm", "d", "length of the end zone at each end of the roller", omitted=0.5e-3,
        gt=0, le=1e4,
    )  # fmt: skip

    @Quantity("R", "mm", "relative radius", role="geometry")
    def R(self) -> float:
        return 1 / (1 / self.R_1 + 1 / self.R_2)

    @Quantity("E*", "GPa", "contact modulus of half-spaces", role="geometry",
              source="2 E* is E' of Eq. 1")  # fmt: skip
    def E_star(self) -> float:
        return 1 / ((1 - self.nu_1**2) / self.E_1 + (1 - self.nu_2**2) / self.E_2)

    @Quantity("b", "mm", "Hertz's half-width of the uniform line load", role="geometry")
    def b(self) -> float:
        return sqrt(4 * self.F * self.R / (pi * self.E_star * self.L))

    def gap(self, y: Array) -> Array:
        """Gap z [m] between race and roller at y [m], unloaded."""
        return np.zeros_like(y)

    @model_validator(mode="after")
    def _sizes(self) -> "Roller":
        sizes = f"R_1 = {self.R_1 * 1e3:g} mm, R_2 = {self.R_2 * 1e3:g} mm"
        if -1.02 * self.R_1 < self.R_2 <= 0:
            raise ValueError(
                f"the roller must fit into the bore: R_2 must be positive (a shaft) or below "
                f"{-1.02e3 * self.R_1:g} mm, got {sizes}"
            )
        if self.R > FLATTEST * self.L:
            raise ValueError(
                f"{sizes} fit too closely for a line contact: the relative radius must not "
                "exceed 50 l"
            )
        if self.b > WIDEST * self.L:
            raise ValueError(
                f"F = {self.F:g} N: the half-width of the contact, {self.b * 1e3:.3g} mm, must not "
                f"exceed {WIDEST:g} times the length l = {self.L * 1e3:g} mm: reduce F"
            )
        if self.b > 0.3 * self.R_1:
            raise ValueError(
                f"F = {self.F:g} N: the half-width of the contact, {self.b * 1e3:.3g} mm, must not "
                f"exceed 0.3 times the radius of the roller R_1 = {self.R_1 * 1e3:g} mm: reduce F"
            )
        if self.d > self.L / 4:
            raise ValueError(
                f"the end zone d = {self.d * 1e3:g} mm must not exceed a quarter of "
                f"l = {self.L * 1e3:g} mm"
            )
        return self


class Divided(Roller):
    """Inputs of a roller that is divided into strips."""

    n: int = count(161, "n", "number of strips over the length", ge=FEWEST, le=MOST)


class Crown(Roller):
    """Inputs of a roller with the logarithmic crown of Eq. 1."""

    K_1: float = given(
        2.1507, "1", "K_1",
        "depth factor of the crown: load that gives uniform pressure, divided by Q", gt=0, le=100,
        claims="huang2018:optimum-25nm-k1",
    )  # fmt: skip
    K_2: float = given(
        0.6763, "1", "K_2", "fraction of the length that is crowned", gt=0, le=1,
        claims="huang2018:optimum-25nm-k2",
    )  # fmt: skip
    z_m: float = given(
        "0.0121 mm", "mm", "z_m", "drop of the crown at the ends", gt=0, le=1,
        claims="huang2018:optimum-25nm-zm",
    )  # fmt: skip
    Q: float = given("3407 N", "N", "Q", "load for which the crown is designed", gt=0, le=1e9)

    def gap(self, y: Array) -> Array:
        return logarithmic(
            y, K_1=self.K_1, K_2=self.K_2, z_m=self.z_m, load=self.Q, length=self.L,
            E_star=self.E_star,
        )  # fmt: skip


class Tilt(Crown):
    """Inputs of a crowned roller whose axis is not parallel to the race."""

    theta: float = given(
        "0.03 deg", "deg", "θ", "tilt of the roller; the end y = l/2 carries more load", ge=0, le=1
    )

    def gap(self, y: Array) -> Array:
        return super().gap(y) - self.theta * y

"""Inputs of a shaft with a thick part in the middle, in two short elastic bearings."""

from typing import Self

import numpy as np
from pydantic import model_validator

from verify.case import Case, Quantity, given

MODES = (1, 2, 3)
NEAR_ONE = (1.01, 1.02, 1.04, 1.07, 1.1)  # d_2/d_1 towards the shaft without a step
RATIOS = (1.1, 1.25, 1.5, 2.0, 2.5, 3.0)  # d_2/d_1 of the map
SHARES = (0.05, 0.1, 0.2, 0.35, 0.5, 0.7)  # L_2/L of the map


class SteppedShaft(Case):
    """A shaft of diameter d_1 with a thick part d_2, in two short elastic bearings at its ends."""

    L: float = given("500 mm", "mm", "L", "length of the shaft (not printed)", gt=0, le=1e5)
    d_1: float = given(
        "40 mm", "mm", "d_1", "diameter of the shaft outside the thick part (not printed)", gt=0,
        le=1e5,
    )  # fmt: skip
    d_2: float = given("80 mm", "mm", "d_2", "diameter of the thick part", gt=0, le=1e5)
    L_2: float = given("200 mm", "mm", "L_2", "length of the thick part", gt=0, le=1e5)
    a: float | None = given(
        None, "mm", "a", "start of the thick part; default: symmetric about the middle",
        omitted=None, gt=0,
        example="150 mm",
    )  # fmt: skip
    b: float = given("15 mm", "mm", "b", "width of each bearing, at the ends of the shaft", gt=0)
    k: float = given("2e5 N/mm", "N/mm", "k", "radial stiffness of a bearing", gt=0, le=1e9)
    n: float = given("6000 r/min", "r/min", "n", "speed of rotation", ge=0, le=1e7)
    rho: float = given("7850 kg/m^3", "kg/m^3", "ρ", "density (not printed)", gt=0, le=1e5)
    E: float = given("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)

    @model_validator(mode="after")
    def _shaft(self) -> Self:
        if not 1.001 * self.d_1 <= self.d_2 <= 5 * self.d_1:
            raise ValueError(
                f"d_2 must be between 1.001 d_1 and 5 d_1, got d_1 = {self.d_1 * 1e3:g} mm, d_2 = "
                f"{self.d_2 * 1e3:g} mm"
            )
        if 4 * self.d_1 > self.L:
            raise ValueError(
                "L must be at least 4 d_1, as beam theory requires a slender shaft, "
                f"got L = {self.L * 1e3:g} mm"
            )
        if 10 * self.b > self.L:
            raise ValueError(
                f"b must not exceed L/10, as bearings must be short, got b = {self.b * 1e3:g} mm"
            )
        if not self.b < min(self.start, self.L - self.start - self.L_2):
            raise ValueError(
                f"bearings of width b = {self.b * 1e3:g} mm do not fit beside the thick part, "
                f"where {self.start * 1e3:g} mm and {(self.L - self.start - self.L_2) * 1e3:g} mm "
                "are free"
            )
        return self

    @Quantity("m", "kg", "mass", role="geometry",
              tex=r"\frac{\pi}{4} \rho (d_1^2 (L - L_2) + d_2^2 L_2)")  # fmt: skip
    def mass(self) -> float:
        return sum(self.rho * np.pi / 4 * d**2 * length for length, d, _ in self.parts)

    @Quantity("I_p", "kg m^2", "polar moment of inertia", role="geometry",
              tex=r"\frac{\pi}{32} \rho (d_1^4 (L - L_2) + d_2^4 L_2)")  # fmt: skip
    def polar(self) -> float:
        return sum(self.rho * np.pi / 32 * d**4 * length for length, d, _ in self.parts)

    @Quantity("s_45", "mm", "distance from a step over which the 45° rule reduces the stiffness",
              source="45° rule", role="geometry")  # fmt: skip
    def reach(self) -> float:
        return min((self.d_2 - self.d_1) / 2, self.L_2 / 2)

    @Quantity("d_stiff", "mm", "diameter that determines the stiffness at the distance s_45",
              source="45° rule",
              role="geometry")  # fmt: skip
    def d_stiff(self) -> float:
        return min(self.d_2, self.d_1 + 2 * self.reach)

    @property
    def start(self) -> float:
        """Start of the thick part [m]."""
        return (self.L - self.L_2) / 2 if self.a is None else self.a

    @property
    def end(self) -> float:
        """End of the thick part [m]."""
        return self.start + self.L_2

    @property
    def parts(self) -> tuple[tuple[float, float, float], ...]:
        """Length, diameter and bore of each part [m], in axial order."""
        rest = self.L - self.start - self.L_2
        return ((self.start, self.d_1, 0.0), (self.L_2, self.d_2, 0.0), (rest, self.d_1, 0.0))

    @property
    def seats(self) -> tuple[float, float]:
        """Axial positions of the middles of the bearings [m]."""
        return self.b / 2, self.L - self.b / 2

    def with_middle(self, ratio: float, share: float) -> Self:
        """The shaft with a thick part in its middle, of given ratios d_2/d_1 and L_2/L."""
        return self.model_copy(update={"d_2": ratio * self.d_1, "L_2": share * self.L, "a": None})

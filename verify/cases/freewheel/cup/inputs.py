"""Inputs of a drawn-cup roller clutch, and the synthetic one that stands for it.

The paper prints no outer cam. Real drawn cups are thin and sit in a housing that bears them: the
rim's radius is the housing's, taken for one body with the cup.
"""

import math

from pydantic import model_validator

from analytic.freewheel.geometry import OuterCam
from verify.core.inputs import Inputs, count, quantity

LARGEST_ANGLE = math.radians(15)


class CupInputs(Inputs):
    """z rollers between a shaft and the flats of a cup, under a torque."""

    R_s: float = quantity("10 mm", "mm", "R_s", "radius of the shaft", gt=1e-3, le=1e5)
    r: float = quantity("2 mm", "mm", "r", "radius of the rollers", gt=1e-4, le=1e5)
    X_o: float = quantity("13.910554 mm", "mm", "X_o", "distance of the cup's flats from the axis",
                          gt=1e-3, le=1e5)  # fmt: skip
    R_a: float = quantity("30 mm", "mm", "R_a", "outer radius of the cup in its housing", gt=1e-3,
                          le=1e5)  # fmt: skip
    r_b: float = quantity("4 mm", "mm", "r_b", "bore radius of the shaft, free", gt=1e-4, le=1e5)
    z: int = count(8, "z", "number of rollers", ge=3, le=100)
    L: float = quantity("10 mm", "mm", "L", "length of the rollers", gt=1e-3, le=1e6)
    T: float = quantity("18 N m", "N m", "T", "torque in the locking direction", gt=0, le=1e9)
    E: float = quantity("206 GPa", "GPa", "E", "Young's modulus of all parts", gt=0, le=1e5)
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)

    @model_validator(mode="after")
    def _fits(self) -> "CupInputs":
        if not self.r_b < self.R_s:
            raise ValueError(
                f"the shaft needs a wall: r_b < R_s, got r_b = {self.r_b * 1e3:g} mm, "
                f"R_s = {self.R_s * 1e3:g} mm"
            )
        if not self.corner < self.R_a:
            raise ValueError(
                f"the cup needs a wall at its corners: X_o/cos(π/z) < R_a, got "
                f"{self.corner * 1e3:.6g} mm, R_a = {self.R_a * 1e3:g} mm"
            )
        if self.cam.alpha0 > LARGEST_ANGLE:
            raise ValueError(
                f"α_0 = {math.degrees(float(self.cam.alpha0)):.4g}° is beyond friction; rollers "
                f"hold below some {math.degrees(LARGEST_ANGLE):g}°: X_o is too small for R_s and r"
            )
        return self

    @property
    def sense(self) -> int:
        """-1: load narrows the angle."""
        return -1

    @property
    def race(self) -> float:
        """Radius [m] of the round race."""
        return self.R_s

    @property
    def flat(self) -> float:
        """Distance [m] of the flats from the axis."""
        return self.X_o

    @property
    def corner(self) -> float:
        """Distance [m] of the cup's corners from the axis."""
        return self.X_o / math.cos(math.pi / self.z)

    @property
    def cam(self) -> OuterCam:
        """The clutch's wedges; ValueError where there are none."""
        return OuterCam(R_s=self.R_s, r=self.r, X_o=self.X_o, z=self.z)

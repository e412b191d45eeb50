"""Inputs of a roller freewheel with a flat star, and the synthetic clutch that stands for it.

The paper prints no dimensions of its two clutches; 5 µm of X turn the clamping angle by 0.08 deg,
so that none can be guessed.
"""

import math
import re

from pydantic import model_validator

from analytic.freewheel.geometry import InnerCam
from verify.core.inputs import Inputs, count, quantity

THINNEST = 0.02  # wall of the ring over its bore's radius
LARGEST_ANGLE = math.radians(15)


def in_millimetres(rule: str) -> str:
    """A rule of the formulas with its lengths in mm."""
    return re.sub(r"=(\S+) m\b", lambda m: f" = {float(m[1]) * 1e3:.7g} mm", rule)


class StarInputs(Inputs):
    """z rollers between the flats of a star and the bore of a ring, under a torque."""

    R: float = quantity("16.5 mm", "mm", "R", "bore radius of the outer ring", gt=1e-3, le=1e5)
    r: float = quantity("2.5 mm", "mm", "r", "radius of the rollers", gt=1e-4, le=1e5)
    X: float = quantity("11.39565 mm", "mm", "X", "distance of the star's flats from the axis",
                        gt=1e-4, le=1e5)  # fmt: skip
    R_a: float = quantity("21 mm", "mm", "R_a", "outer radius of the outer ring", gt=1e-3, le=1e5)
    r_b: float = quantity("7.5 mm", "mm", "r_b", "bore radius of the star, on its shaft", gt=1e-4,
                          le=1e5)  # fmt: skip
    z: int = count(8, "z", "number of rollers", ge=3, le=100)
    L: float = quantity("10 mm", "mm", "L", "length of the rollers", gt=1e-3, le=1e6)
    T: float = quantity("26 N m", "N m", "T", "torque in the locking direction", gt=0, le=1e9,
                        claims="nagler2021:rig-torque")  # fmt: skip
    E: float = quantity("206 GPa", "GPa", "E", "Young's modulus of all parts", gt=0, le=1e5)
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)

    @model_validator(mode="after")
    def _fits(self) -> "StarInputs":
        for low, high, rule in (
            ("r_b", "X", "the star needs a wall"), ("R", "R_a", "the ring needs a wall"),
        ):  # fmt: skip
            inner, outer = getattr(self, low), getattr(self, high)
            if not inner < outer:
                raise ValueError(
                    f"{rule}: {low} < {high}, got {low} = {inner * 1e3:g} mm, "
                    f"{high} = {outer * 1e3:g} mm"
                )
        try:
            _ = self.cam
        except ValueError as error:
            raise ValueError(in_millimetres(str(error))) from error
        if self.cam.alpha0 > LARGEST_ANGLE:
            raise ValueError(
                f"α_0 = {math.degrees(float(self.cam.alpha0)):.4g}° is beyond friction; rollers "
                f"hold below some {math.degrees(LARGEST_ANGLE):g}°: X is too small for R and r"
            )
        return self

    @property
    def sense(self) -> int:
        """+1: load widens the angle."""
        return 1

    @property
    def race(self) -> float:
        """Radius [m] of the round race."""
        return self.R

    @property
    def flat(self) -> float:
        """Distance [m] of the flats from the axis."""
        return self.X

    @property
    def cam(self) -> InnerCam:
        """The clutch's wedges; ValueError where there are none."""
        return InnerCam(R=self.R, r=self.r, X=self.X, z=self.z)

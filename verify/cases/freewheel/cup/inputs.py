"""Inputs and states of a drawn-cup roller clutch; the default clutch is synthetic.

The paper prints no outer cam. Real drawn cups are thin and are supported by a housing: cup and
housing are modelled as one body with the housing's radius. The roller of an outer cam moves
towards psi = 0: alpha decreases, and the torque z R_s N tan(alpha) has a maximum before the
rollers pop through.
"""

import math
from typing import Self

import numpy as np
from pydantic import model_validator

from analytic.freewheel.geometry import OuterCam
from analytic.freewheel.state import RollerClutchState, at_angle, at_normal_force, loaded
from analytic.freewheel.summit import summit
from verify.case import count, given, shared
from verify.cases.freewheel.star import LARGEST_ANGLE, Rollers

GIVEN = 0.25  # overlap at the given angle over the overlap at pop-through


class Cup(Rollers):
    """z rollers between a shaft and the flats of a cup, under a torque."""

    R_s: float = given("10 mm", "mm", "R_s", "radius of the shaft", gt=1e-3, le=1e5)
    r: float = given("2 mm", "mm", "r", "radius of the rollers", gt=1e-4, le=1e5)
    X_o: float = given("13.910554 mm", "mm", "X_o", "distance of the cup's flats from the axis",
                       gt=1e-3, le=1e5)  # fmt: skip
    R_a: float = given("30 mm", "mm", "R_a", "outer radius of the housing around the cup", gt=1e-3,
                       le=1e5)  # fmt: skip
    r_b: float = given(
        "4 mm", "mm", "r_b", "bore radius of the shaft, whose bore is free", gt=1e-4, le=1e5
    )
    z: int = count(8, "z", "number of rollers", ge=3, le=100)
    L: float = given("10 mm", "mm", "L", "length of the rollers", gt=1e-3, le=1e6)
    T: float = given("18 N m", "N m", "T", "torque in the locking direction", gt=0, le=1e9)
    E: float = given("206 GPa", "GPa", "E", "Young's modulus of all parts", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)

    @model_validator(mode="after")
    def _fits(self) -> Self:
        if not self.r_b < self.R_s:
            raise ValueError(
                f"the shaft must have a wall: r_b must be below R_s, got r_b = {self.r_b * 1e3:g} "
                f"mm, R_s = {self.R_s * 1e3:g} mm"
            )
        if not self.corner < self.R_a:
            raise ValueError(
                "the cup must have a wall at its corners: X_o/cos(π/z) must be below R_a, got "
                f"X_o/cos(π/z) = {self.corner * 1e3:.6g} mm, R_a = {self.R_a * 1e3:g} mm"
            )
        if self.cam.alpha0 > LARGEST_ANGLE:
            raise ValueError(
                f"α_0 = {math.degrees(float(self.cam.alpha0)):.4g}° is too large: friction holds "
                f"rollers only below about {math.degrees(LARGEST_ANGLE):g}°; increase X_o, or "
                "reduce R_s or r"
            )
        return self

    # common to sectors of stars and cups: see `verify.cases.freewheel.bodies`
    @property
    def sense(self) -> int:
        """-1: load reduces the angle."""
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
        """The cam; raises ValueError if rollers and races form no wedge."""
        return OuterCam(R_s=self.R_s, r=self.r, X_o=self.X_o, z=self.z)

    @shared
    def state(self) -> RollerClutchState:
        """State under the load named by `load`; raises ValueError if no equilibrium exists."""
        if self.load == "N_0":
            return at_normal_force(self.clutch, self.rigid_force)
        if self.load == "ψ":
            return at_angle(self.clutch, self.given_angle)
        top = self.at_summit
        under = loaded(self.clutch, self.T)
        if not np.isfinite(under.N):
            raise ValueError(
                f"T = {self.T:g} N m exceeds the largest torque {float(top.T):.5g} N m: beyond "
                "this torque the rollers pop through between shaft and cup; reduce T"
            )
        return under

    @shared
    def at_summit(self) -> RollerClutchState:
        """State at the largest torque; raises ValueError if the formulas do not reach it."""
        if (found := summit(self.clutch)) is None:
            raise ValueError(
                "contacts are wider than half the roller radius before the torque reaches its "
                f"maximum: α_0 = {np.degrees(float(self.cam.alpha0)):.4g}° is too large for these "
                "formulas; increase X_o, or reduce R_s or r"
            )
        return found

    @property
    def given_angle(self) -> float:
        """Angle psi [rad] at which d_i + d_o is `GIVEN` times its value at pop-through."""
        d = GIVEN * float(self.cam.pop_through) / 2
        return float(2 * self.cam.alpha(d_i=d, d_o=d))

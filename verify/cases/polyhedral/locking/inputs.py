"""Inputs of a ring that is locked against its rollers."""

import math
from typing import Self

import numpy as np
from pydantic import model_validator

from verify.case import given
from verify.cases.polyhedral.inputs import HubRing


class LockingInputs(HubRing):
    """Inputs of a ring under pressure and hub force, between rollers above its flats."""

    d: float = given("10 mm", "mm", "d", "diameter of the rollers", gt=0, le=1e5)
    p_t: float = given("30 MPa", "MPa", "p_t", "pressure in the bore", gt=0, le=1e4)

    @property
    def push(self) -> tuple[float, float]:
        """Hub force on a flat [N/m]: normal; along the flat, positive away from its middle."""
        normal = self.R_b / np.hypot(1, self.tan_phi)
        return float(normal), float(-normal * self.tan_phi)

    @model_validator(mode="after")
    def _rollers(self) -> Self:
        sine = math.sin(self.half_angle)
        room = (self.d_e + self.j_D) * sine / (1 - sine)
        if self.d >= room:
            raise ValueError(
                f"neighbouring rollers overlap: d must be below {room * 1e3:.6g} mm for "
                f"z = {self.z} and d_e = {self.d_e * 1e3:g} mm, got {self.d * 1e3:g} mm"
            )
        return self

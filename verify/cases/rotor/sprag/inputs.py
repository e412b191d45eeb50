"""Inputs of the sprag clutch - rotor system: printed values, and ranges for missing values."""

from typing import Self

import numpy as np
from pydantic import model_validator

from verify.case import Case, count, given
from verify.core.figures import Array

RPM = np.pi / 30
PRINTED = (10149 * RPM, 32298 * RPM, 36245 * RPM)  # rad/s: the paper's critical speeds 1, 3, 5
MOST = 256
SLOWEST, FASTEST = 2000 * RPM, 60_000 * RPM  # range of speeds of a response


class SpragRotorInputs(Case):
    """Loads, damping and size of the ensemble; the layout is that of the paper."""

    speed: float = given(
        "5000 r/min", "r/min", "n", "speed at which the natural frequencies are computed",
        ge=0, le=40_000, claims="huang2022:comparison-speed",
    )  # fmt: skip
    members: int = count(48, "N", "required number of fitted sets of parameters", ge=8, le=MOST)
    zeta_low: float = given(
        "0.5 %", "%", "ζ_min", "lower limit of the damping ratios at critical speeds 1 and 5 "
        "(not printed)",
        ge=0.05, le=20,
    )  # fmt: skip
    zeta_high: float = given(
        "3 %",
        "%",
        "ζ_max",
        "upper limit of the damping ratios at critical speeds 1 and 5 (not printed)",
        ge=0.05,
        le=20,
    )
    U_1: float = given(
        "1.4e-5 kg m", "kg m", "U_1", "unbalance 1, at node 4", gt=0, le=1,
        claims="huang2022:unbalance-1",
    )  # fmt: skip
    U_2: float = given(
        "1e-5 kg m", "kg m", "U_2", "unbalance 2, at node 19, lowest of three values", gt=0, le=1,
        claims="huang2022:unbalance-2-low",
    )  # fmt: skip
    U_2_middle: float = given(
        "3e-5 kg m", "kg m", "U_2", "unbalance 2, at node 19, middle of three values", gt=0, le=1,
        claims="huang2022:unbalance-2-middle",
    )  # fmt: skip
    U_2_high: float = given(
        "5e-5 kg m", "kg m", "U_2", "unbalance 2, at node 19, highest of three values", gt=0, le=1,
        claims="huang2022:unbalance-2-high",
    )  # fmt: skip
    rig_speed: float = given(
        "7000 r/min", "r/min", "n_r", "speed at which orbits are computed", ge=2000, le=60_000,
        claims="huang2022:orbit-speed",
    )  # fmt: skip
    u_rig_1: float = given(
        "7e-5 kg m", "kg m", "U_1", "unbalance of the test rig at node 4", gt=0, le=1,
        claims="huang2022:rig-unbalance-1",
    )  # fmt: skip
    u_rig_2: float = given(
        "6e-5 kg m", "kg m", "U_2", "unbalance of the test rig at node 19", gt=0, le=1,
        claims="huang2022:rig-unbalance-2",
    )  # fmt: skip
    T: float = given(
        "15 N m", "N m", "T", "torque that preloads the clutch", gt=0, le=1e5,
        claims="huang2022:orbit-torque",
    )  # fmt: skip
    offset: float = given(
        0.2, "1", "Δx/δ_0", "ratio of the static offset of the clutch's rings to the deflection of "
                            "a sprag (not printed)", ge=0.001, le=0.9,
    )  # fmt: skip
    anisotropy: float = given(
        0.2, "1", "k_y/k_x − 1", "relative excess of the stiffness along y over the stiffness "
                                 "along x, bearings to the ground (not printed)", ge=0, le=2,
    )  # fmt: skip

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if self.zeta_low > self.zeta_high:
            raise ValueError(
                f"zeta_low must not exceed zeta_high, got {self.zeta_low:.3%} and "
                f"{self.zeta_high:.3%}"
            )
        if not self.U_2 < self.U_2_middle < self.U_2_high:
            raise ValueError(
                f"the three values of unbalance 2 must be in ascending order, got {self.U_2:g}, "
                f"{self.U_2_middle:g} and {self.U_2_high:g} kg m"
            )
        return self

    @property
    def unbalances_2(self) -> Array:
        """Unbalance 2 (3,) [kg m], ascending."""
        return np.array([self.U_2, self.U_2_middle, self.U_2_high])

"""Inputs of a sprag clutch between two rotors: sprags, deflections, torque, and uneven states.

The paper states only the torque of its test rig. Radii and number of sprags are those that the
same authors print for their clutch of 2018; wedge angle and length are those identified for that
clutch.
"""

import math
from typing import Self

from pydantic import model_validator

from analytic.contact import palmgren
from analytic.rotor.clutch import LINE_CONTACT, Array, SpragCoupling, even_angles
from verify.case import Case, Quantity, count, given

REFERENCE = 1000.0  # N, at which deflections are given
SLICES = 41  # slices of a sprag; the paper states no number


class SpragLink(Case):
    """Z sprags between two races under a torque, without offset or crown; no sprag is missing."""

    T: float = given("15 N m", "N m", "T", "torque that preloads the sprags", gt=0, le=1e9,
                        claims="huang2022:orbit-torque")  # fmt: skip
    Z: int = count(12, "Z", "number of sprags", ge=3, le=200,
                   claims="huang2018:table1-number-of-sprags")  # fmt: skip
    R_i: float = given("11.11 mm", "mm", "R_i", "radius of the inner race", gt=0.1, le=1e5,
                          claims="huang2018:table1-r-i")  # fmt: skip
    R_e: float = given("19.44 mm", "mm", "R_e", "bore radius of the outer race", gt=0.1, le=1e5,
                          claims="huang2018:table1-r-e")  # fmt: skip
    nu: float = given("3.15 deg", "deg", "ν", "wedge angle at the inner race (not printed)",
                         ge=0.1, le=20)  # fmt: skip
    L: float = given("9 mm", "mm", "L_we", "length of the sprags (not printed)", gt=0.01, le=1e5)
    n_s: int = count(SLICES, "n_s", "number of slices of a sprag (not printed)", ge=2, le=1000)
    a: float | None = given(None, "µm", "a", "sum of the deflections of both contacts of a "
                               "sprag under 1 kN; default: Palmgren's formula for steel",
                               omitted=None, gt=0, le=1e4, example="6.6 µm")  # fmt: skip
    e: float = given("1 µm", "µm", "Δx", "static offset of the inner race along x in the "
                     "states with offset", gt=0, le=1e4)  # fmt: skip
    drop: float = given("1 µm", "µm", "L(L_we/2)", "drop of the parabolic crown at the ends "
                        "of a sprag in the states with crown", ge=0, le=1e4)  # fmt: skip
    missing: int = count(1, "m", "number of adjacent sprags that are missing in the states with "
                         "sprags missing",
                         ge=1, le=197)  # fmt: skip

    @model_validator(mode="after")
    def _clutch(self) -> Self:
        if not self.R_i < self.R_e:
            raise ValueError(
                "R_i must be below R_e, to leave room for sprags between the races, got R_i = "
                f"{self.R_i * 1e3:g} mm, R_e = {self.R_e * 1e3:g} mm"
            )
        if self.missing > self.Z - 3:
            raise ValueError(
                f"at least three sprags must remain: m may be at most Z - 3 = {self.Z - 3}, got m "
                f"= {self.missing}"
            )
        return self

    @property
    def k_n(self) -> float:
        """Constant of a sprag [N/m^(10/9)] (Eq. 2): force over deflection to the power 10/9."""
        return float(REFERENCE / self.yield_1kN**LINE_CONTACT)

    @Quantity("δ_kN", "µm", "sum of the deflections of both contacts of a sprag under 1 kN",
              role="step", source="Palmgren's formula, or the input a")  # fmt: skip
    def yield_1kN(self) -> float:
        both = 2 * float(palmgren.approach(load=REFERENCE, length=self.L))
        return both if self.a is None else self.a

    @Quantity("d_t", "mm", "ratio of the deflection of a sprag (sum of both contacts) to the angle "
                          "of twist",
              source="Eq. 4", role="step", tex=r"R_i \tan\left(\nu\right)")  # fmt: skip
    def d_t(self) -> float:
        return self.R_i * math.tan(self.nu)

    def crown(self, x: Array) -> Array:
        """Drop of the crown of a contact [m] at the distance x [m] from the middle."""
        return self.drop * (2 * x / self.L) ** 2

    def gap(self) -> tuple[int, ...]:
        """Indices of the missing sprags, which are symmetric to the x-axis."""
        return tuple(range(self.missing))

    def angles(self, *, uneven: bool = False) -> Array:
        """Angles of the sprags [rad]; missing sprags are symmetric to the x-axis."""
        first = -(self.missing - 1) * math.pi / self.Z
        return even_angles(Z=self.Z, psi_0=first, missing=self.gap() if uneven else ())

    def clutch(
        self, *, crowned: bool = False, gap: bool = False, n_s: int | None = None
    ) -> SpragCoupling:
        """Clutch of the formulas, with a crown or missing sprags where requested."""
        return SpragCoupling(
            psi=self.angles(uneven=gap), R_i=self.R_i, nu=self.nu, L=self.L, k_n=self.k_n,
            n_s=n_s or self.n_s, crown=self.crown if crowned else None,
        )  # fmt: skip

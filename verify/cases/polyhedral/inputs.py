"""Inputs of the polyhedral ring clutch; default values are assumed, as the paper prints none.

`d_i` is the diameter of the circle that touches the fillets in the corners of the bore.
"""

import math
from typing import Self

from pydantic import model_validator

from verify.case import Case, Quantity, count, given

THINNEST = 0.005  # wall over outer diameter: below, a shell
OUTERMOST = 0.95  # outermost position of the hub's contact over half a flat
LEAST_FLAT = 0.05  # least flat part of a side of the unfilleted bore


class RoundRing(Case):
    """Inputs of a round elastic ring inside rollers, under pressure in its bore."""

    d_e: float = given("80 mm", "mm", "d_e", "outer diameter of the ring", gt=0, le=1e5)
    delta_1: float = given(
        "4 mm", "mm", "δ_1", "wall thickness of the ring (polygonal ring: in its corners)", gt=0,
        le=1e5,
    )  # fmt: skip
    j_D: float = given(
        "0.06 mm", "mm", "j_D", "diametral clearance that the ring closes", gt=0, le=1e3
    )
    E: float = given("210 GPa", "GPa", "E", "Young's modulus of the ring", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio of the ring", ge=0, le=0.45)
    R_p: float | None = given(
        None, "MPa", "R_p", "yield strength of the ring", omitted=None, gt=0,
        example="900 MPa",
    )  # fmt: skip

    @Quantity("d_i", "mm", "diameter of the bore through its corners", role="geometry")
    def d_i(self) -> float:
        return self.d_e - 2 * self.delta_1

    @property
    def d_m(self) -> float:
        """Mean diameter [m]."""
        return self.d_e - self.delta_1

    @property
    def straining(self) -> float:
        """Mean hoop strain that closes the clearance."""
        return self.j_D / self.d_m

    @model_validator(mode="after")
    def _wall(self) -> Self:
        sizes = f"d_e = {self.d_e * 1e3:g} mm, δ_1 = {self.delta_1 * 1e3:g} mm"
        if self.d_i <= 0.02 * self.d_e:
            raise ValueError(
                f"the wall leaves no bore: δ_1 must be below 0.49 d_e = {490 * self.d_e:g} mm, "
                f"got {sizes}"
            )
        if self.delta_1 < THINNEST * self.d_e:
            raise ValueError(
                f"the wall is too thin: δ_1 must be at least {THINNEST:g} d_e = "
                f"{THINNEST * self.d_e * 1e3:g} mm, got {sizes}"
            )
        if self.j_D > 0.02 * self.d_e:
            raise ValueError(
                f"j_D = {self.j_D * 1e3:g} mm strains the ring by {self.straining:.1%}, beyond "
                f"the elastic limit: j_D must not exceed 0.02 d_e = {20 * self.d_e:g} mm"
            )
        return self


class PolygonRing(RoundRing):
    """Inputs of a ring whose bore is a regular polygon with filleted corners."""

    z: int = count(6, "z", "number of rollers and of flats of the bore", ge=3, le=48)
    rho: float = given("2 mm", "mm", "ρ", "fillet radius of the corners of the bore", gt=0, le=1e4)

    @property
    def half_angle(self) -> float:
        """Half of the angle between rollers, pi/z [rad]."""
        return math.pi / self.z

    @property
    def unfilleted(self) -> float:
        """Distance [m] of the corners from the axis if the bore had no fillets."""
        return self.d_i / 2 + self.rho * (1 / math.cos(self.half_angle) - 1)

    @property
    def apothem(self) -> float:
        """Distance of the flats from the axis [m]."""
        return self.unfilleted * math.cos(self.half_angle)

    @property
    def half_flat(self) -> float:
        """Length of a flat from its middle to its fillet [m]."""
        return (self.d_i / 2 - self.rho) * math.sin(self.half_angle)

    @model_validator(mode="after")
    def _flats(self) -> Self:
        largest = self.d_i / 2 * (1 - LEAST_FLAT)
        if self.rho > largest:
            raise ValueError(
                f"the fillets leave no flat: ρ must be at most {largest * 1e3:.4g} mm for "
                f"d_i = {self.d_i * 1e3:g} mm, got {self.rho * 1e3:g} mm"
            )
        return self


class HubRing(PolygonRing):
    """Inputs of the ring with a hub force on each of its flats."""

    e: float = given(
        "9 mm", "mm", "e", "distance of the hub contact from the middle of a flat", gt=0, le=1e5
    )
    R_b: float = given(
        "200 N/mm", "N/mm", "R/b", "hub force on a flat, per width of the ring", gt=0, le=1e7
    )
    tan_phi: float = given(
        0.05, "1", "tan φ_1",
        "coefficient of friction between hub and ring; the friction force on the ring acts "
        "towards the middle of the flat",
        ge=0, le=1,
    )  # fmt: skip

    @model_validator(mode="after")
    def _on_the_flat(self) -> Self:
        check_on_the_flat(self, self.e)
        return self


def check_on_the_flat(q: PolygonRing, e: float) -> None:
    """Raise ValueError if `e` [m] is outside the flat of `q`, measured from its middle."""
    if e > OUTERMOST * q.half_flat:
        raise ValueError(
            f"the hub must touch the flat: e must be at most {OUTERMOST:g} times half the length "
            f"of a flat, hence {OUTERMOST * q.half_flat * 1e3:.4g} mm, got {e * 1e3:g} mm"
        )


def check_apart(*, z: int, D_i: float, d: float) -> None:
    """Raise ValueError if z rollers of diameter d [m] overlap in the race."""
    pitch = (D_i - d) * math.sin(math.pi / z)
    if d >= pitch:
        raise ValueError(
            f"neighbouring rollers overlap: d must be below (D_i - d) sin(π/z) = "
            f"{pitch * 1e3:.6g} mm for z = {z}, got {d * 1e3:g} mm"
        )

"""Inputs of the whole polyhedral ring clutch: dimensions, friction, pressure, target torque."""

import math
from typing import Self

import numpy as np
from pydantic import model_validator

from analytic.polyhedral.wedging import holds
from verify.case import Case, Quantity, count, given
from verify.cases.polyhedral.inputs import PolygonRing, check_apart, check_on_the_flat

FLATTENED = 0.15  # a/d that rollers may reach
NARROWEST, WIDEST = 1e-5, 0.02  # relative to d_e: clearances that a ring can close


class ClutchInputs(Case):
    """Inputs of ring, rollers, race and hub; default values are assumed, the paper prints none."""

    M_t: float = given("100 N m", "N m", "M_t", "target torque", gt=0, le=1e9)
    p_t: float = given("30 MPa", "MPa", "p_t", "available pressure", gt=0, le=1e4)
    z: int = count(6, "z", "number of rollers and of flats of the bore", ge=3, le=48)
    D_i: float = given("100.06 mm", "mm", "D_i", "inner diameter of the race", gt=0, le=1e5)
    d: float = given("10 mm", "mm", "d", "diameter of the rollers", gt=0, le=1e5)
    d_e: float = given("80 mm", "mm", "d_e", "outer diameter of the ring", gt=0, le=1e5)
    delta_1: float = given(
        "4 mm", "mm", "δ_1", "wall thickness of the ring in its corners", gt=0, le=1e5
    )
    rho: float = given("2 mm", "mm", "ρ", "fillet radius of the corners of the bore", gt=0, le=1e4)
    b: float = given("30 mm", "mm", "b", "width of ring and rollers", gt=0, le=1e5)
    e: float = given(
        "9 mm", "mm", "e", "distance of the hub contact from the middle of a flat", gt=0, le=1e5
    )
    mu: float = given(0.08, "1", "μ", "coefficient of friction of the rollers", gt=0, lt=1)
    tan_phi: float = given(
        0.05, "1", "tan φ_1", "coefficient of friction between hub and ring", ge=0, le=1
    )
    E: float = given("210 GPa", "GPa", "E", "Young's modulus of all parts", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio of all parts", ge=0, le=0.45)
    alpha: float | None = given(
        None, "deg", "α", "wedge angle of the rollers; if omitted, 2 arctan μ", omitted=None,
        gt=0, le=25, example="6 deg",
    )  # fmt: skip
    R_p: float | None = given(
        None, "MPa", "R_p", "yield strength of the ring", omitted=None, gt=0,
        example="900 MPa",
    )  # fmt: skip

    @Quantity("β", "deg", "angle between adjacent rollers", role="geometry", tex=r"\frac{2 \pi}{z}")
    def beta(self) -> float:
        return 2 * math.pi / self.z

    @Quantity("j_D", "mm", "diametral clearance", equation="7", role="geometry")
    def j_D(self) -> float:
        return self.D_i - (self.d_e + 2 * self.d)

    @Quantity("d_i", "mm", "diameter of the bore through its corners", role="geometry")
    def d_i(self) -> float:
        return self.d_e - 2 * self.delta_1

    apothem = Quantity(
        "a_f", "mm", "distance of the flats from the axis", role="geometry",
        tex=r"\left(\frac{d_i}{2} - \rho\right) \cos\left(\frac{\pi}{z}\right) + \rho",
    ).reads(lambda q: q.ring.apothem)  # fmt: skip

    @property
    def ring(self) -> PolygonRing:
        """The elastic ring; raises ValidationError if its dimensions are impossible."""
        return PolygonRing(
            d_e=self.d_e, delta_1=self.delta_1, j_D=self.j_D, E=self.E, nu=self.nu, R_p=self.R_p,
            z=self.z, rho=self.rho,
        )  # fmt: skip

    @Quantity("ψ", "deg", "angle from the normal of the flat to the radius through the hub "
              "contact", source="after Eq. 15", role="geometry",
              tex=r"\arctan\left(\frac{e}{a_f}\right)")  # fmt: skip
    def psi(self) -> float:
        return math.atan2(self.e, self.apothem)

    @Quantity("φ_1", "deg", "angle of friction between hub and ring", role="geometry",
              tex=r"\arctan\left(tan \varphi_1\right)")  # fmt: skip
    def phi_1(self) -> float:
        return math.atan(self.tan_phi)

    @Quantity("μ_g", "1", "ratio of tangential to normal force of the rollers: tan(α/2), or μ "
              "if α is not entered or too large to hold the rollers", role="geometry")  # fmt: skip
    def grip(self) -> float:
        if self.alpha is None or not holds(alpha=self.alpha, mu=self.mu):
            return self.mu
        return float(np.tan(self.alpha / 2))

    @property
    def stays(self) -> bool:
        """Whether the rollers stay in their wedge; also true if no wedge angle is given."""
        return self.alpha is None or bool(holds(alpha=self.alpha, mu=self.mu))

    @property
    def all_levers(self) -> float:
        """Ratio [m²] of the torque of the clutch to the tangential force per length of a roller."""
        return self.b * self.z * self.D_i / 2

    def _check_loads(self) -> None:
        """Raise ValueError if a/d of the rollers exceeds `FLATTENED`."""
        E_star = self.E / 2 / (1 - self.nu**2)
        most = np.pi * E_star * (FLATTENED * self.d) ** 2 / 4 * (2 / self.d + 2 / self.d_e)
        torque = self.mu * most * self.b * self.z * self.D_i / 2
        if self.M_t > torque:
            raise ValueError(
                f"M_t = {self.M_t:.4g} N m is too large for d = {self.d * 1e3:g} mm: M_t must not "
                f"exceed {torque:.4g} N m, at which the normal force of a roller is "
                f"{most * self.b / 1e3:.4g} kN"
            )
        largest = most / self.ring.d_i
        if self.p_t > largest:
            raise ValueError(
                f"p_t = {self.p_t / 1e6:.4g} MPa is too large for d = {self.d * 1e3:g} mm: "
                f"p_t must not exceed {largest / 1e6:.4g} MPa"
            )

    @model_validator(mode="after")
    def _built(self) -> Self:
        room = (self.D_i - self.d_e) / 2
        if self.j_D <= NARROWEST * self.d_e:
            raise ValueError(
                f"the rollers do not fit between ring and race: d must be below (D_i - d_e)/2 = "
                f"{room * 1e3:.6g} mm, got {self.d * 1e3:g} mm"
            )
        if self.j_D > WIDEST * self.d_e:
            raise ValueError(
                f"the rollers are too small: the clearance j_D = D_i - (d_e + 2 d)"
                f" = {self.j_D * 1e3:.6g} mm must not exceed {WIDEST:g} d_e = "
                f"{WIDEST * self.d_e * 1e3:g} mm, got d = {self.d * 1e3:g} mm"
            )
        check_apart(z=self.z, D_i=self.D_i, d=self.d)
        self._check_loads()
        check_on_the_flat(self.ring, self.e)
        if self.psi <= self.phi_1:
            raise ValueError(
                f"the hub locks itself: ψ = {math.degrees(self.psi):.4g}° must exceed φ_1 = "
                f"{math.degrees(self.phi_1):.4g}°; e must be above "
                f"{self.ring.apothem * self.tan_phi * 1e3:.4g} mm, got {self.e * 1e3:g} mm"
            )
        return self

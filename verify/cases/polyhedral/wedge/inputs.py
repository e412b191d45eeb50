"""Inputs of a roller wedged between two flats, and the sizes of its contacts."""

from typing import Self

from pydantic import model_validator

from analytic.contact import hertz_line
from verify.case import Case, Quantity, count, given
from verify.cases.polyhedral.inputs import check_apart

WIDEST = 0.15  # a/R that the roller may reach


class WedgeInputs(Case):
    """Inputs of z rollers, each in a wedge of two flats (ring and race) at the angle alpha."""

    alpha: float = given("6 deg", "deg", "α", "full wedge angle", ge=0.5, le=25)
    mu: float = given(0.08, "1", "μ", "coefficient of friction, equal at both contacts",
                         ge=0.02, le=0.6)  # fmt: skip
    N: float = given("1500 N", "N", "N", "normal force at either contact of a roller", gt=0,
                        le=1e9)  # fmt: skip
    z: int = count(6, "z", "number of rollers", ge=1, le=200)
    d: float = given("10 mm", "mm", "d", "diameter of the rollers", gt=1e-3, le=1e5)
    D_i: float = given("100.06 mm", "mm", "D_i", "inner diameter of the race", gt=1e-3, le=1e6)
    b: float = given("30 mm", "mm", "b", "length of the rollers", gt=1e-3, le=1e6)
    E: float = given("210 GPa", "GPa", "E", "Young's modulus of rollers and races", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    p_lim: float | None = given(
        None, "MPa", "p_lim", "permissible pressure of the material", omitted=None,
        gt=0, example="4000 MPa",
    )  # fmt: skip

    @model_validator(mode="after")
    def _fits(self) -> Self:
        if not self.D_i > 2 * self.d:
            raise ValueError(
                "the race must be larger than two rollers, D_i > 2 d, got "
                f"D_i = {self.D_i * 1e3:g} mm, d = {self.d * 1e3:g} mm"
            )
        check_apart(z=self.z, D_i=self.D_i, d=self.d)
        if self.a > WIDEST * self.R:
            raise ValueError(
                f"a line contact requires a/R of at most {WIDEST:g}, got a/R = "
                f"{self.a / self.R:.3g} with N = {self.N:g} N "
                f"on b = {self.b * 1e3:g} mm, d = {self.d * 1e3:g} mm; reduce N"
            )
        return self

    @property
    def R(self) -> float:
        """Radius of a roller [m]."""
        return self.d / 2

    @property
    def half(self) -> float:
        """Half of the wedge angle, alpha/2 [rad]."""
        return self.alpha / 2

    @property
    def line_load(self) -> float:
        """Normal force per length [N/m]."""
        return self.N / self.b

    @property
    def E_star(self) -> float:
        """Contact modulus of roller and race, plane strain [Pa]."""
        one = {"E_1": self.E, "nu_1": self.nu, "E_2": self.E, "nu_2": self.nu}
        return float(hertz_line.contact_modulus(**one, assumption="plane strain"))

    @Quantity("a", "µm", "half-width of the contacts", source="Hertz", role="geometry",
              tex=r"\sqrt{\frac{4 N d (1 - \nu^2)}{\pi E b}}")  # fmt: skip
    def a(self) -> float:
        return float(hertz_line.half_width(P=self.line_load, R=self.R, E_star=self.E_star))

    @Quantity("p_0", "MPa", "peak pressure of the contacts", source="Hertz", role="geometry",
              safe="too high", tex=r"\frac{2 N}{\pi a b}")  # fmt: skip
    def p_0(self) -> float:
        return float(hertz_line.peak_pressure(P=self.line_load, R=self.R, E_star=self.E_star))

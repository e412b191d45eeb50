"""Inputs of partial slip between two equal rollers, and what the formulas make of them."""

from pydantic import model_validator

from analytic.contact import hertz_line
from verify.core.inputs import Inputs, quantity

WIDEST = 0.3  # a/R that the rollers may reach


class SlipInputs(Inputs):
    """Two equal rollers, pressed together and then pushed sideways."""

    R: float = quantity(
        "4.02 mm", "mm", "R", "radius of both rollers", gt=1e-3, le=1e5,
        claims="huang2018:table1-r-i1",
    )  # fmt: skip
    P: float = quantity("70 N/mm", "N/mm", "P", "normal load per length", gt=0, le=1e6)
    mu: float = quantity(0.1, "1", "μ", "coefficient of friction", ge=1e-3, le=1)
    share: float = quantity(
        0.6, "1", "Q/(μP)", "amplitude of the tangential load in a cycle; --fem: 0.5 to 0.9",
        gt=0, lt=1,
    )  # fmt: skip
    E: float = quantity("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = quantity(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    hardness: float | None = quantity(
        None, "MPa", "p_lim", "pressure that the material bears, for the warning", omitted=None,
        gt=0, example="4000 MPa",
    )  # fmt: skip

    @model_validator(mode="after")
    def _line_contact(self) -> "SlipInputs":
        if self.a > WIDEST * self.R:
            raise ValueError(
                f"a line contact needs a/R of at most {WIDEST:g}, got a/R = {self.a / self.R:.3g} "
                f"with P = {self.P / 1e3:g} N/mm, R = {self.R * 1e3:g} mm"
            )
        return self

    @property
    def E_star(self) -> float:
        """Contact modulus of the pair, plane strain [Pa]."""
        return float(
            hertz_line.contact_modulus(
                E_1=self.E, nu_1=self.nu, E_2=self.E, nu_2=self.nu, assumption="plane strain"
            )
        )

    @property
    def a(self) -> float:
        """Hertz's half-width [m]."""
        relative = hertz_line.relative_radius(R_1=self.R, R_2=self.R)
        return float(hertz_line.half_width(P=self.P, R=relative, E_star=self.E_star))

    @property
    def loads(self) -> dict[str, float]:
        """What the formulas of partial slip share."""
        return {"P": self.P, "mu": self.mu}

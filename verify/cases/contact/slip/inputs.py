"""Inputs of partial slip between two equal rollers."""

from typing import Any, Self

from pydantic import model_validator

from analytic.contact import hertz_line
from verify.case import Case, given

WIDEST = 0.3  # a/R that the rollers may reach
SHARES = (0.2, 0.4, 0.6, 0.8)  # Q/(mu P) of the first loading's rows
CHORD = SHARES[-1]  # Q/(mu P) at the end of the chord of displacements
STAGES = (0.5, 0.0, -0.5, -1.0)  # Q/Q_max of the unloading's rows


def key(k: float) -> str:
    """Suffix of keys of results at Q/(mu P) = `k`, in hundredths: "k20" for 0.2."""
    return f"k{round(100 * k)}"


class SlipInputs(Case):
    """Two equal rollers under a normal force and an alternating tangential force."""

    R: float = given(
        "4.02 mm", "mm", "R", "radius of both rollers", gt=1e-3, le=1e5,
        claims="huang2018:table1-r-i1",
    )  # fmt: skip
    P: float = given("70 N/mm", "N/mm", "P", "normal load per length", gt=0, le=1e6)
    mu: float = given(0.1, "1", "μ", "coefficient of friction", ge=1e-3, le=1)
    share: float = given(
        0.6, "1", "Q/(μP)", "amplitude of the tangential force over μP (with --fem: 0.5 to 0.9)",
        gt=0, lt=1,
    )  # fmt: skip
    E: float = given("206 GPa", "GPa", "E", "Young's modulus", gt=0, le=1e5)
    nu: float = given(0.3, "1", "ν", "Poisson's ratio", ge=0, le=0.45)
    hardness: float | None = given(
        None, "MPa", "p_lim", "permissible pressure of the material", omitted=None,
        gt=0, example="4000 MPa",
    )  # fmt: skip

    @model_validator(mode="after")
    def _line_contact(self) -> Self:
        if self.width > WIDEST * self.R:
            raise ValueError(
                f"a line contact requires a/R of at most {WIDEST:g}, got a/R = "
                f"{self.width / self.R:.3g} with P = {self.P / 1e3:g} N/mm, R = {self.R * 1e3:g} mm"
                "; reduce P"
            )
        return self

    @property
    def hertz(self) -> dict[str, Any]:
        """Arguments of Hertz's formulas: P, relative radius R, E_star in plane strain."""
        E_star = hertz_line.contact_modulus(
            E_1=self.E, nu_1=self.nu, E_2=self.E, nu_2=self.nu, assumption="plane strain"
        )
        R = hertz_line.relative_radius(R_1=self.R, R_2=self.R)
        return {"P": self.P, "R": R, "E_star": float(E_star)}

    @property
    def width(self) -> float:
        """Hertz's half-width [m], which also sets the size of the finest cells."""
        return float(hertz_line.half_width(**self.hertz))

"""Inputs of two spheres in point contact, and values that formulas and reference share."""

from typing import Any, ClassVar, Literal, Self

from pydantic import model_validator

from analytic.contact import hertz_line, hertz_point
from analytic.contact.sphere_series import Sphere
from verify.case import Case, given

Pair = Literal["flat", "sphere"]
PAIRS: tuple[Pair, ...] = ("flat", "sphere")
WORDS: dict[Pair, str] = {"flat": "contact on a rigid flat", "sphere": "contact on a sphere"}
BODIES = {"flat": ("upper",), "sphere": ("upper", "lower")}
END = {"flat": "_flat", "sphere": ""}  # of the names of numbers
WIDEST = 0.15  # a over the smaller radius


class SphereInputs(Case):
    """Inputs of a sphere on a rigid flat and on another sphere, pressed from both sides."""

    pair: ClassVar[Pair] = "sphere"  # of the quantities

    R_1: float = given(
        "4.02 mm", "mm", "R_1", "radius of the upper sphere", gt=0, le=1e6,
        claims="huang2018:table1-r-i1",
    )  # fmt: skip
    R_2: float = given(
        "11.11 mm", "mm", "R_2", "radius of the lower sphere", gt=0, le=1e6,
        claims="huang2018:table1-r-i",
    )  # fmt: skip
    P: float = given("16 N", "N", "P", "load", gt=0, le=1e12)
    E_1: float = given("206 GPa", "GPa", "E_1", "Young's modulus, upper sphere", gt=0, le=1e5)
    nu_1: float = given(0.3, "1", "ν_1", "Poisson's ratio, upper sphere", ge=0, le=0.45)
    E_2: float = given("110 GPa", "GPa", "E_2", "Young's modulus, lower sphere", gt=0, le=1e5)
    nu_2: float = given(0.34, "1", "ν_2", "Poisson's ratio, lower sphere", ge=0, le=0.45)
    R_p: float | None = given(
        None, "MPa", "R_p", "yield strength of the weaker body", omitted=None,
        gt=0, example="1200 MPa",
    )  # fmt: skip

    @model_validator(mode="after")
    def _point_contact(self) -> Self:
        least, most = sorted((self.R_1, self.R_2))
        if most > 1e3 * least:
            raise ValueError(
                f"R_1 and R_2 must not differ by more than a factor of 1000, got R_1 = "
                f"{self.R_1 * 1e3:g} mm, R_2 = {self.R_2 * 1e3:g} mm: use the rows of the contact "
                "on a flat"
            )
        if not 1e-3 <= self.E_1 / self.E_2 <= 1e3:
            raise ValueError(
                f"E_1 and E_2 must not differ by more than a factor of 1000, got E_1 = "
                f"{self.E_1 / 1e9:g} GPa, E_2 = {self.E_2 / 1e9:g} GPa: use the rows of the "
                "contact on a flat"
            )
        for pair in PAIRS:
            wide = self.of(pair).width / (self.R_1 if pair == "flat" else least)
            if not 1e-5 <= wide <= WIDEST:
                raise ValueError(
                    f"a point contact requires a/R from 1e-05 to {WIDEST:g}, got {wide:.3g} for "
                    f"the {WORDS[pair]} with P = {self.P:g} N"
                )
        return self

    def of(self, pair: Pair) -> Self:
        """The inputs with the contact `pair` selected: on a flat or on a sphere."""
        return self.variant(pair=pair)

    @property
    def spheres(self) -> tuple[Sphere, Sphere]:
        """Upper and lower body, as spheres; a flat has infinite radius and modulus."""
        one = Sphere(R=self.R_1, E=self.E_1, nu=self.nu_1)
        if self.pair == "flat":
            return one, Sphere(R=float("inf"), E=float("inf"), nu=0.0)
        return one, Sphere(R=self.R_2, E=self.E_2, nu=self.nu_2)

    @property
    def hertz(self) -> dict[str, Any]:
        """Arguments of Hertz's formulas: P, R, E_star."""
        one, other = self.spheres
        E_star = hertz_line.contact_modulus(
            E_1=one.E, nu_1=one.nu, E_2=other.E, nu_2=other.nu, assumption="plane strain"
        )
        R = hertz_line.relative_radius(R_1=one.R, R_2=other.R)
        return {"P": self.P, "R": float(R), "E_star": float(E_star)}

    @property
    def width(self) -> float:
        """Hertz's contact radius [m], which also sets the size of the finest cells."""
        return float(hertz_point.radius(**self.hertz))

    @property
    def beyond(self) -> float:
        """(a/R)² of the smaller sphere: size of the terms beyond the first-order correction."""
        least = self.R_1 if self.pair == "flat" else min(self.R_1, self.R_2)
        return (self.width / least) ** 2

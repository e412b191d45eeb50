"""Inputs of a press fit: two walls, interference, pressures in the bore and on the rim."""

from typing import ClassVar, Literal, NamedTuple, Self

from pydantic import model_validator

from analytic.contact.checks import Assumption
from verify.case import Case, given

Walls = Literal["rings", "overlapping rings", "shaft"]


class Fit(NamedTuple):
    """A fit to be computed: suffix of its keys, walls, plane assumption, and its name."""

    key: str
    walls: Walls
    ends: Assumption
    words: str

    @property
    def name(self) -> str:
        """Name of the fit, used to state the scale of errors in its rows."""
        return f"{self.walls}, {self.ends}"


FITS = (
    Fit("", "rings", "plane stress", "rings, plane stress"),
    Fit("strain", "rings", "plane strain", "rings, plane strain"),
    Fit(
        "drawn",
        "overlapping rings",
        "plane strain",
        "rings that overlap by the interference, plane strain",
    ),
    Fit("shaft", "shaft", "plane stress", "solid shaft, plane stress"),
)


class FitInputs(Case):
    """A ring or a solid shaft in an outer ring, under pressures in the bore and on the rim."""

    walls: ClassVar[Walls] = "rings"  # of the quantities
    ends: ClassVar[Assumption] = "plane stress"

    r_i: float = given(
        "19.44 mm", "mm", "r_i", "bore radius of the inner wall", gt=0, le=1e5,
        claims="huang2018:table1-r-e",
    )  # fmt: skip
    r_f: float = given(
        "26.23 mm", "mm", "r_f", "nominal radius of the fit", gt=0, le=1e5,
        claims="huang2018:table1-r-ed",
    )  # fmt: skip
    r_o: float = given("40 mm", "mm", "r_o", "rim radius of the outer wall", gt=0, le=1e5)
    delta: float = given(
        "15 µm", "µm", "δ", "interference of the radii (half of the diametral interference)",
        gt=0, le=1e6,
    )  # fmt: skip
    p_i: float = given(
        "37 MPa", "MPa", "p_i", "pressure in the bore of the inner wall", omitted=0.0, ge=0, le=1e5
    )
    p_o: float = given(
        "5 MPa", "MPa", "p_o", "pressure on the rim of the outer wall", omitted=0.0, ge=0, le=1e5
    )
    E_i: float = given("206 GPa", "GPa", "E_i", "Young's modulus, inner wall", gt=0, le=1e5)
    nu_i: float = given(0.3, "1", "ν_i", "Poisson's ratio, inner wall", ge=0, le=0.45)
    E_o: float = given("70 GPa", "GPa", "E_o", "Young's modulus, outer wall", gt=0, le=1e5)
    nu_o: float = given(0.33, "1", "ν_o", "Poisson's ratio, outer wall", ge=0, le=0.45)
    R_p: float | None = given(
        None, "MPa", "R_p", "yield strength of the weaker wall", omitted=None,
        gt=0, example="250 MPa",
    )  # fmt: skip

    @model_validator(mode="after")
    def _walls(self) -> Self:
        radii = ", ".join(f"{n} = {getattr(self, n) * 1e3:g} mm" for n in ("r_i", "r_f", "r_o"))
        if not self.r_i < self.r_f < self.r_o:
            raise ValueError(f"a press fit requires r_i < r_f < r_o, got {radii}")
        wall = self.thinnest
        if wall < 1e-3 * self.r_f:
            raise ValueError(
                f"the thinner wall, {wall * 1e3:g} mm, must be at least r_f/1000, got {radii}"
            )
        if self.delta > 0.01 * self.r_f or self.delta > 0.1 * wall:
            raise ValueError(
                f"delta = {self.delta * 1e6:g} µm must exceed neither r_f/100 nor a tenth of the "
                f"thinner wall (wall {wall * 1e3:g} mm): small strains are assumed"
            )
        return self

    @property
    def thinnest(self) -> float:
        """Thickness of the thinner wall [m]."""
        return min(self.r_f - self.r_i, self.r_o - self.r_f)

    def of(self, fit: Fit) -> Self:
        """The inputs with the walls and the plane assumption of `fit`."""
        return self.variant(walls=fit.walls, ends=fit.ends)

    @property
    def bore(self) -> float:
        """Bore radius of the inner wall [m]; zero for a shaft."""
        return 0.0 if self.walls == "shaft" else self.r_i

    @property
    def p_bore(self) -> float:
        """Pressure in the bore of the inner wall [Pa]; zero for a shaft."""
        return 0.0 if self.walls == "shaft" else self.p_i

    @property
    def surfaces(self) -> tuple[float, float]:
        """Radii of the rim of the inner wall and of the bore of the outer wall [m].

        The radii of overlapping rings differ by δ.
        """
        if self.walls == "overlapping rings":
            return self.r_f + self.delta / 2, self.r_f - self.delta / 2
        return self.r_f, self.r_f

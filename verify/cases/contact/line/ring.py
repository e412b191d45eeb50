"""Case of a roller in a race with a fixed rim: Hertz's line contact in a bore."""

from collections.abc import Iterator
from typing import ClassVar, Self

from pydantic import model_validator

from analytic.bounds.contact.line_bodies import InRace
from analytic.contact import clamped_race, hertz_line, hertz_line_approach
from verify.case import Comparison, Level, Quantity, Scan, given
from verify.cases.contact.line import sketches
from verify.cases.contact.line.reference import race_fem, result
from verify.cases.contact.line.two_bodies import TwoBodies
from verify.form.adapter import adapted

THICKEST = 8.0  # r_o/r_i
THINNEST = 0.08  # wall over r_i: the whole bore may touch, which takes half a minute
BOUND = "estimated: ± ((a/R)² for the curvature + (a/wall thickness)² for the fixed rim)"
APPROACH = "estimated: ± (((a/R)² + (a/wall thickness)²)/2 + effect of different materials)"
SHEAR = (
    "derived: −0.693 a/R as on a flat, and −0.093 κa due to the inclined pressure (κ: curvature of "
    "the contact surface); ± ((a/R)² + (a/wall thickness)² + effect of different "
    "materials), at least 1e-3"
)


class RollerInRace(TwoBodies):
    """A roller with a profile radius of the sprag touches the bore of a race.

    The bore is curved in the same direction as the roller, which widens the contact. The wall
    thickness is about fifty times the half-width of the contact. The approach of the centre of the
    roller and the fixed rim is derived from the Fourier series of the ring.
    """

    id = "contact-ring"
    title = "Roller in a race"
    scans: ClassVar = (
        Scan(
            vary=("F=1000N,3407N,10000N,20000N", "r_i=8mm,12mm,19.44mm", "r_o=22mm,26.23mm,40mm"),
            star=True,
        ),
    )
    readings: ClassVar = (
        "the bodies are long: plane strain, with the modulus E/(1 − ν²) of each body",
        "relative curvature of the roller in the bore: 1/R − 1/r_i; R and r_i are radii",
        "δ is the approach of the centre of the roller and the rim of the race; the rim is fixed",
    )
    assumptions: ClassVar = (
        "linear elasticity, no friction; the ends of the roller are not modelled",
        "the load acts on both sides of the roller: a quarter of the roller is modelled, and its "
        "horizontal cut stays straight",
        "the race contains one roller, and the whole rim of the race is fixed: half of the race is "
        "modelled",
        "the contact pressure acts along the normal of the common, deformed contact surface",
        "each mesh has a node at the edge of the contact; a coarse solution locates this edge",
    )

    R: float = given(
        "4.02 mm", "mm", "R", "radius of the roller", gt=0, le=1e5, claims="huang2018:table1-r-i1"
    )
    r_i: float = given(
        "19.44 mm", "mm", "r_i", "bore radius of the race", gt=0, le=1e5,
        claims="huang2018:table1-r-e",
    )  # fmt: skip
    r_o: float = given(
        "26.23 mm", "mm", "r_o", "outer radius of the race", gt=0, le=1e5,
        claims="huang2018:table1-r-ed",
    )  # fmt: skip

    @model_validator(mode="after")
    def _fits(self) -> Self:
        if self.R / self.r_i > 0.9:
            raise ValueError(
                f"R must not exceed 0.9 r_i, got R = {self.R * 1e3:g} mm, "
                f"r_i = {self.r_i * 1e3:g} mm: the contact of a closer fit is too wide; reduce R"
            )
        if not self.r_i < self.r_o:
            raise ValueError(
                f"the race requires r_i < r_o, got r_i = {self.r_i * 1e3:g} mm, "
                f"r_o = {self.r_o * 1e3:g} mm"
            )
        self.check_load(f"R = {self.R * 1e3:g} mm, wall {self.wall * 1e3:g} mm")
        return self

    @Quantity("R'", "mm", "relative radius", role="step", source="Hertz",
              tex=r"\frac{1}{\frac{1}{R} - \frac{1}{r_i}}")  # fmt: skip
    def radius(self) -> float:
        return float(hertz_line.relative_radius(R_1=self.R, R_2=-self.r_i))

    @Quantity("δ_1", "µm", "part of the approach due to the deformation of the roller",
              role="step", source="Hertz",
              tex=r"\frac{P (1 - \nu_1^2)}{\pi E_1} (2 \ln\left(\frac{4 R}{a}\right) - 1)",
              )  # fmt: skip
    def in_roller(self) -> float:
        E_plane = self.E_1 / (1 - self.nu_1**2)
        sizes = {"P": self.P, "a": self.a, "R": self.R}
        return float(hertz_line_approach.approach_to_centre(**sizes, E_plane=E_plane))

    @Quantity("s", "1", "constant s in the formula for δ_2, with fixed rim", role="step",
              source="U_n cos nθ: radial displacement of the bore under a pressure cos nθ",
              tex=r"\frac{E_2' U_0}{4 r_i} + \sum_{n=1}^{\infty}"
              r"\left(\frac{E_2' U_n}{2 r_i} - \frac{1}{n}\right)")  # fmt: skip
    def s(self) -> float:
        return clamped_race.rim_constant(**self.race, assumption="plane strain")

    @Quantity("δ_2", "µm", "part of the approach due to the deformation of the race", role="step",
              source="Fourier series of the race",
              tex=r"\frac{2 P (1 - \nu_2^2)}{\pi E_2}"
              r" (\ln\left(\frac{2 r_i}{a}\right) + \frac{1}{2} + s)")  # fmt: skip
    def in_race(self) -> float:
        return clamped_race.approach_to_rim(
            P=self.P, a=self.a, **self.race, E=self.E_2, assumption="plane strain"
        )

    @Quantity("δ", "µm", "approach of roller centre and rim",
              source="approach of the centre of the roller and the fixed rim")  # fmt: skip
    def approach(self) -> float:
        return self.in_roller + self.in_race

    @property
    def race(self) -> dict[str, float]:
        """Radii and Poisson's ratio of the race, as keyword arguments of the formulas."""
        return {"r_i": self.r_i, "r_o": self.r_o, "nu": self.nu_2}

    @property
    def relative(self) -> float:
        return self.radius

    @property
    def radii(self) -> tuple[float, float]:
        return self.R, -self.r_i

    @property
    def wall(self) -> float:
        """Thickness of the race [m]."""
        return self.r_o - self.r_i

    @property
    def smallest(self) -> float:
        return min(self.R, self.wall)

    @property
    def smallest_name(self) -> str:
        return "the roller's radius" if self.smallest == self.R else "the race's wall"

    def reference(self, level: int) -> Level:
        """Results of a quarter of the roller in half of the race."""
        return result(race_fem(self, level), level, ("roller.axis", "roller.middle"))

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: errors of Hertz's theory due to curvature, fixed rim and materials."""
        known = InRace(a=self.a, R_1=self.R, R_2=-self.r_i, wall=self.wall, **self.materials)
        yield from self.against(known, RollerInRace.approach, (BOUND, APPROACH, SHEAR),
                                shares="fixed rim")  # fmt: skip
        yield self.near_hertz(self.pressure)
        yield from self.balances()

    sketch = sketches.ring

    def refusal(self) -> str:
        """Reason for not solving a very thin or a very thick wall; "" for other walls.

        In a thick wall, cells far from the contact are too coarse. If the wall is thin, the whole
        bore may touch the roller and needs short cells, whose compliance matrix takes minutes to
        compute.
        """
        if self.wall < THINNEST * self.r_i:
            return (
                f"a wall of {self.wall * 1e3:.4g} mm is thinner than {THINNEST:.0%} of r_i: finite "
                "elements would take minutes; run `check` without --fem"
            )
        if self.r_o > THICKEST * self.r_i:
            return (
                f"r_o = {self.r_o / self.r_i:.3g} r_i exceeds {THICKEST:g} r_i: the mesh is too "
                "coarse in a wall that thick; run `check` without --fem"
            )
        return super().refusal()


RING = adapted(RollerInRace)

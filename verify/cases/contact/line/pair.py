"""Case of two rollers with parallel axes: Hertz's line contact of bodies of similar size.

The pair is also solved with different materials under a high load. With equal materials at the load
of the paper, the terms of `pair_series` are smaller than the mesh error.
"""

import math
from collections.abc import Iterator
from typing import ClassVar, Self

from pydantic import model_validator

from analytic.bounds.contact.line_bodies import OfDiscs
from analytic.contact import hertz_line, hertz_line_approach
from verify.case import Comparison, Level, Quantity, Scan, State, approximation, given, shared
from verify.cases.contact.expected import expected
from verify.cases.contact.line import sketches
from verify.cases.contact.line.hertz import at
from verify.cases.contact.line.reference import pair_fem, result
from verify.cases.contact.line.two_bodies import TwoBodies
from verify.form.adapter import adapted

RATIO = 0.1  # of rollers of different materials: Hertz's a over the smaller radius
SOFT, NU = 1 / 3, 0.1  # the lower roller's modulus over the upper one's, and its Poisson's ratio
WHERE = f"different materials, a/R = {RATIO:g}"
SECOND = 1e-3, "well below the second-order term, 2.6e-3, so that the row detects this term"
SERIES = "derived series of two discs, ± an estimate of its next terms, at least 3e-4"
BOUNDED = "derived series of two discs, ± a bound of its next terms, at least 3e-4"
COUPLING = "estimated: ± ((a/R)²/2 + effect of different materials), at least 3e-4"
SHEAR = (
    "derived: −0.693 a/R_1 as on a flat, and −0.093 κa due to the inclined pressure (κ: curvature "
    "of the contact surface); ± ((a/R)² + effect of different materials), at least 1e-3"
)


class TwoRollers(TwoBodies):
    """Two elastic rollers of different radii represent a sprag on the inner race.

    The error of Hertz's theory is derived to the second order in a/R. The derivation includes the
    inclination of the common contact surface. The difference between Hertz's theory and finite
    elements must agree with the derived error.
    """

    id = "contact-pair"
    title = "Two rollers with parallel axes"
    scans: ClassVar = (
        Scan(vary=("F=300N,1000N,3407N,10000N,20000N", "R_2=4.02mm,11.11mm,50mm"), star=True),
    )
    readings: ClassVar = (
        "the rollers are long: plane strain, with the modulus E/(1 − ν²) of each roller",
        "R_1 and R_2 are radii, not diameters; the curvatures 1/R_1 and 1/R_2 are added",
        "δ is the approach of the centres; the load also acts on the opposite side of each roller",
    )
    assumptions: ClassVar = (
        "linear elasticity, no friction; the ends of the rollers are not modelled",
        "the load acts on both sides of each roller: a quarter of each roller is modelled, and its "
        "horizontal cut stays straight",
        "the contact pressure acts along the normal of the common, deformed contact surface",
        "each mesh has a node at the edge of the contact; a coarse solution locates this edge",
    )

    R_1: float = given(
        "4.02 mm", "mm", "R_1", "radius of the upper roller", gt=0, le=1e5,
        claims="huang2018:table1-r-i1",
    )  # fmt: skip
    R_2: float = given(
        "11.11 mm", "mm", "R_2", "radius of the lower roller or convex race", gt=0, le=1e5,
        claims="huang2018:table1-r-i",
    )  # fmt: skip

    @model_validator(mode="after")
    def _load(self) -> Self:
        if not 1e-3 <= self.R_1 / self.R_2 <= 1e3:
            raise ValueError(
                f"R_1 and R_2 must not differ by more than a factor of 1000, got R_1 = "
                f"{self.R_1 * 1e3:g} mm, R_2 = {self.R_2 * 1e3:g} mm: use the case contact-flat"
            )
        self.check_load(f"R_1 = {self.R_1 * 1e3:g} mm, R_2 = {self.R_2 * 1e3:g} mm")
        return self

    @Quantity("R'", "mm", "relative radius", role="step", source="Hertz",
              tex=r"\frac{1}{\frac{1}{R_1} + \frac{1}{R_2}}")  # fmt: skip
    def radius(self) -> float:
        return float(hertz_line.relative_radius(R_1=self.R_1, R_2=self.R_2))

    @Quantity("δ", "µm", "approach of the centres, Hertz", source="Hertz, approach of the centres",
              tex=r"\frac{P (1 - \nu_1^2)}{\pi E_1} (2 \ln\left(\frac{4 R_1}{a}\right) - 1)"
              r" + \frac{P (1 - \nu_2^2)}{\pi E_2} (2 \ln\left(\frac{4 R_2}{a}\right) - 1)",
              )  # fmt: skip
    def approach(self) -> float:
        return sum(
            float(
                hertz_line_approach.approach_to_centre(
                    P=self.P, a=self.a, R=R, E_plane=E / (1 - nu**2)
                )
            )
            for R, E, nu in ((self.R_1, self.E_1, self.nu_1), (self.R_2, self.E_2, self.nu_2))
        )

    @Quantity("p_s", "MPa", "peak pressure with terms of second order in a/R",
              source="series of two discs", role="step")  # fmt: skip
    def p_0_series(self) -> float:
        return self.p_0 * (1 + self.known.series[0].total)

    @Quantity("a_s", "µm", "half-width with terms of second order in a/R",
              source="series of two discs", role="step")  # fmt: skip
    def a_series(self) -> float:
        return self.a * (1 + self.known.series[1].total)

    @shared
    def known(self) -> OfDiscs:
        """Errors of Hertz's theory for two discs, derived in `pair_series`."""
        return OfDiscs(a=self.a, R_1=self.R_1, R_2=self.R_2, **self.materials)

    @property
    def relative(self) -> float:
        return self.radius

    @property
    def radii(self) -> tuple[float, float]:
        return self.R_1, self.R_2

    @property
    def smallest(self) -> float:
        return min(self.R_1, self.R_2)

    @property
    def smallest_name(self) -> str:
        return "the upper roller's radius" if self.R_1 <= self.R_2 else "the lower roller's radius"

    def unlike(self) -> Self:
        """The rollers with a softer lower roller, under a load for which a/R is `RATIO`."""
        soft = self.model_copy(update={"E_2": SOFT * self.E_1, "nu_2": NU})
        P = math.pi / 4 * (RATIO * self.smallest) ** 2 * self.curvature / soft.softness
        return soft.model_copy(update={"F": P * self.L})

    def reference(self, level: int) -> Level:
        """Results of quarters of both rollers, and of rollers of different materials."""
        soft = {"_unlike": pair_fem(self.unlike(), level)}
        return result(pair_fem(self, level), level, ("upper.axis", "upper.middle"), soft)

    def comparisons(self) -> Iterator[Comparison]:
        """Rows: errors of Hertz's theory against the series, for equal and different materials."""
        by = TwoRollers
        yield from self.against(self.known, by.approach, (SERIES, COUPLING, SHEAR))
        soft = self.unlike()
        for q, known in zip((by.p_0, by.a), soft.known.bounded, strict=True):
            yield approximation(
                q, state=State(soft, "unlike", WHERE, displayed=False), name=at(q, WHERE),
                order=2, expected=expected(known, BOUNDED), sensitivity=SECOND,
            )  # fmt: skip
        yield self.near_hertz(self.pressure)
        yield from self.balances()

    sketch = sketches.pair


PAIR = adapted(TwoRollers)

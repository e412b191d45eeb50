"""Cases of races under n sprags: outer race loaded on its bore, inner race on its rim."""

from collections.abc import Iterator
from typing import ClassVar

from verify.case import Level, Quantity, Scan, given
from verify.cases.ring.loads import figures as drawn
from verify.cases.ring.loads import sketch as sketched
from verify.cases.ring.loads.comparisons import comparisons
from verify.cases.ring.loads.formulas import SpragLoads
from verify.cases.ring.loads.inputs import Wall
from verify.core.case import Context
from verify.core.figures import Table
from verify.form.adapter import adapted

YIELDING = 1.67  # p_0 over R_p at which a line contact yields below its surface (Tresca)
WIDE = 0.1  # a over the wall
READINGS = (
    "n is the number of sprags, N the force of one sprag; R and r are radii",
    "the race is an axially short ring (plane stress), as in Eq. 6; the half-width of the contact "
    "is that of a long roller (plane strain)",
)


class SpragRace(SpragLoads):
    """Base class of the two cases: outer race and inner race under sprags."""

    levels: ClassVar = (8, 12, 16)
    assumptions: ClassVar = (
        "linear elasticity, small strain, radial forces, no friction",
        "Hertz's pressure acts on every contact patch, along the arc; the other surface is "
        "unloaded",
        "half a pitch is modelled, with symmetry on both cuts",
    )

    comparisons = comparisons
    sketch = sketched.sketch
    figures = drawn.figures
    pictures = drawn.pictures

    def reference(self, level: int) -> Level:
        """Results of half a pitch under Hertz's pressure."""
        from verify.cases.ring.loads.reference import solve

        return solve(self, level)

    def tables(self, context: Context) -> Iterator[Table]:
        """Table of errors of wind-up and peak force of a clutch with these races."""
        yield drawn.table(self, (OuterRace(), InnerRace()) if context.is_paper else ())

    def warnings(self) -> Iterator[str]:
        """Warnings if the race yields, the contact is wide, or displacements are large."""
        if self.R_p is not None:
            limit = YIELDING * self.R_p
            if self.p_0 > limit:
                yield (
                    f"p_0 = {self.shown('p_0')} exceeds {YIELDING:g} R_p = {limit / 1e6:.4g} MPa: "
                    "the race yields below the contact"
                )
            if self.stress_scale > self.R_p:
                yield (
                    f"hoop stress {self.stress_scale / 1e6:.4g} MPa exceeds R_p = "
                    f"{self.R_p / 1e6:.4g} MPa: the race yields"
                )
        elif self.p_0 > 0.025 * self.E:
            yield (
                f"p_0 = {self.shown('p_0')} is {self.p_0 / self.E:.1%} of E: no steel withstands "
                "this pressure; enter R_p"
            )
        if (share := self.a / self.wall) > WIDE:
            yield f"a is {share:.0%} of the wall: Hertz's theory of a half-plane is not valid"
        if self.load > 0.1 * self.wall:
            yield "the race deflects by more than a tenth of its wall: strains are not small"


class OuterRace(SpragRace):
    """Eq. 6 replaces the forces of n sprags by a uniform pressure.

    Finite elements of half a pitch agree with the Fourier-series solution of the ring. Both give
    the error of Eq. 6 under a sprag and between sprags, with and without the local indentation.
    """

    id = "ring-loads-outer"
    title = "Outer race under its sprags"
    source = "huang2018"
    place = "Eq. 6, δ_BE; Table 1"
    scans: ClassVar = (Scan(vary=("n=6,12,24,48", "r_o=22mm,26.23mm,32mm,45mm")),)
    readings: ClassVar = (
        *READINGS,
        "the radius of curvature of the sprag at the outer race is not printed: the printed radius "
        "at the inner race is used",
    )
    names: ClassVar = ("R_e", "R_ed")

    r_i: float = given(
        "19.44 mm", "mm", "R_e", "bore radius", gt=0, le=1e5, claims="huang2018:table1-r-e"
    )
    r_o: float = given(
        "26.23 mm", "mm", "R_ed", "outer radius", gt=0, le=1e5, claims="huang2018:table1-r-ed"
    )

    @Quantity("δ_BE", "µm", "deflection", equation="6",
              tex=r"\frac{N n}{2 \pi l E} \left(\frac{R_{ed}^2 + R_e^2}{R_{ed}^2 - R_e^2}"
              r" + \nu\right)")  # fmt: skip
    def smeared(self) -> float:
        return self.by_smearing()


class InnerRace(SpragRace):
    """The sprags load the rim of the inner race.

    Relative to its radius, the wall of the inner race is thicker than the wall of the outer race.
    Therefore, the deflection of the inner race varies more between the sprags; Eq. 6 neglects this
    variation.
    """

    id = "ring-loads-inner"
    title = "Inner race under its sprags"
    source = "huang2018"
    place = "Eq. 6, δ_BI; Table 1"
    scans: ClassVar = (Scan(vary=("n=6,12,24,48", "r_i=4mm,7.21mm,8.5mm,9.5mm")),)
    readings: ClassVar = READINGS
    names: ClassVar = ("R_id", "R_i")
    loaded: ClassVar[Wall] = "rim"

    r_i: float = given(
        "7.21 mm", "mm", "R_id", "bore radius", gt=0, le=1e5, claims="huang2018:table1-r-id"
    )
    r_o: float = given(
        "11.11 mm", "mm", "R_i", "outer radius", gt=0, le=1e5, claims="huang2018:table1-r-i"
    )

    @Quantity("δ_BI", "µm", "deflection", equation="6",
              tex=r"\frac{N n}{2 \pi l E} \left(\frac{R_i^2 + R_{id}^2}{R_i^2 - R_{id}^2}"
              r" - \nu\right)")  # fmt: skip
    def smeared(self) -> float:
        return self.by_smearing()


OUTER, INNER = adapted(OuterRace), adapted(InnerRace)

"""A curved bar in pure bending: the formula of Winkler and Bach and finite elements."""

from collections.abc import Iterator
from math import log

from verify.case import (
    Case,
    Comparison,
    Expected,
    Level,
    Quantity,
    approximation,
    balance,
    given,
    plane_field,
    solved,
)

ART_29 = "Timoshenko, Goodier, Theory of Elasticity, art. 29: error of hyperbolic stresses"


class CurvedBar(Case):
    """Stresses at both edges of a bar of rectangular section, curved to a quarter circle."""

    title = "Bending stresses of a curved bar"
    source = "Timoshenko, Strength of Materials"
    place = "curved bars"

    r_i: float = given("100 mm", "mm", "r_i", "inner radius", gt=0)
    r_o: float = given("200 mm", "mm", "r_o", "outer radius", gt=0)
    b: float = given("10 mm", "mm", "b", "width of the section", gt=0)
    M: float = given("1000 N m", "N m", "M", "bending moment that straightens the bar", gt=0)

    @Quantity("r_n", "mm", "radius of the neutral axis", role="step")
    def r_n(self) -> float:
        return (self.r_o - self.r_i) / log(self.r_o / self.r_i)

    @Quantity("e", "mm", "distance of the neutral axis from the centroid", role="step")
    def e(self) -> float:
        return (self.r_i + self.r_o) / 2 - self.r_n

    @Quantity("σ_i", "MPa", "stress at the inner edge", safe="too high")
    def sigma_i(self) -> float:
        return self.M * (self.r_n - self.r_i) / (self.b * (self.r_o - self.r_i) * self.e * self.r_i)

    @Quantity("σ_o", "MPa", "stress at the outer edge", safe="too high")
    def sigma_o(self) -> float:
        return self.M * (self.r_n - self.r_o) / (self.b * (self.r_o - self.r_i) * self.e * self.r_o)

    def reference(self, level: int) -> Level:
        from fem.plane.material import Elastic
        from fem.plane.solve import solve_plane
        from meshes.ring.quarter import quarter_ring

        bar = solve_plane(
            quarter_ring(r_i=self.r_i, r_o=self.r_o, refine=2**level),
            materials=Elastic(E=210e9, nu=0.3), assumption="plane stress", thickness=self.b,
            supports={"x=0": {"x": lambda x: 1e-3 * x[1]}, "y=0": "y"},
        )  # fmt: skip
        force, _, moment = bar.reaction("x=0")  # at the section that rotates and stays plane
        share = -self.M / moment
        inner, outer = (share * e.mean(e.polar()[2]) for e in map(bar.on_boundary, ("bore", "rim")))
        return solved(0.5**level, plane_field(bar, "von_mises", scale=share), sigma_i=inner,
                      sigma_o=outer, force=force / moment)  # fmt: skip

    def comparisons(self) -> Iterator[Comparison]:
        most = Expected(-0.012, 0.0, ART_29) if self.r_o <= 2 * self.r_i else None
        for stress in (CurvedBar.sigma_i, CurvedBar.sigma_o):
            yield approximation(stress, order=2, expected=most, sensitivity=(0.012, ART_29))
        yield balance("force", "no normal force", "N/M", "1/mm", of={"1/r_i": 1 / self.r_i},
                      bound=1e-9, because="direct solve")  # fmt: skip

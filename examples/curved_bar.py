"""Bending stresses of a curved bar by Winkler and Bach: freewheel verify examples/curved_bar.py."""

from math import log

import verify.case as vc

SOURCE = "derived: Winkler-Bach relative to Golovin's solution (Timoshenko, Goodier: curved bars)"


class CurvedBar(vc.Case):
    """A moment straightens a bar of rectangular section; sections are assumed to remain plane."""

    title = "Bending stresses of a curved bar"
    source = "Timoshenko, Strength of Materials, part II: bending of curved bars"
    place = "Winkler-Bach, rectangular section"

    r_i: float = vc.given("50 mm", "mm", "r_i", "inner radius", gt=0)
    r_o: float = vc.given("100 mm", "mm", "r_o", "outer radius", gt=0)
    b: float = vc.given("20 mm", "mm", "b", "width", gt=0)
    M: float = vc.given("1 kN m", "N m", "M", "bending moment that straightens the bar", gt=0)

    @vc.Quantity("r_n", "mm", "radius of the neutral axis", role="step")
    def r_n(self) -> float:
        return (self.r_o - self.r_i) / log(self.r_o / self.r_i)

    @vc.Quantity("S", "mm³", "static moment b h e", role="step")
    def S(self) -> float:
        return self.b * (self.r_o - self.r_i) * ((self.r_i + self.r_o) / 2 - self.r_n)

    @vc.Quantity("σ_i", "MPa", "stress at the inside", safe="too high")
    def sigma_i(self) -> float:
        return self.M * (self.r_n - self.r_i) / (self.S * self.r_i)

    @vc.Quantity("σ_o", "MPa", "stress at the outside")
    def sigma_o(self) -> float:
        return self.M * (self.r_n - self.r_o) / (self.S * self.r_o)

    def reference(self, level: int) -> vc.Level:
        from fem.plane.material import Elastic
        from fem.plane.solve import solve_plane
        from meshes.ring.quarter import quarter_ring

        bar = solve_plane(  # rotates a section; no force results, as x is free at y = 0
            quarter_ring(r_i=self.r_i, r_o=self.r_o, refine=3 * level), thickness=self.b,
            materials=Elastic(E=210e9, nu=0.3), assumption="plane stress",
            supports={"y=0": "y", "x=0": {"x": lambda x: 1e-3 * x[1]}},
        )  # fmt: skip
        k = -self.M / bar.reaction("x=0")[2]  # scales to the moment of the inputs
        inner, outer = (k * s.mean(s.polar()[2]) for s in map(bar.on_boundary, ("bore", "rim")))
        field = vc.plane_field(bar, "hoop_stress", scale=k)
        return vc.solved(1 / level, field, sigma_i=inner, sigma_o=outer)

    def comparisons(self) -> list[vc.Comparison]:
        k, n = self.r_o / self.r_i, log(self.r_o / self.r_i)  # stresses relative to M/(b r_i²)
        a, c = (k - 1) / n, ((k**2 - 1) ** 2 - (2 * k * n) ** 2) / 4  # without the formula, whose
        b = (k - 1) * ((k + 1) / 2 - a)  # errors must not change the interval
        inside = vc.about((a - 1) / b * c / (2 * k**2 * n - k**2 + 1) - 1, 1e-3, SOURCE)
        outside = vc.about((a - k) / (b * k) * c / (2 * n - k**2 + 1) - 1, 1e-3, SOURCE)
        both = (CurvedBar.sigma_i, inside), (CurvedBar.sigma_o, outside)
        return [vc.approximation(q, order=2, expected=error) for q, error in both]

"""Two rollers in contact: formulas against finite elements. Edit, then: freewheel verify FILE."""

from collections.abc import Iterator
from math import pi, sqrt

import verify.case as vc

# source of the expected error, which uses neither the finite elements nor the formulas
SOURCE = "derived: constants of Hertz for ν = 0.3, of three digits; Hertz's theory neglects (a/R)²"


class Rollers(vc.Case):
    """Peak pressure and contact width of two parallel rollers of the same material."""

    title = "Contact of two rollers"
    source = "Roark's Formulas for Stress and Strain"
    place = "contact of two cylinders, parallel axes, both of ν = 0.3"

    # inputs: default, unit, symbol, meaning, bounds in this unit
    D_1: float = vc.given("40 mm", "mm", "D_1", "diameter of the lower roller", gt=0)
    D_2: float = vc.given("20 mm", "mm", "D_2", "diameter of the upper roller", gt=0)
    P: float = vc.given("300 N/mm", "N/mm", "P", "load per length", gt=0)
    E: float = vc.given("110 GPa", "GPa", "E", "Young's modulus", gt=0)
    nu: float = vc.given(0.35, "1", "ν", "Poisson's ratio", ge=0, lt=0.45)

    @vc.Quantity("p_0", "MPa", "peak pressure", safe="too high")
    def p_0(self) -> float:
        return 0.591 * sqrt(self.P * self.E * (self.D_1 + self.D_2) / (self.D_1 * self.D_2))

    @vc.Quantity("b", "mm", "width of contact", safe="too low")
    def b(self) -> float:
        return 2.15 * sqrt(self.P / self.E * self.D_1 * self.D_2 / (self.D_1 + self.D_2))

    def a(self) -> float:
        """Half-width of contact [m] by Hertz; determines the mesh and the expected error (a/R)²."""
        soft = 4 * (1 - self.nu**2) / (pi * self.E)
        return sqrt(soft * self.P * self.D_1 * self.D_2 / (self.D_1 + self.D_2))

    def reference(self, level: int) -> vc.Level:
        """Finite elements: right halves of the rollers, plane strain; `level` 1 is the coarsest."""
        from fem.contact import pairs, problem
        from fem.plane.material import Elastic
        from meshes import join
        from meshes.contact.disc import quarter_disc

        zone = 1.5 * self.a()
        touch = problem.ContactProblem(
            join.join({"low": quarter_disc(R=self.D_1 / 2, zone=zone, refine=level, below=True),
                       "top": quarter_disc(R=self.D_2 / 2, zone=zone, refine=level)}),
            materials=Elastic(E=self.E, nu=self.nu), assumption="plane strain",
            supports={"low.axis": "x", "low.middle": "y", "top.axis": "x"},
            contacts=[pairs.Pair(slave="top.surface", master="low.surface")],
        ).solve(forces={"top.middle": (0.0, -self.P / 2)}).touches[0]  # fmt: skip
        return vc.solved(1 / level, p_0=touch.peak, b=2 * touch.half_width((0.0, 0.0)))

    def comparisons(self) -> Iterator[vc.Comparison]:
        """Comparisons; expected errors are stated before the reference is solved."""
        k, curved = sqrt((1 - self.nu**2) / 0.91), (2 * self.a() / min(self.D_1, self.D_2)) ** 2
        for q, e, digits in ((Rollers.p_0, k, 5e-4 / 0.591), (Rollers.b, 1 / k, 5e-3 / 2.15)):
            yield vc.approximation(q, order=2, expected=vc.about(e - 1, digits + curved, SOURCE))

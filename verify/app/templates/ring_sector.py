"""A ring on rollers: formulas and a finite-element sector. Edit, then: freewheel verify FILE."""

from collections.abc import Iterator
from math import cos, pi, sin

import verify.case as vc

# source of the expected error, which uses neither the finite elements nor the formulas
MEAN = "derived: by Betti's theorem, the mean growth is Lamé's for any distribution of the load"
FORCE = "derived: half a pitch is in equilibrium, N sin(π/n) = F/2"


class RingOnRollers(vc.Case):
    """Rollers push a ring outwards; thin-ring theory replaces them by a uniform pressure."""

    title = "Ring on rollers"
    source = "Roark's Formulas for Stress and Strain"
    place = "thin ring under a uniform radial load"

    n: int = vc.count(8, "n", "number of rollers", ge=3)
    r_i: float = vc.given("50 mm", "mm", "r_i", "inner radius", gt=0)
    r_o: float = vc.given("60 mm", "mm", "r_o", "outer radius", gt=0)
    w: float = vc.given("20 mm", "mm", "w", "width", gt=0)
    F: float = vc.given("5 kN", "kN", "F", "force of a roller", gt=0)
    c: float = vc.given("1 mm", "mm", "c", "half of the arc on which a roller presses", gt=0)
    E: float = vc.given("210 GPa", "GPa", "E", "Young's modulus", gt=0)
    nu: float = vc.given(0.3, "1", "ν", "Poisson's ratio", ge=0, lt=0.5)

    @vc.Quantity("N", "kN", "hoop force between the rollers", safe="too high")
    def N(self) -> float:
        return self.n * self.F / (2 * pi)

    @vc.Quantity("u", "µm", "mean growth of the bore", safe="too high")
    def u(self) -> float:
        return self.N * (self.r_i + self.r_o) / (2 * self.E * self.w * (self.r_o - self.r_i))

    def reference(self, level: int) -> vc.Level:
        """Finite elements: half a pitch in plane stress, between two planes of symmetry."""
        from fem.plane.material import Elastic
        from fem.plane.solve import solve_plane
        from meshes.ring.sector import half_sector

        ring = solve_plane(
            half_sector(r_i=self.r_i, r_o=self.r_o, n=self.n, loaded="bore", patch=self.c,
                        refine=level), thickness=self.w,
            materials=Elastic(E=self.E, nu=self.nu), assumption="plane stress",
            supports={"load cut": "n", "free cut": "n"},
            pressures={"patch": self.F / (2 * self.c * self.w)},
        )  # fmt: skip
        u, x, y = ring.on_boundary("bore"), *ring.reaction("free cut")[:2]
        hoop = y * cos(pi / self.n) - x * sin(pi / self.n)
        return vc.solved(1 / level, vc.plane_field(ring, "stress"), N=hoop, u=u.mean(u.polar()[0]))

    def comparisons(self) -> Iterator[vc.Comparison]:
        """Comparisons; expected errors are stated before the reference is solved."""
        q, k, (o, i) = RingOnRollers, pi / self.n, (self.r_o, self.r_i)
        lame = (o**2 + i**2) / (o**2 - i**2) + self.nu  # u E/(p r_i) at the bore
        growth = (i + o) / (2 * (o - i)) / lame - 1
        yield vc.approximation(q.N, order=2, expected=vc.about(sin(k) / k - 1, 1e-3, FORCE))
        yield vc.approximation(q.u, order=2, expected=vc.about(growth, 1e-3, MEAN))

"""Rate of a leaf spring, a clamped strip: freewheel verify examples/leaf_spring.py."""

from collections.abc import Iterator
from math import sqrt

import numpy as np

import verify.case as vc

SOURCE = (
    "derived: the complementary energy of the beam's stresses and a parabolic shear stress bounds "
    "the flexibility from above; the potential energy of u = -y w', v = w + (1 - exp(-x/l)) ν y² "
    "w''/2 with the optimal l bounds it from below"
)


class LeafSpring(vc.Case):
    """A leaf is clamped at one end and loaded at the other; it bends as a beam without shear."""

    title = "Rate of a leaf spring"
    source = "Wahl, Mechanical Springs: flat springs"
    place = "cantilever of constant section"

    L: float = vc.given("100 mm", "mm", "L", "free length", gt=0)
    b: float = vc.given("20 mm", "mm", "b", "width", gt=0)
    t: float = vc.given("5 mm", "mm", "t", "thickness", gt=0)
    E: float = vc.given("206 GPa", "GPa", "E", "Young's modulus", gt=0)
    nu: float = vc.given(0.3, "1", "ν", "Poisson's ratio", ge=0, lt=0.5)

    @vc.Quantity("R", "N/mm", "rate without shear", safe="too low")
    def R(self) -> float:
        return self.E * self.b * self.t**3 / (4 * self.L**3)

    @vc.Quantity("R_τ", "N/mm", "rate with shear", safe="too low", source="Timoshenko's beam")
    def R_shear(self) -> float:
        return self.R / (1 + 0.6 * (1 + self.nu) * (self.t / self.L) ** 2)

    def reference(self, level: int) -> vc.Level:
        from fem.plane.material import Elastic
        from fem.plane.solve import solve_plane
        from meshes.contact.block import block

        y, tau = self.t / 2, 1.5 / (self.b * self.t)  # for a force of 1 N
        leaf = solve_plane(
            block(x=(0, self.L), y=(-y, y), nx=20 * level, ny=2 * level),
            materials=Elastic(E=self.E, nu=self.nu), assumption="plane stress", thickness=self.b,
            supports={"left": "xy"},
            tractions={"right": lambda x: np.stack([0 * x[1], tau * (1 - (x[1] / y) ** 2)])},
        )  # fmt: skip
        rate = -1 / (2 * leaf.potential_energy)
        return vc.solved(1 / level, vc.plane_field(leaf, "von_mises"), R=rate, R_shear=rate)

    def comparisons(self) -> Iterator[vc.Comparison]:
        s, q = self.t / self.L, 3 / (160 * (1 + self.nu))
        more = 3 * self.nu**2 * s * (sqrt(q / (1 - self.nu**2)) + q * s)  # energy, relative to beam
        shear = 1 + 0.6 * (1 + self.nu) * s**2  # largest flexibility, relative to beam
        for rate, f in ((LeafSpring.R, 1.0), (LeafSpring.R_shear, shear)):
            expected = vc.Expected(1 / (1 + more) / f - 1, shear / f - 1, SOURCE)
            yield vc.approximation(rate, order=1.5, expected=expected)

"""A curved cantilever: a formula against beam elements. Edit it, then: freewheel verify FILE."""

from collections.abc import Iterator
from math import pi

import numpy as np

import verify.case as vc

# source of the expected error, which uses neither the finite elements nor the formula
SOURCE = (
    "derived by Castigliano: a force P at the end gives M = P R sin θ, N = P sin θ, V = P cos θ; "
    "the sum of their energies is the energy of M times 1 + I/(A R²) (1 + E/(κ G))"
)


class CurvedCantilever(vc.Case):
    """Spring rate of a strip bent to a quarter circle, from the energy of bending only."""

    title = "Rate of a curved cantilever"
    source = "Wahl, Mechanical Springs"
    place = "curved flat springs, thin strip"

    # inputs: default, unit, symbol, meaning, bounds in this unit
    R: float = vc.given("40 mm", "mm", "R", "radius of the centre line", gt=0)
    t: float = vc.given("8 mm", "mm", "t", "thickness", gt=0)
    w: float = vc.given("20 mm", "mm", "w", "width", gt=0)
    E: float = vc.given("206 GPa", "GPa", "E", "Young's modulus", gt=0)
    nu: float = vc.given(0.3, "1", "ν", "Poisson's ratio", ge=0, lt=0.5)

    # formulas in SI units; a "step" is not compared; an error on the safe side is harmless
    @vc.Quantity("I", "mm^4", "second moment of area", role="step")
    def I(self) -> float:  # noqa: E743 - as in books
        return self.w * self.t**3 / 12

    @vc.Quantity("k", "N/mm", "rate", equation="1", safe="too low")
    def k(self) -> float:
        return 4 * self.E * self.I / (pi * self.R**3)

    def reference(self, level: int) -> vc.Level:
        """Spring rate by curved Timoshenko elements; their number increases with the level."""
        from fem.beam.curved import solve_curved_frame
        from fem.beam.section import Section

        n, area = 2 * level, self.w * self.t  # elements, with a node in the middle of each
        theta = np.linspace(0, pi / 2, 2 * n + 1)
        nodes = 2 * np.arange(n)
        strip = Section(EA=self.E * area, EI=self.E * area * self.t**2 / 12,
                        GA=5 / 6 * self.E * area / (2 * (1 + self.nu)))  # fmt: skip
        frame = solve_curved_frame(
            self.R * np.array([np.cos(theta), np.sin(theta)]).T,
            np.array([nodes, nodes + 2, nodes + 1]).T,
            sections=strip, supports={2 * n: "xyr"}, loads={0: (1.0, 0.0, 0.0)},
        )  # fmt: skip
        return vc.solved(1 / level, k=1 / float(frame.u[0, 0]))

    def comparisons(self) -> Iterator[vc.Comparison]:
        """Comparisons; expected errors are stated before the reference is solved."""
        error = (self.t / self.R) ** 2 / 12 * (1 + 2.4 * (1 + self.nu))  # κ = 5/6
        yield vc.approximation(CurvedCantilever.k, order=4, expected=vc.about(error, 1e-3, SOURCE))

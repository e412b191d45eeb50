"""Hoop stress of a pipe: formula against finite elements. Edit, then: freewheel verify FILE."""

from collections.abc import Iterator

import verify.case as vc

# source of the expected error, independent of the finite elements and of the formula
SOURCE = "derived: Barlow's mean stress over Lamé's largest is (1 + r_i/r_o)²/(1 + (r_i/r_o)²)/2"


class Pipe(vc.Case):
    """Hoop stress of a pipe under internal pressure by Barlow's formula."""

    title = "Hoop stress of a pipe"  # title of the page
    source = "Textbook on pressure vessels"  # citation of a book, a standard or a paper
    place = "Barlow's formula"

    # inputs: default, unit, symbol, meaning, bounds in this unit
    r_i: float = vc.given("50 mm", "mm", "r_i", "inner radius", gt=0)
    r_o: float = vc.given("55 mm", "mm", "r_o", "outer radius", gt=0)
    p: float = vc.given("10 MPa", "MPa", "p", "inner pressure", gt=0)

    # formulas in SI units, with symbol, displayed unit and meaning. An error on the safe side
    # causes no harm. A "step" is an intermediate value, which is not compared.
    @vc.Quantity("s", "mm", "wall", role="step")
    def s(self) -> float:
        return self.r_o - self.r_i

    @vc.Quantity("σ", "MPa", "hoop stress", equation="1", safe="too high")
    def sigma(self) -> float:
        return self.p * (self.r_i + self.r_o) / (2 * self.s)

    def reference(self, level: int) -> vc.Level:
        """Hoop stress by finite elements on the mesh of `level`, independent of the formula."""
        from fem.plane.material import Elastic
        from fem.plane.solve import solve_plane
        from meshes.ring.quarter import quarter_ring

        pipe = solve_plane(
            quarter_ring(r_i=self.r_i, r_o=self.r_o, refine=level),
            materials=Elastic(E=210e9, nu=0.3), assumption="plane strain",
            supports={"x=0": "x", "y=0": "y"}, pressures={"bore": self.p},
        )  # fmt: skip
        bore = pipe.on_boundary("bore")
        force = pipe.reaction("x=0")[0] + self.p * self.r_i  # on a wall, and pressure on it
        # mesh size, fields for pictures, then numbers by the names of the quantities
        field, stress = vc.plane_field(pipe, "von_mises"), bore.mean(bore.polar()[2])
        return vc.solved(1 / level, field, sigma=stress, rest=force)

    def comparisons(self) -> Iterator[vc.Comparison]:
        """Comparisons; expected errors are stated before the reference is solved."""
        k = self.r_i / self.r_o
        error = (1 + k) ** 2 / (2 * (1 + k**2)) - 1  # (formula - exact)/exact
        expected = vc.Expected(error - 1e-3, error + 1e-3, SOURCE)
        yield vc.approximation(Pipe.sigma, order=2, expected=expected)
        yield vc.balance(
            "rest", "balance of a wall with the pressure", "ΣF_x", "N/mm",
            of={"p r_i": self.p * self.r_i}, bound=1e-9, because="direct solve",
        )  # fmt: skip

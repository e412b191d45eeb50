"""A rotating disc: a formula against finite elements. Edit it, then: freewheel verify FILE."""

from collections.abc import Iterator

import numpy as np

import verify.case as vc

# source of the expected error, which uses neither the finite elements nor the formula
SOURCE = (
    "derived: Timoshenko, Goodier, Theory of Elasticity: rotating disc as a three-dimensional "
    "problem, exact except for edge stresses, which vanish within a thickness"
)


class Disc(vc.Case):
    """Stress at the centre of a solid rotating disc, by the theory of thin discs."""

    title = "Stress of a rotating disc"
    source = "Timoshenko, Strength of Materials, part II"
    place = "rotating disc of constant thickness"

    # inputs: default, unit, symbol, meaning, bounds in this unit
    R: float = vc.given("100 mm", "mm", "R", "outer radius", gt=0)
    h: float = vc.given("50 mm", "mm", "h", "thickness", gt=0)
    n: float = vc.given("20000 r/min", "r/min", "n", "speed", gt=0)
    rho: float = vc.given("7850 kg/m^3", "kg/m^3", "ρ", "density", gt=0)
    nu: float = vc.given(0.3, "1", "ν", "Poisson's ratio", ge=0, lt=0.5)

    # a formula in SI units, with symbol, displayed unit and meaning; an error on the safe side
    # causes no harm
    @vc.Quantity("σ", "MPa", "stress in the middle", equation="1", safe="too high")
    def sigma(self) -> float:
        return (3 + self.nu) / 8 * self.rho * (self.n * self.R) ** 2

    def reference(self, level: int) -> vc.Level:
        """Stress at the centre by finite elements; mesh: upper half of the meridian section."""
        from fem.plane.material import Elastic
        from fem.plane.solve import solve_plane
        from meshes.revolution.section import section

        r, z = np.linspace(0, self.R, 8 * level + 1), np.linspace(0, self.h / 2, 2 * level + 1)
        pull = self.rho * self.n**2  # n is in rad/s here
        disc = solve_plane(
            section(r=r, z=z), degree=2, materials=Elastic(E=210e9, nu=self.nu),
            assumption="axisymmetric", supports={"start": "y"},
            body_forces=lambda x: np.stack([pull * x[0], 0 * x[1]]),
        )  # fmt: skip
        stress = float(disc.at(np.zeros((2, 1))).stress[0, 0])
        return vc.solved(1 / level, vc.plane_field(disc, "von_mises"), sigma=stress)

    def comparisons(self) -> Iterator[vc.Comparison]:
        """Comparisons; expected errors are stated before the reference is solved."""
        nu, thick = self.nu, (self.h / (2 * self.R)) ** 2
        more = nu * (1 + nu) / (6 * (1 - nu)) * thick  # stress over ρ ω² R²
        error = -more / ((3 + nu) / 8 + more)
        yield vc.approximation(Disc.sigma, order=2, expected=vc.about(error, 1e-3, SOURCE))

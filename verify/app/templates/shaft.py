"""Bending frequency of a shaft: formula against rotor model. Edit, then: freewheel verify FILE."""

from collections.abc import Iterator
from math import pi, sqrt

import verify.case as vc

# source of the expected error, which uses neither the finite elements nor the formula
SOURCE = (
    "derived: Timoshenko's beam also bends as sin(πx/L); its ω² is the smaller root of "
    "(κ G k² - ρ ω²)(E I k² + κ G A - ρ I ω²) = (κ G k)² A with k = π/L, κ by Hutchinson (2001)"
)


class Shaft(vc.Case):
    """First bending frequency of a short shaft on rigid bearings, by Euler-Bernoulli theory."""

    title = "First bending frequency of a shaft"
    source = "Den Hartog, Mechanical Vibrations"
    place = "uniform beam, hinged at both ends"

    # inputs: default, unit, symbol, meaning, bounds in this unit
    L: float = vc.given("400 mm", "mm", "L", "distance of the bearings", gt=0)
    d_o: float = vc.given("60 mm", "mm", "d_o", "outer diameter", gt=0)
    E: float = vc.given("210 GPa", "GPa", "E", "Young's modulus", gt=0)
    nu: float = vc.given(0.3, "1", "ν", "Poisson's ratio", ge=0, lt=0.5)
    rho: float = vc.given("7850 kg/m^3", "kg/m^3", "ρ", "density", gt=0)

    # a formula in SI units, with symbol, displayed unit and meaning; an error on the safe side
    # causes no harm
    @vc.Quantity("f_1", "Hz", "first bending frequency", equation="1", safe="too low")
    def f_1(self) -> float:
        return pi * self.d_o / (8 * self.L**2) * sqrt(self.E / self.rho)

    def reference(self, level: int) -> vc.Level:
        """First bending frequency by Timoshenko elements; their number increases with the level."""
        from fem.rotor import model, modes

        steel = model.Material(self.E, self.nu, self.rho)
        pieces = [model.Element(self.L / 4, self.d_o, 0.0, steel)] * 4
        rigid = 1e6 * self.E * self.d_o**4 / self.L**3  # stiffness of a bearing
        rotor = model.Rotor(
            [model.Shaft(pieces)], supports=[model.Support(0, rigid), model.Support(4, rigid)],
            refine=level,
        )  # fmt: skip
        omega = float(modes.modes(rotor, count=1).frequencies[0])
        return vc.solved(1 / level, f_1=omega / (2 * pi))

    def comparisons(self) -> Iterator[vc.Comparison]:
        """Comparisons; expected errors are stated before the reference is solved."""
        nu, s = self.nu, (pi * self.d_o / (4 * self.L)) ** 2  # k² I/A
        kappa = 6 * (1 + nu) ** 2 / (7 + 12 * nu + 4 * nu**2)
        g = 2 * (1 + nu) / kappa  # E/(κ G); with x = ρ ω²/(E k²) it is x² g s - x (1 + s + g s) + s
        b = 1 + s + g * s
        x = 2 * s / (b + sqrt(b**2 - 4 * g * s**2))
        expected = vc.about(sqrt(s / x) - 1, 1e-3, SOURCE)
        yield vc.approximation(Shaft.f_1, order=2, expected=expected)

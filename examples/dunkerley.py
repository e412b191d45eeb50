"""Critical speed by Dunkerley: freewheel verify examples/dunkerley.py."""

from math import pi, sqrt

import numpy as np

import verify.case as vc

SOURCE = "derived: Dunkerley's sum is an upper, Rayleigh's quotient a lower bound of the true 1/ω²"


class Dunkerley(vc.Case):
    """A slender shaft on two equal bearings carries two discs, treated as point masses."""

    title = "Critical speed by Dunkerley"
    source = "Den Hartog, Mechanical Vibrations: Dunkerley's formula"
    place = "two masses, the shaft and its bearings"

    L: float = vc.given("1 m", "mm", "L", "distance of the bearings", gt=0)
    d: float = vc.given("50 mm", "mm", "d", "diameter of the shaft", gt=0)
    a_1: float = vc.given("450 mm", "mm", "a_1", "position of the first disc", gt=0)
    a_2: float = vc.given("550 mm", "mm", "a_2", "position of the second disc", gt=0)
    m_1: float = vc.given("40 kg", "kg", "m_1", "mass of the first disc", gt=0)
    m_2: float = vc.given("60 kg", "kg", "m_2", "mass of the second disc", gt=0)
    k: float = vc.given("100 N/µm", "N/µm", "k", "stiffness of a bearing", gt=0)
    B: float = vc.given("64.4 kN m^2", "kN m^2", "B", "bending stiffness of the shaft", gt=0)
    m_s: float = vc.given("15.4 kg", "kg", "m_s", "mass of the shaft", gt=0)

    @vc.Quantity("n_D", "r/min", "critical speed by Dunkerley", safe="too low")
    def n_D(self) -> float:
        terms = self.m_s * (self.L**3 / (pi**4 * self.B) + 1 / (2 * self.k))  # each mass alone
        for m, a in ((self.m_1, self.a_1), (self.m_2, self.a_2)):
            bend = (a * (self.L - a)) ** 2 / (3 * self.B * self.L)
            terms += m * (bend + (a**2 + (self.L - a) ** 2) / (self.k * self.L**2))
        return 1 / sqrt(terms)

    def reference(self, level: int) -> vc.Level:
        from fem.rotor import critical, model, parts

        area = pi * self.d**2 / 4
        steel = parts.Material(self.B * 16 / (area * self.d**2), rho=self.m_s / (self.L * area))
        lengths = self.a_1, self.a_2 - self.a_1, self.L - self.a_2
        rotor = model.Rotor(
            [model.Shaft([model.Element(s, self.d, 0, steel) for s in lengths])],
            [model.Disc(1, self.m_1), model.Disc(2, self.m_2)],
            [model.Support(0, self.k), model.Support(3, self.k)], refine=level, theory="euler",
        )  # fmt: skip
        n = float(critical.critical_speeds(rotor, count=1).speeds[0])
        return vc.solved(1 / level, n_D=n)

    def comparisons(self) -> list[vc.Comparison]:
        x, m = np.array([self.a_1, self.a_2]) / self.L, np.array([self.m_1, self.m_2])
        soft = self.B / (self.k * self.L**3)  # flexibility of bearings; 1/ω² relative to L³/B
        low = m @ ((x * (1 - x)) ** 2 / 3 + soft * (x**2 + (1 - x) ** 2))
        low += self.m_s * (1 / pi**4 + soft / 2)  # Dunkerley's sum
        c = pi**3 * soft  # Rayleigh's quotient of sin(πx) + c; c balances the bearing forces
        mass = m @ (np.sin(pi * x) + c) ** 2 + self.m_s * (1 / 2 + 4 * c / pi + c**2)
        error = sqrt(mass / (pi**4 / 2 + 2 * c**2 / soft) / low) - 1
        expected = vc.Expected(error, 0, SOURCE)
        return [vc.approximation(Dunkerley.n_D, order=4, expected=expected)]

"""Critical speed between Dunkerley and Rayleigh: freewheel verify examples/dunkerley.py."""

from math import pi, sin, sqrt

import verify.case as vc

SOURCE = "derived: Dunkerley's sum is never below, Rayleigh's quotient never above the true 1/ω²"


class Dunkerley(vc.Case):
    """A slender shaft on two alike bearings carries two discs, which count as point masses."""

    title = "Critical speed by Dunkerley"
    source = "Den Hartog, Mechanical Vibrations: Dunkerley's formula and Rayleigh's method"
    place = "two masses, the shaft and its bearings"

    L: float = vc.given("1 m", "mm", "L", "distance of the bearings", gt=0)
    d: float = vc.given("50 mm", "mm", "d", "diameter of the shaft", gt=0)
    a_1: float = vc.given("450 mm", "mm", "a_1", "place of the first disc", gt=0)
    a_2: float = vc.given("550 mm", "mm", "a_2", "place of the second disc", gt=0)
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

    @vc.Quantity("n_R", "r/min", "critical speed by Rayleigh", safe="too low")
    def n_R(self) -> float:
        c = pi**3 * self.B / (self.k * self.L**3)  # of the bearings; a sine of the shaft
        s_1, s_2 = c + sin(pi * self.a_1 / self.L), c + sin(pi * self.a_2 / self.L)
        mass = self.m_s * (1 / 2 + 4 * c / pi + c**2) + self.m_1 * s_1**2 + self.m_2 * s_2**2
        return sqrt((pi**4 * self.B / (2 * self.L**3) + 2 * self.k * c**2) / mass)

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
        return vc.solved(1 / level, n_D=n, n_R=n)

    def comparisons(self) -> list[vc.Comparison]:
        n_D = vc.Expected(self.n_D / self.n_R - 1, 0, SOURCE)
        n_R = vc.Expected(0, self.n_R / self.n_D - 1, SOURCE)
        both = (Dunkerley.n_D, n_D), (Dunkerley.n_R, n_R)
        return [vc.approximation(q, order=4, expected=e) for q, e in both]

r"""Expected errors of Hertz's theory and of the ring's Fourier series, for rollers on a ring.

If the materials of two bodies differ (Dundurs' beta), normal and tangential displacements are
coupled along the contact line of curvature kappa. To first order, the half-width increases by the
fraction 64/(45 pi) beta kappa a, and the pressure in the middle decreases by the fraction (2 G -
1/3)/pi beta kappa a, with Catalan's constant G. The tolerance is an estimate: (2 a/d)² for the
curvatures, (a/wall)², and 1e-3, each with the factor 1.

Errors are formula/true value - 1. All bodies are in plane stress.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, sec. 5.4.
"""

from dataclasses import dataclass

import numpy as np

CATALAN = 0.915965594177219
BLUNT = 1e-3  # least error of Hertz's semi-ellipse
PEAK_STRESS = 2e-3  # over a largest stress: the polynomial along the fillet and the mesh error
WIDTH = 64 / (45 * np.pi)  # first terms of beta kappa a: of the half-width,
PEAK = -(2 * CATALAN - 1 / 3) / np.pi  # and of the pressure in the middle

Interval = tuple[float, float]


@dataclass(frozen=True, kw_only=True)
class RollerOnRing:
    """Roller of diameter d between a ring and a rigid race; SI units; `E` is the modulus E'.

    `apothem` is the distance of the flats of the ring from its axis, d_e its outer diameter, j_D
    the diametral clearance. Ring and roller have the same material.
    """

    d: float
    d_e: float
    j_D: float
    apothem: float
    E: float
    nu: float

    @property
    def wall(self) -> float:
        """Thickness of the ring under the roller [m]."""
        return self.d_e / 2 - self.apothem

    @property
    def relative_radius(self) -> float:
        """Relative radius of roller and ring [m]."""
        return 1 / (1 / (self.d / 2) + 1 / (self.d_e / 2))

    def reach(self, a: float, a_race: float = 0.0) -> float:
        """Relative tolerance of forces by the series; half-widths [m] a (ring), a_race (race)."""
        beside = (2 * a / self.d) ** 2 + (2 * a_race / self.d) ** 2
        return beside + (a / self.wall) ** 2 + BLUNT

    def closure(self, a: float, a_race: float) -> float:
        """Relative tolerance of approaches by the series; half-widths [m] a (ring), a_race."""
        ends = a**2 + a_race**2
        return 4 * ends / self.d**2 + (a / self.wall) ** 2 + BLUNT

    def on_ring(self, first: float, a: float, *, elastic: bool = False) -> Interval:
        """Interval of the error of Hertz's half-width or peak pressure of the contact on the ring.

        The expected error is `first` times beta kappa a, for a rigid or an `elastic` roller. The
        tolerance is an estimate that contains strain and bending of the ring when the clearance is
        closed.
        """
        R = self.relative_radius
        straining = self.j_D / self.d_e * (1 + R / (self.d_e / 2 - self.apothem))
        roller = self.E if elastic else np.inf
        coupled = self.coupled(a, R_2=self.d_e / 2, E_1=roller, E_2=self.E)
        return about(1 / (1 + first * coupled) - 1, self.reach(a) + straining)

    def on_race(self, a: float) -> Interval:
        """Interval of the error of Hertz's half-width of the elastic roller in the rigid race."""
        race = self.d_e / 2 + self.d + self.j_D / 2
        coupled = self.coupled(a, R_2=-race, E_1=self.E, E_2=np.inf)
        return about(1 / (1 + WIDTH * coupled) - 1, (2 * a / self.d) ** 2 + BLUNT)

    def bent(self, *, R_b: float, e: float) -> float:
        """Relative change of the half-width by bending of the wall as a beam of the length 2 e.

        R_b is the hub force per length. It changes the curvature of the ring by R_b e/(2 E I). The
        half-width is proportional to the root of the relative radius.
        """
        return self.relative_radius * (R_b * e / 2) / (self.E * self.wall**3 / 12) / 2

    def fillet_blur(self, rollers: float, a: float) -> float:
        """Relative uncertainty of the largest fillet stress; `rollers`: fraction due to rollers."""
        return (PEAK_STRESS + rollers * self.reach(a)) / 2

    def coupled(self, a: float, *, R_2: float, E_1: float, E_2: float) -> float:
        """Value of beta kappa a for the roller (body 1) on a surface of radius R_2 [m].

        >>> roller = RollerOnRing(d=2.0, d_e=8.0, j_D=0.01, apothem=3.0, E=1.0, nu=0.5)
        >>> roller.coupled(0.1, R_2=4.0, E_1=np.inf, E_2=1.0)  # beta (1 - nu)/2, kappa 1/R_1
        0.025
        """
        soft_1, soft_2 = 1 / E_1, 1 / E_2
        beta = ((1 - self.nu) * soft_2 - (1 - self.nu) * soft_1) / (2 * (soft_1 + soft_2))
        E_star = 1 / (soft_1 + soft_2)
        kappa = E_star / E_2 / (self.d / 2) - E_star / E_1 / R_2
        return beta * kappa * a


def about(m: float, slack: float) -> Interval:
    """Interval m - `slack` to m + `slack` of an error."""
    return m - slack, m + slack


def over_series(value: float, series: float, slack: float) -> Interval:
    """Interval of the error of `value`, if `series` has a relative error of at most `slack`.

    >>> [round(m, 6) for m in over_series(3.0, 2.0, 0.01)]
    [0.485, 0.515]
    """
    m = value / series - 1
    return m - (1 + m) * slack, m + (1 + m) * slack

"""Errors of Hertz's line contact for two elastic bodies of finite size.

Each estimate contains the expected signed error of Hertz's value, and the tolerance of this error.
The coefficients of `pair_series` and `shear_series` give the error from dimensions, materials and
Hertz's half-width a. The coefficients of the next terms are not known; these terms are included in
the tolerance with the factor 1. e is the ratio of a to the smallest dimension. Range: small e, no
friction, plane strain.
"""

from dataclasses import dataclass
from functools import cached_property
from math import pi

from analytic.bounds.contact.estimate import Estimate
from analytic.bounds.contact.line import of_shear
from analytic.contact import pair_series
from analytic.contact.checks import Assumption
from analytic.contact.partial_slip import dundurs_beta

# for the coupling between different materials, as in `pair_series`
COUPLED_PRESSURE = -(2 * pair_series.CATALAN - 1 / 3) / pi
COUPLED_WIDTH = 64 / (45 * pi)
PLANE: Assumption = "plane strain"


@dataclass(frozen=True, kw_only=True)
class TwoBodies:
    """Roller of radius R_1 above a body of radius R_2, which is negative for a bore."""

    a: float
    R_1: float
    R_2: float
    E_1: float
    nu_1: float
    E_2: float
    nu_2: float

    @property
    def materials(self) -> dict[str, float]:
        """Young's moduli and Poisson's ratios of both bodies by name."""
        return {"E_1": self.E_1, "nu_1": self.nu_1, "E_2": self.E_2, "nu_2": self.nu_2}

    @cached_property
    def kappa(self) -> float:
        """Curvature of the deformed contact surface [1/m]."""
        return pair_series.meeting_curvature(
            R_1=self.R_1, R_2=self.R_2, **self.materials, assumption=PLANE
        )


@dataclass(frozen=True, kw_only=True)
class OfDiscs(TwoBodies):
    """Two discs, each pressed from both sides."""

    @property
    def e(self) -> float:
        """Ratio of the half-width a to the smaller radius [1]."""
        return self.a / min(self.R_1, self.R_2)

    @cached_property
    def series(self) -> tuple[pair_series.Excess, pair_series.Excess]:
        """Relative excess of the true pressure and half-width over Hertz's values."""
        sizes = {"a": self.a, "R_1": self.R_1, "R_2": self.R_2}
        return pair_series.excess(**sizes, **self.materials, assumption=PLANE)

    @property
    def coupled(self) -> float:
        """Sum of the first-order effects [1] of unequal materials on pressure and on half-width."""
        return abs(self.series[0].first) + abs(self.series[1].first)

    @property
    def pressure(self) -> Estimate:
        """Expected error of the peak pressure, from the asymptotic series.

        The tolerance contains the square of the terms of the series, and the first-order term times
        a/R.
        """
        return self._second_order(self.series[0])

    @property
    def width(self) -> Estimate:
        """Expected error of the half-width."""
        return self._second_order(self.series[1])

    @property
    def bounded(self) -> tuple[Estimate, Estimate]:
        """Expected errors of pressure and half-width; tolerance: bound of the neglected terms."""
        sizes = {"a": self.a, "R_1": self.R_1, "R_2": self.R_2}
        slack = pair_series.left_out(**sizes, **self.materials, assumption=PLANE)
        p, w = (Estimate(1 / (1 + one.total) - 1, slack) for one in self.series)
        return p, w

    @property
    def approach(self) -> Estimate:
        """Expected error of the approach: zero; the tolerance is e²/2 plus `coupled`."""
        return Estimate(0.0, self.e**2 / 2 + self.coupled)

    @property
    def shear(self) -> Estimate:
        """Expected error of the largest shear stress; the tolerance is e² plus `coupled`.

        For equal discs, the term of order e² is 0.57 e².
        """
        inclined, slack = self.kappa * self.a, self.e**2 + self.coupled
        return of_shear(a=self.a, R=self.R_1, inclined=inclined, slack=slack)

    def _second_order(self, excess: pair_series.Excess) -> Estimate:
        slack = (self.coupled + self.e**2) ** 2 + self.coupled * self.e
        return Estimate(1 / (1 + excess.total) - 1, slack)


@dataclass(frozen=True, kw_only=True)
class InRace(TwoBodies):
    """Roller in the bore of a race of thickness `wall` with a fixed rim."""

    wall: float

    @property
    def small(self) -> float:
        """Size [1] of the effects of curvature and fixed rim: (a/R)² + (a/wall)²."""
        return float((self.a / self.R_1) ** 2 + (self.a / self.wall) ** 2)

    @property
    def coupled(self) -> float:
        """First-order effect beta kappa a [1] of different materials on pressure and half-width."""
        return float(dundurs_beta(**self.materials, assumption=PLANE)) * self.kappa * self.a

    @property
    def pressure(self) -> Estimate:
        """Expected error of the peak pressure."""
        return self._coupled(COUPLED_PRESSURE)

    @property
    def width(self) -> Estimate:
        """Expected error of the half-width."""
        return self._coupled(COUPLED_WIDTH)

    @property
    def approach(self) -> Estimate:
        """Expected error of the approach: zero; the tolerance is `small`/2 plus `|coupled|`.

        The bracket of the approach, 2 ln(...) + ..., is at least 2. Therefore, an error `small` of
        the bracket is at most the fraction `small`/2 of the approach.
        """
        return Estimate(0.0, self.small / 2 + abs(self.coupled))

    @property
    def shear(self) -> Estimate:
        """Expected error of the largest shear stress; the tolerance is `small` plus `|coupled|`."""
        inclined, slack = self.kappa * self.a, self.small + abs(self.coupled)
        return of_shear(a=self.a, R=self.R_1, inclined=inclined, slack=slack)

    def _coupled(self, factor: float) -> Estimate:
        slack = self.small + abs(self.coupled) * self.a / min(self.R_1, self.wall)
        return Estimate(1 / (1 + factor * self.coupled) - 1, slack)

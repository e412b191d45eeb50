"""Errors of Hertz's line contact for two elastic bodies of finite size.

Each estimate is the signed error of Hertz's value and the possible deviation from it, from sizes,
materials and Hertz's half-width a: coefficients of `pair_series` and `shear_series`. The next
terms, whose coefficients are not known, are included once with the factor 1; e is a over the
smallest length. Range: small e, no friction, plane strain.
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
    """A roller of the radius R_1 above a body of the radius R_2, negative for a bore."""

    a: float
    R_1: float
    R_2: float
    E_1: float
    nu_1: float
    E_2: float
    nu_2: float

    @property
    def materials(self) -> dict[str, float]:
        """Moduli and Poisson's ratios."""
        return {"E_1": self.E_1, "nu_1": self.nu_1, "E_2": self.E_2, "nu_2": self.nu_2}

    @cached_property
    def kappa(self) -> float:
        """Curvature of the surface on which the bodies meet [1/m]."""
        return pair_series.meeting_curvature(
            R_1=self.R_1, R_2=self.R_2, **self.materials, assumption=PLANE
        )


@dataclass(frozen=True, kw_only=True)
class OfDiscs(TwoBodies):
    """Two discs, each pressed from both sides."""

    @property
    def e(self) -> float:
        """A over the smaller radius [1]."""
        return self.a / min(self.R_1, self.R_2)

    @cached_property
    def series(self) -> tuple[pair_series.Excess, pair_series.Excess]:
        """Excess of true pressure and half-width over Hertz's."""
        sizes = {"a": self.a, "R_1": self.R_1, "R_2": self.R_2}
        return pair_series.excess(**sizes, **self.materials, assumption=PLANE)

    @property
    def coupled(self) -> float:
        """Coupling by unlike materials [1], of first order."""
        return abs(self.series[0].first) + abs(self.series[1].first)

    @property
    def pressure(self) -> Estimate:
        """Expected error of the peak pressure: the series.

        The square of its terms and the first-order one times a/R count once.
        """
        return self._second_order(self.series[0])

    @property
    def width(self) -> Estimate:
        """Expected error of the half-width."""
        return self._second_order(self.series[1])

    @property
    def bounded(self) -> tuple[Estimate, Estimate]:
        """Error of pressure and half-width: the series and the bound of its remainder."""
        sizes = {"a": self.a, "R_1": self.R_1, "R_2": self.R_2}
        slack = pair_series.left_out(**sizes, **self.materials, assumption=PLANE)
        p, w = (Estimate(1 / (1 + one.total) - 1, slack) for one in self.series)
        return p, w

    @property
    def approach(self) -> Estimate:
        """Error of the approach: half of e², as its brackets are 4 and more, plus coupling."""
        return Estimate(0.0, self.e**2 / 2 + self.coupled)

    @property
    def shear(self) -> Estimate:
        """Expected error of the largest shear stress; e² and the coupling count once.

        Of equal discs it is 0.57 e².
        """
        inclined, slack = self.kappa * self.a, self.e**2 + self.coupled
        return of_shear(a=self.a, R=self.R_1, inclined=inclined, slack=slack)

    def _second_order(self, excess: pair_series.Excess) -> Estimate:
        slack = (self.coupled + self.e**2) ** 2 + self.coupled * self.e
        return Estimate(1 / (1 + excess.total) - 1, slack)


@dataclass(frozen=True, kw_only=True)
class InRace(TwoBodies):
    """A roller in the bore of a race of the thickness `wall` with a fixed rim."""

    wall: float

    @property
    def small(self) -> float:
        """(a/R)² + (a/wall)²: effects of curvature and of the fixed rim, each with the factor 1."""
        return float((self.a / self.R_1) ** 2 + (self.a / self.wall) ** 2)

    @property
    def coupled(self) -> float:
        """Coupling by unlike materials [1], of first order."""
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
        """Expected error of the approach: half of `small`, as its brackets are 2 and more."""
        return Estimate(0.0, self.small / 2 + abs(self.coupled))

    @property
    def shear(self) -> Estimate:
        """Expected error of the largest shear stress; `small` and the coupling count once."""
        inclined, slack = self.kappa * self.a, self.small + abs(self.coupled)
        return of_shear(a=self.a, R=self.R_1, inclined=inclined, slack=slack)

    def _coupled(self, factor: float) -> Estimate:
        slack = self.small + abs(self.coupled) * self.a / min(self.R_1, self.wall)
        return Estimate(1 / (1 + factor * self.coupled) - 1, slack)

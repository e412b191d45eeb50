"""Errors of Hertz's line contact for a disc between rigid flats.

Each estimate contains the expected signed error of Hertz's value, and the tolerance of this error.
The coefficients of `disc_series` and `shear_series` give the error from the ratio a/R of Hertz's
half-width to the radius. The coefficients of the next terms are not known; these terms are included
in the tolerance with the factor 1. Range: small a/R, no friction, plane strain.
"""

from dataclasses import dataclass

import numpy as np

from analytic.bounds.contact.estimate import Estimate
from analytic.contact import shear_series

PRESSURE, WIDTH, APPROACH = -3 / 16, 1 / 4, -9 / 16  # of (a/R)², by which Hertz errs


@dataclass(frozen=True)
class OnFlat:
    """Disc pressed between rigid flats; `ratio` is a/R.

    >>> OnFlat(0.25).pressure.error, OnFlat(0.25).width.error
    (-0.01171875, 0.015625)
    """

    ratio: float

    @property
    def pressure(self) -> Estimate:
        """Expected error of the peak pressure; the tolerance is the next term, of order (a/R)⁴."""
        return self._second_order(PRESSURE)

    @property
    def width(self) -> Estimate:
        """Expected error of the half-width."""
        return self._second_order(WIDTH)

    @property
    def approach(self) -> Estimate:
        """Expected error of the approach: second-order term divided by 2 ln(4 R/a) - 1."""
        error, slack = self._second_order(APPROACH)
        return Estimate(error / float(2 * np.log(4 / self.ratio) - 1), slack)

    @property
    def shear(self) -> Estimate:
        """Expected error of the largest shear stress of a disc on a flat, to first order in a/R."""
        return of_shear(a=self.ratio, R=1.0, inclined=0.0, slack=self.ratio**2)

    def _second_order(self, coefficient: float) -> Estimate:
        return Estimate(coefficient * self.ratio**2, self.ratio**4)


def of_shear(*, a: float, R: float, inclined: float, slack: float) -> Estimate:
    """First-order error of the largest shear stress, from the curvatures of disc and contact line.

    `inclined` is the curvature of the contact line times the half-width.
    """
    first = float(shear_series.shear_excess(a=a, R=R))
    first += shear_series.tilted_shear_excess(inclined)
    return Estimate(1 / (1 + first) - 1, slack)

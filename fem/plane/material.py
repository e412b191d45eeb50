"""Isotropic linear elasticity reduced to the plane, or to the meridian of a body of revolution."""

import math
from dataclasses import dataclass
from typing import Literal

Assumption = Literal["plane strain", "plane stress", "axisymmetric"]


@dataclass(frozen=True, kw_only=True)
class Elastic:
    """Young's modulus `E` [stress] and Poisson's ratio `nu` [1] of one body.

    For plane strain and bodies of revolution with nu > 0.45, see `fem.plane.mixed`. Raises
    ValueError unless E > 0 is finite and -1 < nu < 0.5.
    """

    E: float
    nu: float

    def __post_init__(self) -> None:
        if not (math.isfinite(self.E) and self.E > 0):
            raise ValueError(f"Young's modulus must be positive and finite, got E={self.E:g}")
        if not -1 < self.nu < 0.5:
            raise ValueError(f"Poisson's ratio must lie in (-1, 0.5), got nu={self.nu:g}")

    def lame_constants(self, assumption: Assumption) -> tuple[float, float]:
        """In-plane (lambda, mu) [stress] of sigma = lambda tr(eps) I + 2 mu eps."""
        mu = self.E / (2 * (1 + self.nu))
        if assumption == "plane stress":  # sigma_zz = 0 eliminates eps_zz
            return self.E * self.nu / (1 - self.nu**2), mu
        return self.E * self.nu / ((1 + self.nu) * (1 - 2 * self.nu)), mu

    def normal_stress_ratio(self, assumption: Assumption) -> float:
        """Ratio sigma_zz / (sigma_xx + sigma_yy): nu in plane strain, 0 in plane stress.

        The ratio is NaN for a body of revolution, whose hoop stress follows from the hoop strain.
        """
        return {"plane strain": self.nu, "plane stress": 0.0, "axisymmetric": math.nan}[assumption]

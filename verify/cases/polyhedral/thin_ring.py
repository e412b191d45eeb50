"""Formulas of the thin round ring that closes a clearance, and K of a polygonal bore."""

from typing import ClassVar

from analytic.contact.checks import Assumption
from analytic.polyhedral import bore_pressure, expansion
from analytic.polyhedral.bore_pressure import StiffnessFactors
from analytic.polyhedral.sector import Sector
from verify.case import Quantity, shared
from verify.cases.polyhedral.inputs import PolygonRing, RoundRing

SERIES = "complex potentials"


class ThinRing(RoundRing):
    """Hoop stress and pressure of a thin ring whose mean diameter grows by the clearance."""

    @Quantity("d_m", "mm", "mean diameter", equation="6", role="step", tex=r"\frac{d_i + d_e}{2}")
    def mean_diameter(self) -> float:
        return float(expansion.mean_diameter(d_i=self.d_i, d_e=self.d_e))

    @Quantity("σ_t", "MPa", "hoop stress", equation="9", safe="too high", tex=r"\frac{E j_D}{d_m}")
    def sigma_t(self) -> float:
        return float(expansion.hoop_stress(j_D=self.j_D, d_m=self.mean_diameter, E=self.E))

    @Quantity("p_1", "MPa", "pressure that closes the clearance of a thin ring", equation="10",
              safe="too high", tex=r"\frac{2 \delta_1 \sigma_t}{d_i} "
              r"= \frac{2 \delta_1 E j_D}{d_i d_m}")  # fmt: skip
    def p_1(self) -> float:
        wall = {"d_i": self.d_i, "d_e": self.d_e}
        return float(expansion.touching_pressure(j_D=self.j_D, **wall, E=self.E))


class PolygonSeries(ThinRing, PolygonRing):
    """The polygonal ring under pressure, solved by complex potentials."""

    ends: ClassVar[Assumption] = "plane stress"

    K_mid = Quantity("K_mid", "1", "K in the middle of the flats",
                     source=SERIES).reads(lambda q: q.factors.mid)  # fmt: skip

    @shared
    def sector(self) -> Sector:
        """Geometry of half a sector, for the series."""
        return Sector(z=self.z, d_e=self.d_e, d_i=self.d_i, rho=self.rho)

    @shared
    def factors(self) -> StiffnessFactors:
        """K for the displacement in the middle of the flats, for the mean, and for the corners."""
        return bore_pressure.stiffness_factors(sector=self.sector, nu=self.nu, assumption=self.ends)

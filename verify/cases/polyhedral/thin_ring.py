"""The thin round ring that takes up a clearance, behind all polyhedral ones."""

from analytic.polyhedral import expansion
from verify.case import Quantity
from verify.cases.polyhedral.inputs import RoundRing


class ThinRing(RoundRing):
    """Hoop stress and pressure of a thin ring whose mean diameter grows by the clearance."""

    @Quantity("d_m", "mm", "mean diameter", equation="6", role="step", tex=r"\frac{d_i + d_e}{2}")
    def mean_diameter(self) -> float:
        return float(expansion.mean_diameter(d_i=self.d_i, d_e=self.d_e))

    @Quantity("σ_t", "MPa", "hoop stress", equation="9", safe="too high", tex=r"\frac{E j_D}{d_m}")
    def sigma_t(self) -> float:
        return float(expansion.hoop_stress(j_D=self.j_D, d_m=self.mean_diameter, E=self.E))

    @Quantity("p_1", "MPa", "pressure of the thin ring", equation="10", safe="too high",
              tex=r"\frac{2 \delta_1 \sigma_t}{d_i} "
              r"= \frac{2 \delta_1 E j_D}{d_i d_m}")  # fmt: skip
    def p_1(self) -> float:
        wall = {"d_i": self.d_i, "d_e": self.d_e}
        return float(expansion.touching_pressure(j_D=self.j_D, **wall, E=self.E))

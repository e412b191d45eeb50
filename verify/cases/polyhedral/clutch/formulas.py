"""Torque of the clutch with elastic ring and rollers, by complex potentials and Hertz."""

from math import inf, isfinite, nan
from typing import Any

import numpy as np

from analytic.contact.checks import Assumption
from analytic.polyhedral.bore_pressure import pressed
from analytic.polyhedral.capacity import Driven
from analytic.polyhedral.fillet_stress import driven_fillet_stress
from analytic.polyhedral.locking import Roller, RollerContact
from analytic.polyhedral.rim_slope import steepest
from analytic.polyhedral.sector import Sector
from verify.case import Quantity, shared
from verify.cases.polyhedral.clutch.inputs import ClutchInputs

SERIES = "series for elastic ring and rollers"


class ElasticClutch(ClutchInputs):
    """Main results for design; they are infinite or nan if pressure does not limit the torque."""

    @Quantity("S", "1", "margin: torque with elastic ring and rollers, divided by the target "
              "torque", role="step", safe="too low", tex=r"\frac{M_{el}}{M_t}")  # fmt: skip
    def margin(self) -> float:
        return self.M_el / self.M_t

    @Quantity("M_el", "N m", "torque with elastic ring and rollers", source=SERIES,
              safe="too low", tex=r"\mu_g N_{el} z \frac{D_i}{2}")  # fmt: skip
    def M_el(self) -> float:
        return self.hub.grip * self.line_load * self.all_levers

    @Quantity("p_need", "MPa", "pressure for the target torque, by the series", source=SERIES,
              safe="too high")  # fmt: skip
    def p_need(self) -> float:
        return self.hub.required_pressure(self.line_need) if self.stays else inf

    @Quantity("p_block", "MPa", "blocking pressure for the target torque: p_need minus the "
              "pressure at which the ring reaches its rollers", source=SERIES,
              safe="too high")  # fmt: skip
    def p_block(self) -> float:
        return self.p_need - self.touch

    @Quantity("p_ring", "MPa", "Hertz's peak pressure of rollers on the ring, under the larger "
              "of p_t and p_need", role="step", safe="too high")  # fmt: skip
    def p_ring(self) -> float:
        return self._pressure(self.d_e / 2)

    @Quantity("p_race", "MPa", "Hertz's peak pressure of rollers on the race, under the larger "
              "of p_t and p_need", role="step", safe="too high")  # fmt: skip
    def p_race(self) -> float:
        return self._pressure(-self.D_i / 2)

    @Quantity("σ_max", "MPa", "largest hoop stress in the fillets under p_t", source=SERIES,
              safe="too high")  # fmt: skip
    def fillet(self) -> float:
        return driven_fillet_stress(self.hub, self.line_load, self.p_t)

    @Quantity("σ_need", "MPa", "largest hoop stress in the fillets under p_need", role="step",
              safe="too high")  # fmt: skip
    def fillet_need(self) -> float:
        p = self.p_need
        return driven_fillet_stress(self.hub, self.line_need, p) if isfinite(p) else nan

    @Quantity(
        "N_el",
        "kN",
        "force of a roller under p_t",
        source=SERIES,
        tex=r"b \frac{u_p p_t - \frac{j_D}{2} - \delta(N)}{u_N(a) - \kappa u_{h1}}",
    )
    def N_el(self) -> float:
        return self.line_load * self.b

    @Quantity("N_need", "kN", "force of a roller for the target torque", role="step",
              safe="too high", tex=r"\frac{2 M_t}{\mu_g z D_i}")  # fmt: skip
    def N_need(self) -> float:
        return self.line_need * self.b

    @Quantity("M_rigid", "N m", "torque with rigid rollers, an upper bound of M_el", source=SERIES)
    def M_rigid(self) -> float:
        return self.stiff.grip * self.line_rigid * self.all_levers

    @Quantity("M_wide", "N m", "torque of a wide ring in plane strain", source=SERIES, role="step",
              safe="too low")  # fmt: skip
    def M_wide(self) -> float:
        wide = self.driven(assumption="plane strain")
        return wide.grip * wide.force(self.p_t) * self.all_levers if self.stays else 0.0

    @Quantity("α_need", "deg", "wedge angle at which rollers without a cage reach the ratio μ_g",
              role="step", tex=r"2 \arctan\left(\mu_g\right)")  # fmt: skip
    def alpha_need(self) -> float:
        return float(2 * np.arctan(self.hub.grip))

    @Quantity("α_ring", "deg", "largest slope of the outer surface under p_t, relative to a "
              "circle, without roller forces",
              role="step")  # fmt: skip
    def alpha_ring(self) -> float:
        ring = self.hub.contact.sector
        return float(steepest(sector=ring, field=pressed(ring))[0] * self.p_t / self.E)

    @Quantity("M_ring", "N m", "torque without a cage, with the wedge angle α_ring", role="step",
              safe="too low")  # fmt: skip
    def M_ring(self) -> float:
        offered = self.driven(share=float(np.tan(self.alpha_ring / 2)))
        return offered.grip * offered.force(self.p_t) * self.all_levers

    @shared
    def hub(self) -> Driven:
        """Ring under hub and pressure, with elastic rollers."""
        return self.driven()

    @shared
    def stiff(self) -> Driven:
        """Ring under hub and pressure, with rigid rollers."""
        return self.driven(rigid=True)

    @shared
    def line_load(self) -> float:
        """Force per length [N/m] of a roller under p_t."""
        return self.hub.force(self.p_t) if self.stays else 0.0

    @shared
    def line_rigid(self) -> float:
        """Force per length [N/m] of a rigid roller under p_t."""
        return self.stiff.force(self.p_t) if self.stays else 0.0

    @property
    def line_need(self) -> float:
        """Force per length [N/m] of a roller for the target torque."""
        return self.M_t / (self.hub.grip * self.all_levers) if self.stays else inf

    @property
    def touch(self) -> float:
        """Pressure [Pa] at which the ring reaches the rollers, by the series."""
        return self.j_D / 2 / self.hub.contact.growth

    def driven(
        self, *, rigid: bool = False, assumption: Assumption = "plane stress",
        share: float | None = None,
    ) -> Driven:  # fmt: skip
        """Ring under hub and pressure; the rollers are elastic, or `rigid`.

        `share` replaces `grip` as the ratio of tangential to normal force of the rollers.
        """
        own: dict[str, Any] = {} if rigid else {"E": self.E, "nu": self.nu}
        ring = Sector(z=self.z, d_e=self.d_e, d_i=self.d_i, rho=self.rho)
        roller = Roller(d=self.d, j_D=self.j_D, **own)
        contact = RollerContact(ring, roller, self.E, self.nu, assumption)
        grip = self.grip if share is None else share
        return Driven(contact, grip=grip, D_i=self.D_i, e=self.e, tan_phi=self.tan_phi)

    def _pressure(self, R_2: float) -> float:
        """Hertz's peak pressure [Pa] of a roller on a surface with the radius R_2 [m]."""
        carried = [load for load in (self.line_load, self.line_need) if isfinite(load)]
        if not carried:
            return nan
        curvature = 2 / self.d + 1 / R_2
        N = max(carried)
        return float(np.sqrt(N * curvature * self.E / (1 - self.nu**2) / (2 * np.pi)))

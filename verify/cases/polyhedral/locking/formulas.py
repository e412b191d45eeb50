"""Roller force of the locked ring: by the paper, and by complex potentials with Hertz's contact."""

from dataclasses import replace
from typing import Any, ClassVar, Self

import numpy as np

from analytic.polyhedral import expansion, forces, printed
from analytic.polyhedral.bore_pressure import stiffness_factors
from analytic.polyhedral.fillet_stress import loaded_fillet_stress
from analytic.polyhedral.hub_force import HubForce, hub_force
from analytic.polyhedral.locking import Locked, Roller, locked
from verify.case import Quantity, shared
from verify.cases.polyhedral.locking.inputs import LockingInputs
from verify.cases.polyhedral.thin_ring import SERIES, PolygonSeries


class LockedFormulas(PolygonSeries, LockingInputs):
    """Ring under pressure and hub force, with rigid rollers.

    `alone` and `soft` are the states under pressure only, with rigid and with elastic rollers.
    """

    pushed: ClassVar[bool] = True  # whether the hub presses
    elastic: ClassVar[bool] = False  # rollers

    @Quantity("p_1r", "MPa", "pressure at which the ring reaches its rollers", equation="11",
              role="step", safe="too high", tex=r"K_{mid} p_1")  # fmt: skip
    def p_1r(self) -> float:
        wall = {"d_i": self.d_i, "d_e": self.d_e}
        return float(expansion.touching_pressure(j_D=self.j_D, **wall, E=self.E, K=self.K_mid))

    @Quantity("p_2", "MPa", "blocking pressure", equation="19", role="step", safe="too low")
    def p_2(self) -> float:
        return max(self.p_t - self.p_1r, 0.0)

    @Quantity("p_2", "MPa", "blocking pressure with K = 1", equation="19", form_of="p_2",
              safe="too low", tex=r"p_t - p_1")  # fmt: skip
    def p_2_round(self) -> float:
        return max(self.p_t - self.p_1, 0.0)

    @Quantity("p_2l", "MPa", "blocking pressure of a long ring in plane strain", source=SERIES,
              role="step", safe="too low")  # fmt: skip
    def p_2_long(self) -> float:
        return self.p_t - self.touch_long

    @Quantity("F/b", "N/mm", "force of a roller without hub force, Eqs. 13 and 16",
              source="Eqs. 13 and 16",
              safe="too low", tex=r"p_2 d_i \sin\left(\frac{\pi}{z}\right)")  # fmt: skip
    def F(self) -> float:
        return self._on_a_side(self.p_2)

    @Quantity("φ_1", "deg", "angle of friction between hub and ring", role="step",
              tex=r"\arctan\left(tan \varphi_1\right)")  # fmt: skip
    def phi_1(self) -> float:
        return float(np.arctan(self.tan_phi))

    @Quantity("N_16/b", "N/mm", "force of a roller with hub force, Eqs. 13 and 16",
              source="Eq. 16 with γ = 0",
              safe="too low", tex=r"F/b + R/b \cos\left(\varphi_1\right)")  # fmt: skip
    def N_16(self) -> float:
        return float(forces.normal_force(F=self.F, R=self.R_b, phi_1=self.phi_1, gamma=0.0))

    @Quantity("F_t/b", "N/mm", "resultant of the pressure on a side", equation="13",
              form="corrected", safe="too low",
              tex=r"p_t d_i \sin\left(\frac{\pi}{z}\right)")  # fmt: skip
    def side(self) -> float:
        return self._on_a_side(self.p_t)

    @Quantity("F_t/b", "N/mm", "resultant of the pressure on a side", equation="13",
              form="as printed", form_of="side", safe="too low",
              tex=r"\frac{\pi d_i}{z} p_t")  # fmt: skip
    def side_printed(self) -> float:
        return float(self.side * printed.arc_over_chord(self.z))

    N = Quantity(
        "N/b", "N/mm", "force of a roller by the series", safe="too low",
        source="series, with Hertz's half-width a of the contact",
        tex=r"\frac{u_p p_t + u_h - \frac{j_D}{2}}{u_N(a)}",
    ).reads(lambda q: q.locked.N)  # fmt: skip
    efficiency = Quantity(
        "η", "1", "incremental load-transfer ratio, pressure to rollers",
        source="Eq. 16 assumes η = 1", tex=r"\frac{1}{d_i \sin(\pi/z)} \frac{dN}{b\,dp}",
    ).reads(lambda q: q.locked.efficiency)  # fmt: skip
    hub_share = Quantity("η_h", "1", "incremental load-transfer ratio, hub to rollers",
                         source=SERIES,
                         when=lambda q: q.pushed).reads(lambda q: q.locked.hub_share)  # fmt: skip
    a = Quantity("a", "µm", "half-width of the contact between roller and ring",
                 source="Hertz").reads(lambda q: q.locked.a)  # fmt: skip
    a_race = Quantity("a_r", "µm", "half-width of the contact between roller and race",
                      source="Hertz",
                      when=lambda q: q.elastic).reads(lambda q: q.locked.a_race)  # fmt: skip

    @Quantity("p_0", "MPa", "peak pressure between roller and ring", source="Hertz",
              safe="too high")  # fmt: skip
    def p_0(self) -> float:
        return float(2 * self.N / (np.pi * self.a)) if self.a else 0.0

    @Quantity("σ_max", "MPa", "largest hoop stress in the fillets of the locked ring",
              source=SERIES, safe="too high")  # fmt: skip
    def fillet(self) -> float:
        return self._in_fillet(self.locked)

    @shared
    def alone(self) -> Self:
        """The ring under pressure only, with rigid rollers."""
        return self.variant(pushed=False)

    @shared
    def soft(self) -> Self:
        """The ring under pressure only, with elastic rollers."""
        return self.variant(pushed=False, elastic=True)

    @shared
    def hub(self) -> HubForce:
        """Solution of the ring under the hub force, by complex potentials."""
        normal, along = self.push
        return hub_force(sector=self.sector, e=self.e, normal=normal, along=along)

    @shared
    def touch_long(self) -> float:
        """Pressure [Pa] at which a long ring in plane strain reaches its rollers."""
        long = stiffness_factors(sector=self.sector, nu=self.nu, assumption="plane strain")
        return float(long.mid * self.p_1)

    @shared
    def locked(self) -> Locked:
        """State of the locked ring for these inputs, by the series."""
        return self.under(self.p_t, self.d, self.hub if self.pushed else None)

    @shared
    def from_rollers(self) -> float:
        """Fraction of the fillet stress that the rollers cause."""
        return abs(1 - self._in_fillet(replace(self.locked, N=0.0)) / self.fillet)

    def under(self, p: float, d: float, hub: HubForce | None = None) -> Locked:
        """State of the ring between rollers of diameter d [m], under the pressure p [Pa]."""
        own: dict[str, Any] = {"E": self.E, "nu": self.nu} if self.elastic else {}
        return locked(sector=self.sector, roller=Roller(d=d, j_D=self.j_D, **own), p=p, E=self.E,
                      nu=self.nu, assumption="plane stress", hub=hub)  # fmt: skip

    def _on_a_side(self, p: float) -> float:
        return float(forces.pressure_force(p_2=p, b=1.0, d_i=self.d_i, z=self.z))

    def _in_fillet(self, found: Locked) -> float:
        """Largest hoop stress [Pa] in the fillet under pressure, hub and rollers together."""
        return loaded_fillet_stress(self.sector, p=self.p_t, hub=self.hub, N=found.N, a=found.a)

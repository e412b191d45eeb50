"""A roller freewheel under torque and axial load, with given friction."""

import numpy as np

from analytic.freewheel import criterion
from verify.case import Quantity, given
from verify.cases.freewheel.star import Star


class Pulled(Star):
    """The clutch of `Star` under torque and axial load."""

    F_ax: float = given("600 N", "N", "F_ax", "axial load on the whole clutch", ge=0, le=1e9)
    mu: float = given(0.08, "1", "μ", "coefficient of friction, equal at all contacts", ge=0.01,
                      le=1)  # fmt: skip

    @Quantity("μ_T", "1", "required friction coefficient under torque alone", equation="1",
              safe="too high", tex=r"\tan\left(\alpha\right)")  # fmt: skip
    def mu_T(self) -> float:
        alone = {"T": self.T, "F_ax": 0.0, "R": self.R}
        return float(criterion.required_friction(alpha=self.state.alpha, **alone))

    @Quantity("F_t", "N", "tangential force at either contact of a roller", equation="3",
              form="corrected", source="T is the torque of the whole clutch",
              tex=r"\frac{T}{z R}")  # fmt: skip
    def F_t(self) -> float:
        return float(self.T / self.cam.torque_on_race(F_t=1.0))

    @Quantity("F_a", "N", "axial force at either contact of a roller",
              source="F_ax is the load of the whole clutch", tex=r"\frac{F_{ax}}{z}")  # fmt: skip
    def F_a(self) -> float:
        return self.F_ax / self.z

    @Quantity("μ_req", "1", "required friction coefficient", equation="9", safe="too high",
              source="Eq. 8 with the forces of one roller; μ_req in place of the printed tan α",
              tex=r"\frac{\sqrt{F_t^2 + F_a^2}}{F_n} = "
              r"\tan\left(\alpha\right) \sqrt{1 + (\frac{F_{ax} R}{T})^2}")  # fmt: skip
    def mu_req(self) -> float:
        loads = {"T": self.T, "F_ax": self.F_ax, "R": self.R}
        return float(criterion.required_friction(alpha=self.state.alpha, **loads))

    @Quantity("F_lim", "N", "axial load at slip", equation="9", safe="too low",
              when=lambda q: q.bears_axial_load,
              tex=r"\frac{T}{R} \sqrt{(\frac{\mu}{\tan\left(\alpha\right)})^2 - 1}")  # fmt: skip
    def F_lim(self) -> float:
        return self.largest_axial_load(self.T)

    @property
    def lever(self) -> float:
        """Ratio F_a/F_t = F_ax R/T."""
        return self.F_ax * self.R / self.T

    @property
    def bears_axial_load(self) -> bool:
        """Whether friction exceeds tan(alpha), so that the clutch carries axial load."""
        limit = self.largest_axial_load(self.T)
        return bool(np.isfinite(limit) and limit > 0)

    def largest_axial_load(self, T: float) -> float:
        """Axial load [N] at slip under a torque; nan if the torque alone causes slip."""
        alpha = self.state.alpha if T == self.T else self.under(T).alpha
        return float(criterion.largest_axial_load(alpha=alpha, T=T, R=self.R, mu=self.mu))

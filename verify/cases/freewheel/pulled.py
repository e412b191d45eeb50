"""A roller freewheel under torque and axial load, with the friction that there is."""

import numpy as np

from analytic.freewheel import criterion
from verify.case import Quantity, given
from verify.cases.freewheel.star import Star


class Pulled(Star):
    """The clutch of `Star`, pulled along its axis while it is locked."""

    F_ax: float = given("600 N", "N", "F_ax", "axial load on the whole clutch", ge=0, le=1e9)
    mu: float = given(0.08, "1", "μ", "coefficient of friction, equal at all contacts", ge=0.01,
                      le=1)  # fmt: skip

    @Quantity("μ_T", "1", "required friction coefficient, torque alone", equation="1",
              safe="too high", tex=r"\tan\left(\alpha\right)")  # fmt: skip
    def mu_T(self) -> float:
        alone = {"T": self.T, "F_ax": 0.0, "R": self.R}
        return float(criterion.required_friction(alpha=self.state.alpha, **alone))

    @Quantity("F_lim", "N", "axial load on the clutch at slip", equation="9", safe="too low",
              when=lambda q: q.bears_axial_load,
              tex=r"\frac{T}{R} \sqrt{(\frac{\mu}{\tan\left(\alpha\right)})^2 - 1}")  # fmt: skip
    def F_lim(self) -> float:
        return self.largest_axial_load(self.T)

    @property
    def bears_axial_load(self) -> bool:
        """Whether friction exceeds tan(alpha) under the torque."""
        limit = self.largest_axial_load(self.T)
        return bool(np.isfinite(limit) and limit > 0)

    def largest_axial_load(self, T: float) -> float:
        """Axial load [N] at which the clutch slips under a torque; nan where it does without."""
        alpha = self.state.alpha if T == self.T else self.under(T).alpha
        return float(criterion.largest_axial_load(alpha=alpha, T=T, R=self.R, mu=self.mu))

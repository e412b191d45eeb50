"""Formulas of friction in a sprag clutch: required coefficient at rest, force of sliding sprags."""

import math

import numpy as np

from analytic.sprag.friction import coefficient
from analytic.sprag.race_spring import RaceSpring
from analytic.sprag.sliding import Sliding, sliding
from analytic.sprag.work_balance import asked as asked_at
from analytic.sprag.work_balance import at_rest
from verify.case import Case, Quantity, shared
from verify.cases.sprag.engagement.formulas import swing, with_torque
from verify.cases.sprag.engagement.model import wedge
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.figures import Array, Equation

WEAK = 0.04  # stiffness of weak springs over the given one: sprags slip at the start
BELOW = 0.9  # friction over tan(nu_0) for permanent sliding


def asked(q: EngagementInputs, factor: float = 1.0) -> tuple[float, float]:
    """Required friction coefficient and tan(nu) at rest under `factor` times T.

    Both are nan if there is no equilibrium.
    """
    p = with_torque(q, factor)
    w = wedge(p)
    rest = at_rest(w, p.T)
    if math.isnan(rest):
        return math.nan, math.nan
    return asked_at(w, rest), float(np.tan(np.interp(rest, w.theta, w.states.nu)))


def weak(q: EngagementInputs, factor: float = 1.0) -> EngagementInputs:
    """Inputs of the clutch with weak springs under `factor` times the torque."""
    return with_torque(q, factor).model_copy(update={"K_r": WEAK * q.K_r})


LAW = Equation(
    tex=r"T = \begin{cases} T_{stick} & |v| < D_V,\ |T_{stick}| \le \mu_s N \\ "
    r"\mu_s N\,\mathrm{sgn}\,T_{stick} & |v| < D_V,\ |T_{stick}| > \mu_s N \\ "
    r"\mu_d N\,\mathrm{sgn}\,v & |v| \ge D_V \end{cases}", place="Eq. 12",
)  # fmt: skip


class FrictionFormulas(EngagementInputs, Case):
    """Required friction of a sprag clutch at rest, and forces of sliding sprags.

    The values are nan if the sprags roll over, or if no contact continues to slide.
    """

    @shared
    def wedge(self) -> RaceSpring:
        """The clutch as a spring over the wind-up of its races."""
        return wedge(self)

    @shared
    def rest(self) -> float:
        """Wind-up [rad] at rest under T."""
        return at_rest(self.wedge, self.T)

    @shared
    def slides(self) -> Sliding:
        """Steady state of driven sprags that slide permanently."""
        return sliding(self.wedge, BELOW * self.tan_0)

    @shared
    def overruns(self) -> Sliding:
        """Steady state of sprags while the race overruns."""
        return sliding(self.wedge, -self.mu_s)

    @property
    def tan_0(self) -> float:
        """Tangent of the wedge angle nu_0 without load."""
        return math.tan(self.nu_0)

    @property
    def unequal(self) -> float:
        """Relative amount N_e/N - 1 by which the outer normal force exceeds the inner, by statics.

        The forces are those at the end of the profile.
        """
        now = self.wedge.states
        return float((now.N_e / np.maximum(now.N, 1e-300))[-1]) - 1

    @property
    def asked_in_swing(self) -> float:
        """Tangent of the wedge angle at the largest force of the engagement."""
        now = self.wedge.states
        return float(np.tan(np.interp(swing(self).peak[1], now.N, now.nu)))

    def at_turn(self, values: Array) -> float:
        """Interpolate `values`, given at the wind-up angles of `wedge`, at the state of rest."""
        return float(np.interp(self.rest, self.wedge.theta, values))

    @Quantity("μ_b", "1", "friction coefficient above which the clutch locks",
              source="statics at rest under T; the springs cause the difference from tan ν",
              safe="too high", tex=r"\frac{T}{n_s OA N_T}")  # fmt: skip
    def mu_b(self) -> float:
        return asked(self)[0]

    @Quantity("tan ν", "1", "tangent of the wedge angle at rest under T", equation="10",
              tex=r"\tan\left(\nu_T\right)")  # fmt: skip
    def tan(self) -> float:
        return asked(self)[1]

    @Quantity("μ_s/μ_b", "1", "ratio of static to required friction coefficient", role="step",
              tex=r"\frac{\mu_s}{\mu_b}")  # fmt: skip
    def mu_s_share(self) -> float:
        return self.mu_s / self.mu_b

    @Quantity("μ_c/μ_b", "1", "ratio of Coulomb to required friction coefficient", role="step",
              tex=r"\frac{\mu_c}{\mu_b}")  # fmt: skip
    def mu_c_share(self) -> float:
        return self.mu_c / self.mu_b

    @Quantity("N_s", "N", "normal force of driven sprags that slide",
              source="Eq. 14 for sprags that slide on the inner race with μ = 0.9 tan ν_0",
              tex=r"\frac{K_r(\alpha_{max} - \alpha)}{h - b_i\mu - b_e\frac{(OA + b_i)\mu - h}"
              r"{OB - b_e}}, \quad h = h_i - h_e")  # fmt: skip
    def N_slides(self) -> float:
        return self.slides.N

    @Quantity("T_sl", "N m", "torque of the clutch with driven sprags that slide", role="step")
    def T_slides(self) -> float:
        return self.z * self.R_i * self.slides.share * self.slides.N

    @Quantity("N_o", "N", "normal force while the race overruns, with μ_s", source="Eq. 14")
    def N_overruns(self) -> float:
        return self.overruns.N

    @Quantity("T_o", "N m", "drag torque while the race overruns", role="step")
    def drag(self) -> float:
        return -self.z * self.R_i * self.overruns.share * self.overruns.N

    @Quantity("N_T", "N", "normal force at rest under T", role="step")
    def N_T(self) -> float:
        return self.at_turn(self.wedge.states.N)

    @Quantity("OA", "mm", "radius at which N_T acts", equation="9", role="step")
    def OA(self) -> float:
        return self.at_turn(self.wedge.states.OA)

    @Quantity("ν_T", "deg", "wedge angle at rest under T", equation="10", role="step")
    def nu_T(self) -> float:
        return self.at_turn(self.wedge.states.nu)

    @Quantity("v", "m/s", "sliding speed at which μ_d is displayed", role="step",
              tex=r"\frac{1}{\gamma_b}")  # fmt: skip
    def v(self) -> float:
        return 1 / self.gamma_b

    @Quantity("μ_d", "1", "friction coefficient at the sliding speed v", equation="13", role="step",
              tex=r"\mu_c + (\mu_s - \mu_c) \exp\left(-\gamma_b v\right)")  # fmt: skip
    def mu_d(self) -> float:
        return float(coefficient(self.v, mu_c=self.mu_c, mu_s=self.mu_s, gamma_b=self.gamma_b))

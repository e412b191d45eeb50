"""Formulas of a crown without an engagement: its design load and its pressures at rest."""

import math
from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from analytic.contact import crown
from analytic.contact.sliced import SlicedContact
from analytic.sprag.crowned import mid
from verify.case import Case, Level, Quantity, drawn_by, shared
from verify.cases.sprag.clutch import advice as clutch_advice
from verify.cases.sprag.clutch import sketch as sketched
from verify.cases.sprag.clutch.model import built, normal_force, under
from verify.cases.sprag.engagement.model import crowned_for
from verify.cases.sprag.optimum import comparisons as compared
from verify.cases.sprag.optimum import figures as drawn
from verify.cases.sprag.optimum.inputs import OptimumInputs
from verify.core.figures import Equation
from verify.core.references import BY_SEARCHES
from verify.core.tex import tex

LEVELS = (41, 81, 161)  # strips along a sprag
UM = 1e-6
MOST_STEPS = 50_000  # largest number of steps of an engagement; a study has hundreds of them


class CrownAtHand(OptimumInputs, Case):  # type: ignore[misc]  # `levels` is an input
    """Pressures of the given crown at rest; only the reference computes the optimal crown."""

    source = "huang2018"
    method = BY_SEARCHES
    readings: ClassVar = (
        "Pre_max is the largest pressure of the slices of the inner contact at the largest force",
        "z_m is in millimetres. At both torques, Q is the static load of rigid bodies at 25 N m, "
        "T/(z R_i tan ν_0); with deflections, the force of a sprag is smaller",
        "Eq. 20 is a full quadratic and a Matérn 5/2 process for its residuals; the paper prints "
        "neither",
        "the genetic algorithm uses Gray codes, tournaments of two, one-point crossover and "
        "elitism; the paper does not print these",
    )
    assumptions: ClassVar = (
        "inputs that the paper does not print are those of case sprag-clutch, identified or "
        "assumed",
        "separate kriging models are used for the end slice and for all other slices; they "
        "interpolate the squares of pressures, which are proportional to forces, and the larger "
        "result applies",
        "the pressure under the largest force of an engagement is that of a static contact",
    )

    @Quantity("Q_0", "N", "design load of every crown: static load of a sprag between rigid parts")
    def Q_crown(self) -> float:
        return crowned_for(self)

    @Quantity("Q_even", "N", "load under which the given crown is uniformly loaded",
              source="Lundberg", tex="K_1 Q_0")  # fmt: skip
    def K_1_Q(self) -> float:
        return self.K_1 * self.Q_crown

    @Quantity("A", "µm", "factor of the logarithm, given crown", equation="1", form="corrected",
              tex=r"\frac{2 K_1 Q_0 (1 - \nu^2)}{\pi l E}")  # fmt: skip
    def A(self) -> float:
        E_star = float(built(self).parts.E_star)
        return float(self.K_1 * self.Q_crown / (np.pi * self.l * E_star))

    @Quantity("l_0", "mm", "straight length of the given crown", equation="1", tex="(1 - K_2) l")
    def straight(self) -> float:
        return float(crown.straight_length(K_2=self.K_2, length=self.l))

    @Quantity("z_end", "µm", "drop of the given crown at the end slices", equation="1")
    def z_end(self) -> float:
        return float(built(self).gap[0])

    @Quantity("N", "N", "normal force at rest under the torque", safe="too high")
    def N(self) -> float:
        return normal_force(under(self))

    @Quantity("μ_req", "1", "required friction coefficient", role="step")
    def mu_req(self) -> float:
        now = under(self)
        return math.nan if now is None else float(np.tan(now.nu))

    @shared
    def _contact(self) -> SlicedContact | None:
        """Inner contact under the normal force at rest; None without equilibrium."""
        return built(self).pressed(self.N)[0] if math.isfinite(self.N) else None

    @Quantity("p", "MPa", "largest pressure at rest, by slices", safe="too high")
    def static_peak(self) -> float:
        return float(self._contact.peak_pressure.max()) if self._contact else math.nan

    @Quantity("p(0)", "MPa", "pressure at mid-length at rest", safe="too high")
    def static_mid(self) -> float:
        return mid(self._contact) if self._contact else math.nan

    @Quantity("p_end", "MPa", "pressure of the end slices at rest", safe="too high")
    def static_end(self) -> float:
        return float(self._contact.peak_pressure[0]) if self._contact else math.nan

    @Quantity("n_X", "1", "number of designs of the full factorial")
    def designs(self) -> float:
        return float(self.levels**3)

    torque: ClassVar[int] = 25  # N m, of the paper's statements

    comparisons = compared.stated
    figures = drawn_by(drawn.figures)
    tables = staticmethod(drawn.tables)
    sketch = sketched.sketch

    def reference(self, level: int) -> Level:
        """Reference: strips for the given crown, the optimisation, end pressures of the optimum."""
        from verify.cases.sprag.optimum.reference import solve

        return solve(self, level)

    def laws(self) -> Iterator[Equation]:
        """Equations of the optimisation problem, its bounds and its surrogate."""
        yield Equation(
            tex=r"\min_{\mathbf{X}} \max_{t,\,y} p(y, t), \quad \mathbf{X} = (K_1, K_2, z_m)",
            place="Eqs. 17, 18",
        )
        yield Equation(
            tex=rf"{tex(self.K_1_low)} \leq K_1 \leq {tex(self.K_1_high)}, \quad "
            rf"{tex(self.K_2_low)} \leq K_2 \leq {tex(self.K_2_high)}, \quad "
            rf"{tex(self.z_m_low / UM)} \leq z_m \leq {tex(self.z_m_high / UM)}\ \mathrm{{µm}}",
            place="Eq. 19",
        )
        yield Equation(
            tex=r"Y(\mathbf{x}) = \mathbf{f}(\mathbf{x})^\mathsf{T}\mathbf{b} + G(\mathbf{x}), "
            r"\quad \mathrm{Pre}_{\max} \approx \sqrt{\max(Y_{end}, Y_{rest})}",
            place="Eq. 20 for squares of pressures, separately for end slice and other slices",
        )

    def advice(self) -> Iterator[str]:
        """Statements on the given crown by formulas; the optimal crown is found only by `--fem`."""
        yield (
            f"with the given crown, the line load is uniform under a load of {self.K_1_Q:.4g} N; "
            f"the crown is straight over {self.straight * 1e3:.3g} mm of {self.l * 1e3:g} mm"
        )
        if math.isfinite(self.N):
            ends = "are loaded" if self.static_end > 0 else "are unloaded"
            yield (
                f"at rest under T, the normal force of a sprag is {self.N:.4g} N, the largest "
                f"pressure is {self.static_peak / 1e6:.4g} MPa, and the ends of the sprag {ends}; "
                "the force of an engagement is up to twice as large"
            )

    def refusal(self) -> str:
        """Reason why no optimum is computed: no solution at rest, slip, or too many steps."""
        if reason := clutch_advice.refusal(self):
            return reason
        if self.mu_s < self.mu_req:
            return "the sprags slip: no crown prevents this"
        steps = self.t_end / self.dt
        return (
            f"t_end/dt = {steps:.4g} exceeds the limit of {MOST_STEPS} time steps of an engagement"
            if steps > MOST_STEPS else ""
        )  # fmt: skip

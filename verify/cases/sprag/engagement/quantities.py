"""Quantities of an engagement: the values of `formulas` with symbol, unit and source."""

import math
from collections.abc import Mapping

from analytic.sprag.race_spring import RaceSpring
from analytic.sprag.work_balance import stored
from verify.case import Case, Quantity, shared
from verify.cases.sprag.engagement.formulas import analytic
from verify.cases.sprag.engagement.model import wedge
from verify.cases.sprag.inputs import EngagementInputs

SPRING = "two races on a spring"


class EngagementFormulas(EngagementInputs, Case):
    """Quantities of an engagement; a quantity without a solution is nan.

    They follow from statics, energy, small oscillations and two races on a spring.
    """

    @shared
    def numbers(self) -> Mapping[str, float]:
        """Values of all formulas by name; values without a solution are omitted."""
        return analytic(self)

    def number(self, name: str) -> float:
        """Value of the formula `name`; nan if it has no solution."""
        return self.numbers.get(name, math.nan)

    @shared
    def wedge(self) -> RaceSpring:
        """The clutch as a spring over the wind-up of its races."""
        return wedge(self)

    @property
    def rolls_over(self) -> bool:
        """Whether the sprags rotate beyond their profile during the first oscillation."""
        return not math.isfinite(self.N_undamped) or bool(self.number("over"))

    @Quantity(
        "N_max",
        "N",
        f"largest normal force by the model of {SPRING}",
        source=SPRING,
        safe="too high",
    )
    def N_max(self) -> float:
        return self.number("N_max")

    @Quantity("t_max", "ms", "time of the largest normal force", source=SPRING, role="step")
    def t_max(self) -> float:
        return self.number("t_max")

    @Quantity("N_max/N", "1", "ratio of largest normal force to that at rest", role="step",
              tex=r"\frac{N_{max}}{N}")  # fmt: skip
    def factor(self) -> float:
        return self.number("factor")

    @Quantity("N", "N", "normal force at rest, with springs", equation="10")
    def N(self) -> float:
        return self.number("N")

    @Quantity("N_1", "N", "first peak of the normal force without damping, outer race fixed",
              safe="too high",
              source="first peak of the force without damping, outer race fixed",
              tex=r"N(\theta_1), \quad T\,\theta_1 = \int_0^{\theta_1} T(\theta)\,"
              r"\mathrm{d}\theta")  # fmt: skip
    def N_undamped(self) -> float:
        return self.number("N_undamped")

    @Quantity("W_1", "J", "work of the contact forces on all deflections, up to the force N_1",
              source="work balance",
              tex=r"n_s \int (N\,\mathrm{d}H_i + N_e\,\mathrm{d}H_e)")  # fmt: skip
    def W_1(self) -> float:
        return stored(self.wedge, self.N_undamped)

    @Quantity("N_r", "N", "largest normal force with rigid races (Liu)",
              source=SPRING, role="step")  # fmt: skip
    def N_max_rigid(self) -> float:
        return self.number("N_max rigid")

    @Quantity("N_m", "N", "largest normal force under 1.6 T", source=SPRING, role="step")
    def N_max_more(self) -> float:
        return self.number("N_max more")

    @Quantity("r", "1", "ratio of N_max under 1.6 T to N_max under T", source=SPRING,
              tex=r"\frac{N_m}{N_{max}}")  # fmt: skip
    def ratio(self) -> float:
        return self.number("ratio")

    @Quantity(
        "μ_r",
        "1",
        "friction coefficient required for rolling, tan ν",
        equation="10",
        safe="too high",
    )
    def mu_asked(self) -> float:
        return self.number("mu_asked")

    @Quantity("f", "Hz", "frequency of small oscillations, outer race fixed",
              source="linearised at rest, with the inertia of the sprags",
              tex=r"\frac{1}{2 \pi} \sqrt{\frac{k}{I_{bi} + I_s}}")  # fmt: skip
    def f(self) -> float:
        return self.number("f")

    @Quantity("k", "N m/rad", "stiffness dT/dθ of the clutch at rest", role="step")
    def k(self) -> float:
        return self.number("k")

    @Quantity("I_s", "kg m^2", "inertia of the sprags, reduced to the inner race", role="step")
    def I_s(self) -> float:
        return self.number("inertia") * self.I_bi

    @Quantity("θ", "deg", "wind-up of the races at rest", role="step")
    def theta(self) -> float:
        return self.number("theta")

    @Quantity("α", "deg", "rotation of the sprags at rest", role="step")
    def alpha(self) -> float:
        return self.number("alpha")

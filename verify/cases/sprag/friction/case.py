"""Friction of a sprag clutch: stick, slip, and the band of speeds that separates them."""

import math
from collections.abc import Iterator
from typing import ClassVar

from verify.case import Level, drawn_by
from verify.cases.sprag.engagement.formulas import MORE, swing, with_torque
from verify.cases.sprag.friction import comparisons as compared
from verify.cases.sprag.friction import figures as drawn
from verify.cases.sprag.friction.formulas import LAW, FrictionFormulas
from verify.cases.sprag.friction.reference import LEVELS, settled
from verify.core.figures import Equation
from verify.core.references import BY_INTEGRATION
from verify.form.adapter import adapted

MOST_STEPS = 50_000  # steps of a level: several hundred engagements are run
SURE = 1.1  # over the required friction


class SpragFriction(FrictionFormulas):
    """Sprags lock if the friction coefficient exceeds tan ν of the wedge; otherwise they slip.

    This limit is verified by the Runge-Kutta steps of the paper, in closed form and by the
    integrator LSODA, which stops at every change between stick and slip. A contact sticks if its
    sliding speed is within a narrow band. Time steps that are too long skip this band and give
    wrong forces without any sign of it; a check of the time step rejects them.
    """

    id = "sprag-friction"
    title = "Stick and slip of a sprag clutch"
    source = "huang2018"
    place = "Eqs. 12-16"
    method = BY_INTEGRATION
    levels: ClassVar = LEVELS
    readings: ClassVar = (
        "T_bis = μ_s N; with other values Eq. 12 is not continuous (ledger: eq-12-static-limit)",
        "T_stick maintains rolling of both contacts and damps residual sliding; the paper states "
        "only that T_stick maintains pure rolling",
        "ν is the wedge angle at rest under T; the required friction coefficient is T_i/N, which "
        "is slightly below tan ν because of the springs",
    )
    assumptions: ClassVar = (
        "μ_s, μ_c, γ_b and D_V are assumed, because the paper does not print them",
        "length, width and wedge angle of the sprags and the stiffness of the support are "
        "identified, not printed",
        "weak springs have the stiffness K_r/25; with the printed K_r no sprag slips at the start",
        "no oil; no centrifugal force on the sprags; the axes of the races do not move",
    )

    comparisons = compared.comparisons
    figures = drawn_by(drawn.figures)
    sketch = drawn.sketch

    def reference(self, level: int) -> Level:
        """Reference: Runge-Kutta steps of the paper, LSODA, and time steps rejected as too long."""
        from verify.cases.sprag.friction.reference import solve

        return solve(self, level)

    def laws(self) -> tuple[Equation]:
        """Equation of the law of friction."""
        return (LAW,)

    def refusal(self) -> str:
        """Reason why nothing is compared; empty if the engagement is compared.

        Reasons are rollover, too many steps, and too little friction.
        """
        more = swing(with_torque(self, MORE)).peak[1]
        if not (math.isfinite(more) and math.isfinite(self.mu_b)) or swing(self).over:
            return "the sprags roll over: nothing can be compared; check it without --fem"
        if LEVELS[-1] * settled(self) / self.dt > MOST_STEPS:
            return (
                f"{settled(self):.4g} s (t_end or five periods) require "
                f"{settled(self) / self.dt:.4g} time steps; the limit is "
                f"{MOST_STEPS // LEVELS[-1]} steps; check it without --fem"
            )
        if self.mu_c < SURE * self.asked_in_swing:
            return (
                f"mu_c = {self.mu_c:g} must exceed tan ν = {self.asked_in_swing:.4g} by "
                f"{SURE - 1:.0%}: sprags that slip at the start never stick; check it without "
                "--fem"
            )
        return ""

    def warnings(self) -> Iterator[str]:
        """Warnings if the sprags roll over, or if the clutch locks only without prior slip."""
        if not math.isfinite(self.mu_b):
            yield "the sprags roll over at a lower torque than T"
        elif self.mu_c < self.mu_b <= self.mu_s:
            yield (
                f"μ_c = {self.mu_c:g} is below the required friction coefficient "
                f"{self.mu_b:.4g}, μ_s = {self.mu_s:g} is above it: the clutch locks only if it "
                "does not slip first"
            )

    def advice(self) -> Iterator[str]:
        """Whether the clutch locks, and its drag torque while overrunning."""
        if not math.isfinite(self.mu_b):
            yield "rolls over: the sprags rotate beyond their profile"
            return
        first = f"locks: μ_s is {self.mu_s_share:.3g} times the required friction coefficient"
        if self.mu_s < self.mu_b:
            yield "slips permanently: the friction coefficient is below the required one"
        else:
            yield first if self.mu_c >= self.mu_b else f"{first}, but μ_c is below it"
        if math.isfinite(self.drag):
            yield f"the drag torque in overrunning is {self.drag:.3g} N m"


FRICTION = adapted(SpragFriction)

"""Friction of a sprag clutch: stick, slip, and the band in which steps distinguish them."""

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
    """Sprags lock if the friction coefficient exceeds tan ν of the wedge, and slide otherwise.

    This is verified in the paper's steps, in closed form and by LSODA with events. A time step that
    misses the whole band of sticking gives wrong forces without any sign; a guard rejects it.
    """

    id = "sprag-friction"
    title = "Stick and slip of a sprag clutch"
    source = "huang2018"
    place = "Eqs. 12-16"
    method = BY_INTEGRATION
    levels: ClassVar = LEVELS
    readings: ClassVar = (
        "T_bis = μ_s N: only so the branches of Eq. 12 join (ledger: eq-12-static-limit)",
        "T_stick maintains rolling of both contacts and damps residual sliding; printed is "
        "that it maintains pure rolling",
        "ν is that at rest under T; the required coefficient is T_i/N, less than tan ν by the "
        "share of the springs",
    )
    assumptions: ClassVar = (
        "μ_s, μ_c, γ_b and D_V are assumed: the paper prints none",
        "length, width, wedge angle and support are identified, not printed",
        "weak springs have a 25th of K_r: with the printed K_r no sprag slips at the start",
        "no oil, no centrifugal force on the sprags; contacts do not move",
    )

    comparisons = compared.comparisons
    figures = drawn_by(drawn.figures)
    sketch = drawn.sketch

    def reference(self, level: int) -> Level:
        """The paper's steps, LSODA and rejections by the guard."""
        from verify.cases.sprag.friction.reference import solve

        return solve(self, level)

    def laws(self) -> tuple[Equation]:
        """The law of friction."""
        return (LAW,)

    def refusal(self) -> str:
        """Sprags that roll over, too many steps, friction that never locks."""
        more = swing(with_torque(self, MORE)).peak[1]
        if not (math.isfinite(more) and math.isfinite(self.mu_b)) or swing(self).over:
            return "the sprags roll over: nothing is left to compare; check it without --fem"
        if LEVELS[-1] * settled(self) / self.dt > MOST_STEPS:
            return (
                f"{settled(self):.4g} s, t_end or five periods, take {settled(self) / self.dt:.4g} "
                f"steps of dt, above {MOST_STEPS // LEVELS[-1]}; check it without --fem"
            )
        if self.mu_c < SURE * self.asked_in_swing:
            return (
                f"mu_c = {self.mu_c:g} is not above tan ν = {self.asked_in_swing:.4g} by "
                f"{SURE - 1:.0%}: sprags that slip at the start never stick; check it without "
                "--fem"
            )
        return ""

    def warnings(self) -> Iterator[str]:
        """Warnings if the sprags roll over, or lock only without initial slip."""
        if not math.isfinite(self.mu_b):
            yield "the sprags roll over before they carry the torque"
        elif self.mu_c < self.mu_b <= self.mu_s:
            yield (
                f"μ_c = {self.mu_c:g} is below the required {self.mu_b:.4g}, μ_s = {self.mu_s:g} "
                "above it: it locks only where it does not slip first"
            )

    def advice(self) -> Iterator[str]:
        """Whether the clutch locks, and its drag while overrunning."""
        if not math.isfinite(self.mu_b):
            yield "rolls over: the sprags rotate past their profile"
            return
        first = f"locks: μ_s is {self.mu_s_share:.3g} times the required friction coefficient"
        if self.mu_s < self.mu_b:
            yield "slips permanently: the friction coefficient is below the required one"
        else:
            yield first if self.mu_c >= self.mu_b else f"{first}, but μ_c is below it"
        if math.isfinite(self.drag):
            yield f"overrunning, the races drag each other with {self.drag:.3g} N m"


FRICTION = adapted(SpragFriction)

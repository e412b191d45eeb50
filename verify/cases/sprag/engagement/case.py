"""Engagement of a sprag clutch in time (Huang, Zhao, Liu 2018, Eqs. 11-16)."""

from collections.abc import Iterator
from typing import ClassVar

from verify.case import Level, Scan, drawn_by
from verify.cases.sprag.engagement import comparisons as compared
from verify.cases.sprag.engagement import figures as drawn
from verify.cases.sprag.engagement.quantities import EngagementFormulas
from verify.cases.sprag.engagement.reference import LEVELS
from verify.core.references import BY_INTEGRATION
from verify.form.adapter import adapted

MOST_STEPS = 200_000  # steps of a level, limited by memory and the time of LSODA
SURE = 1.05  # over the required friction


class SpragEngagement(EngagementFormulas):
    """A suddenly applied torque makes the races oscillate on the sprags.

    The paper's equations of motion in its Runge-Kutta steps are refined in time and compared with
    LSODA with events, which shares only the closure, and with energy, statics and two races
    on a spring.
    """

    id = "sprag-engagement"
    title = "Engagement of a sprag clutch in time"
    source = "huang2018"
    place = "Eqs. 11-16, Sec. 2.4"
    method = BY_INTEGRATION
    levels: ClassVar = LEVELS
    scans: ClassVar = (
        Scan(vary=("T=15N m,25N m,32N m,40N m", "k_out=30000N m/rad,100000N m/rad"), star=True),
    )
    readings: ClassVar = (
        "driving is positive and locks at α > 0: the mirror image of Eq. 11, with the sign of the "
        "springs that closes (ledger: eq-11-14-spring-sign)",
        "forces of the races act at OA and OB of Eq. 9, not at half of them (eq-16-lever-arms)",
        "C_be is the moment of the support, −k_out θ_e (eq-16-outer-spring)",
        "N_be = N_bi in Eqs. 14 and 16; a strut in balance has N_e = N_i cos ω/cos ν",
        "the torque is a step on a clutch at rest under its springs",
    )
    assumptions: ClassVar = (
        "length, width, wedge angle, support and the crown's load are identified, not printed; "
        "friction, α_max and the centroid's place are assumed",
        "N follows from the rotation as at rest, by the closure that balances work: the iteration "
        "of the paper is explicit in N here",
        "all sprags are equal; races rotate, but neither bend nor move; no oil",
        "the centroid is at the distance OC_g(α): its radial motion is neglected, as in Eq. 14",
        "a contact sticks within a band of speeds; the band follows from the time step",
    )

    comparisons = compared.comparisons
    laws = staticmethod(drawn.motion)
    figures = drawn_by(drawn.figures)
    sketch = drawn.sketch

    def reference(self, level: int) -> Level:
        """The paper's steps, and LSODA with events."""
        from verify.cases.sprag.engagement.reference import solve

        return solve(self, level)

    def refusal(self) -> str:
        """Too many steps, sprags that roll over or slide."""
        if LEVELS[-1] * self.t_end / self.dt > MOST_STEPS:
            return (
                f"t_end/dt = {self.t_end / self.dt:.4g} is above {MOST_STEPS // LEVELS[-1]} steps"
            )
        if self.rolls_over:
            return "the sprags roll over: nothing is left to compare; check it without --fem"
        if "N_max more" not in self.numbers or self.number("over more"):
            return (
                "under 1.6 T, to which it is compared, the sprags roll over; check it without --fem"
            )
        start = self.number("start")
        if self.mu_s < start:
            return (
                f"the sprags slide at the start, where rolling requires μ = {start:.3g}: the "
                "formulas are those of rolling; see sprag-friction"
            )
        if self.mu_s < SURE * self.mu_asked:
            return (
                f"mu_s = {self.mu_s:g} is not above tan ν = {self.mu_asked:.4g} by {SURE - 1:.0%}: "
                "the sprags slip, or nearly so; see sprag-friction"
            )
        return ""

    def warnings(self) -> Iterator[str]:
        """Warnings if the sprags leave their profile, slide at the start or slip."""
        start = self.number("start")
        if self.rolls_over:
            yield (f"the profile ends at α_max = {self.alpha_max:.4g} rad before the first swing")
        if start > self.mu_s > self.mu_asked:
            yield (
                f"the springs press so little that the sprags slide at the start (μ = {start:.3g} "
                f"is required{', above μ_c' if self.mu_c < self.mu_asked else ''}): the "
                "forces here are those of rolling; see sprag-friction"
            )
        if self.mu_s < self.mu_asked:
            yield (
                f"friction μ_s = {self.mu_s:g} is below tan ν = {self.mu_asked:.4g}: the sprags "
                "slip, the forces here are those of rolling"
            )

    def advice(self) -> Iterator[str]:
        """Whether the clutch locks, and the effect of rigid races."""
        if self.rolls_over:
            yield "rolls over: the sprags rotate past their profile"
        elif self.mu_s < self.mu_asked:
            yield "slips: the friction coefficient is below the required one, tan ν"
        else:
            yield (
                f"locks: N swings to {self.N_max:.4g} N, {self.factor:.3g} times that at rest, "
                f"after {self.t_max * 1e3:.3g} ms"
            )
            yield f"with rigid races (Liu) {self.number('rigid') - 1:+.1%}"


ENGAGEMENT = adapted(SpragEngagement)

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
    """Oscillation of the races on the sprags after a torque is suddenly applied.

    The equations of motion of the paper are solved by its Runge-Kutta steps, with refined time
    steps. The results are compared with those of the integrator LSODA, which stops at every change
    between stick and slip and has only the geometric closure in common with them. They are also
    compared with an energy balance, statics and the model of two races on a spring.
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
        "the driving direction is positive and the clutch locks at α > 0, whereas Eq. 11 has the "
        "opposite sign of α; the springs have the sign that closes the contacts (ledger: "
        "eq-11-14-spring-sign)",
        "the forces on the races act at the radii OA and OB of Eq. 9, not at half of these radii "
        "(ledger: eq-16-lever-arms)",
        "C_be is the moment of the support, −k_out θ_e (ledger: eq-16-outer-spring)",
        "N_be = N_bi in Eqs. 14 and 16; for a sprag loaded by two forces in equilibrium, "
        "N_e = N_i cos ω/cos ν",
        "the torque is a step; before it, the clutch is at rest under its springs",
    )
    assumptions: ClassVar = (
        "length, width and wedge angle of the sprags, the stiffness of the support and the design "
        "load of the crown are identified, not printed; friction, α_max and the position of the "
        "centroid are assumed",
        "N depends on the rotation as in statics, by the closure that satisfies the work balance; "
        "the iteration of the paper is not necessary",
        "all sprags are equal; the races rotate, but their axes do not move or bend; no oil",
        "the centroid is at the distance OC_g(α) from the axis; its radial motion is neglected, as "
        "in Eq. 14",
        "a contact sticks within a band of sliding speeds; the width of the band follows from the "
        "time step",
    )

    comparisons = compared.comparisons
    laws = staticmethod(drawn.motion)
    figures = drawn_by(drawn.figures)
    sketch = drawn.sketch

    def reference(self, level: int) -> Level:
        """Reference: Runge-Kutta steps of the paper, and LSODA with events."""
        from verify.cases.sprag.engagement.reference import solve

        return solve(self, level)

    def refusal(self) -> str:
        """Reason why no engagement is computed: too many steps, rollover or slip; else empty."""
        if LEVELS[-1] * self.t_end / self.dt > MOST_STEPS:
            return (
                f"t_end/dt = {self.t_end / self.dt:.4g} exceeds the limit of "
                f"{MOST_STEPS // LEVELS[-1]} time steps"
            )
        if self.rolls_over:
            return "the sprags roll over: nothing can be compared; check it without --fem"
        if "N_max more" not in self.numbers or self.number("over more"):
            return (
                "the comparison also needs an engagement under 1.6 T, in which the sprags roll "
                "over; check it without --fem"
            )
        start = self.number("start")
        if self.mu_s < start:
            return (
                f"the sprags slip at the start, because rolling requires μ = {start:.3g}; the "
                "formulas assume rolling; see case sprag-friction"
            )
        if self.mu_s < SURE * self.mu_asked:
            return (
                f"mu_s = {self.mu_s:g} must exceed tan ν = {self.mu_asked:.4g} by "
                f"{SURE - 1:.0%}: the sprags slip or almost slip; see case sprag-friction"
            )
        return ""

    def warnings(self) -> Iterator[str]:
        """Warnings if the sprags roll beyond their profile, slip at the start, or slip under T."""
        start = self.number("start")
        if self.rolls_over:
            yield (f"the profile ends at {self.alpha_max:.4g} rad, within the first oscillation")
        if start > self.mu_s > self.mu_asked:
            yield (
                f"the springs are so weak that the sprags slip at the start (required: μ = "
                f"{start:.3g}{', and μ_c is below tan ν' if self.mu_c < self.mu_asked else ''}); "
                "the forces here assume rolling; see case sprag-friction"
            )
        if self.mu_s < self.mu_asked:
            yield (
                f"friction μ_s = {self.mu_s:g} is below tan ν = {self.mu_asked:.4g}: the sprags "
                "slip; the forces here assume rolling"
            )

    def advice(self) -> Iterator[str]:
        """Whether the clutch locks, and the effect of rigid races."""
        if self.rolls_over:
            yield "rolls over: the sprags rotate beyond their profile"
        elif self.mu_s < self.mu_asked:
            yield "slips: the friction coefficient is below the required one, tan ν"
        else:
            yield (
                f"locks: the largest normal force is {self.N_max:.4g} N, {self.factor:.3g} times "
                f"the normal force at rest; the largest force occurs at {self.t_max * 1e3:.3g} ms"
            )
            yield f"rigid races (Liu) change the largest force by {self.number('rigid') - 1:+.1%}"


ENGAGEMENT = adapted(SpragEngagement)

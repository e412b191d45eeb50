"""A logarithmic sprag clutch of the user: verdict, limits, engagement."""

from typing import ClassVar

from verify.case import Level, Scan, drawn_by
from verify.cases.sprag.clutch import advice as advised
from verify.cases.sprag.clutch import comparisons as compared
from verify.cases.sprag.clutch import figures as drawn
from verify.cases.sprag.clutch import sketch as sketched
from verify.cases.sprag.clutch.dynamic import DYNAMIC
from verify.cases.sprag.clutch.formulas import ClutchFormulas
from verify.cases.sprag.inputs import ASSUMED, IDENTIFIED, named
from verify.core.references import BY_STRIPS
from verify.form.adapter import adapted


class SpragClutch(ClutchFormulas):
    """Whether a logarithmic sprag clutch holds, and which limit is reached first.

    With growing torque these are friction, pressure, the end of the profile; in time, the first
    peak of an engagement. The reference is this sprag drawn point by point, and strips instead of
    slices: they verify geometry, equilibrium and pressures with equal deflections. Case
    sprag-wedge has finite elements of the whole clutch. The paper's figures depend on
    5 inputs that it does not print and that are identified here (l, b, ν_0, k_out, Q), and 8 that
    are assumed: results that depend on them are calibrated, not evidence.
    """

    id = "sprag-clutch"
    title = "Sprag clutch under torque and in engagement"
    source = "huang2018"
    place = "Eqs. 1-16, Table 1, Sec. 4"
    method = BY_STRIPS
    levels: ClassVar = (41, 81, 161)  # strips along a sprag
    dynamic = DYNAMIC
    scans: ClassVar = (Scan(vary=("T=12N m,25N m,40N m", "R_ed=23mm,26.23mm,32mm"), star=True),)
    readings: ClassVar = (
        "r_i of Table 1 is the spiral's radius of curvature at first contact",
        "T acts on the whole clutch, N is the normal force of one sprag",
        "z_m is in millimetres: no unit is printed",
    )
    assumptions: ClassVar = (
        *(
            f"in the paper's clutch: {named([name])} identified, {why}"
            for name, why in IDENTIFIED.items()
        ),
        "in the paper's clutch: assumed are "
        + "; ".join(f"{named([name])} ({why})" for name, why in ASSUMED.items()),
        "α_max is both where the profile ends and where the springs are slack",
        "all sprags are equal and share the load; races are uniformly loaded rings in plane "
        "stress, the sprag is a bar, contacts are slices by Palmgren's law; elastic bodies differ "
        "(α_el): 5.7° by finite elements of the paper's clutch, 7.2° by these deflections",
        "n affects the growth of the outer race only: centrifugal forces on the sprags and in the "
        "stresses of the races are neglected",
        "stresses of the races are Lamé's under uniformly distributed forces, in plane stress; R_p "
        "limits Tresca's at both bores",
        "a verdict without --dynamic is of a torque that rises slowly",
        "the closure takes the deflections of the whole inner side to the unstrained spiral "
        "(Eqs. 9 and 10, corrected), so that the torque's work is theirs",
        "the pressures of the engagement are those of statics at its largest normal force",
        "without a crown the largest pressure is that of the end slices: it has no limit as "
        "their number grows",
    )

    comparisons = compared.stated
    figures = drawn_by(drawn.figures)
    sketch = sketched.sketch
    warnings = advised.warnings
    advice = advised.findings
    summary = advised.summary
    refusal = advised.refusal

    def reference(self, level: int) -> Level:
        """The sprag drawn point by point, strips for its slices, compiled engagements."""
        from verify.cases.sprag.clutch.reference import solve

        return solve(self, level)


CLUTCH = adapted(SpragClutch)

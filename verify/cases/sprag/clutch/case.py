"""A logarithmic sprag clutch with a user's inputs: verdict, limits, engagement."""

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

    The limits of an increasing torque are friction, pressure and the end of the profile. In an
    engagement, the first peak of the force is critical. The reference computes the profile of the
    sprag point by point and uses strips instead of slices. It verifies geometry, equilibrium and
    pressures for the same deflection laws. Case sprag-wedge contains finite elements of the whole
    clutch. The paper does not print 5 inputs, which are identified here (l, b, ν_0, k_out, Q), and
    8 inputs, which are assumed. Results that depend on identified inputs are calibrated and are
    not evidence.
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
        "r_i of Table 1 is the spiral's radius of curvature at the inner contact without load",
        "T acts on the whole clutch, N is the normal force of one sprag",
        "z_m is in millimetres; the paper prints no unit",
    )
    assumptions: ClassVar = (
        *(
            f"clutch of the paper: {named([name])} is identified; it is the {why}"
            for name, why in IDENTIFIED.items()
        ),
        "clutch of the paper: the assumed inputs are "
        + "; ".join(f"{named([name])} ({why})" for name, why in ASSUMED.items()),
        "at the sprag rotation α_max the profile ends, and the springs are slack",
        "all sprags are equal and carry equal loads; races are uniformly loaded rings in plane "
        "stress, the sprag is a bar, contacts are slices by Palmgren's law. In the clutch of the "
        "paper, the sprags rotate by 7.2° with these deflections, and by 5.7° with those of "
        "elastic bodies (α_el)",
        "the speed n only causes centrifugal growth of the outer race: centrifugal forces "
        "on the sprags and centrifugal stresses of the races are neglected",
        "the stresses of the races are those by Lamé under uniformly distributed forces, in plane "
        "stress; R_p limits the Tresca stress at both bores",
        "a verdict without --dynamic applies to a slowly rising torque",
        "the closure (Eqs. 9 and 10, corrected) uses the undeformed spiral and the deflections of "
        "the whole inner side, so that the work of the torque equals the work of the normal forces "
        "on the deflections",
        "the pressures of an engagement are static pressures under its largest normal force",
        "without a crown, the largest pressure is that of the end slices; it grows without limit "
        "with the number of slices",
    )

    comparisons = compared.stated
    figures = drawn_by(drawn.figures)
    sketch = sketched.sketch
    warnings = advised.warnings
    advice = advised.findings
    summary = advised.summary
    refusal = advised.refusal

    def reference(self, level: int) -> Level:
        """Results of the profile computed point by point, strips and computed engagements."""
        from verify.cases.sprag.clutch.reference import solve

        return solve(self, level)


CLUTCH = adapted(SpragClutch)

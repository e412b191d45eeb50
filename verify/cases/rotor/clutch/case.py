"""Stiffness of a sprag clutch between two rotors (Eqs. 1-11), against struts between rigid hubs."""

from typing import ClassVar

from verify.case import Level, Scan, drawn_by
from verify.cases.rotor.clutch import advice as advised
from verify.cases.rotor.clutch import comparisons as compared
from verify.cases.rotor.clutch import figures as drawn
from verify.cases.rotor.clutch.formulas import ClutchStiffness
from verify.core.references import Method
from verify.form.adapter import adapted


class ClutchLink(ClutchStiffness):
    """A sprag clutch under torque acts as a bearing and a torsion spring between two rotors.

    Eqs. 1 to 11 derive the stiffness of the clutch from one potential. In the reference, each sprag
    is a strut between rigid hubs; the struts are inclined by the wedge angle, and the kinematics
    are exact. The terms that the equations neglect are derived separately; they give the expected
    intervals of errors.
    """

    id = "rotor-clutch"
    title = "Sprag clutch between two rotors"
    source = "huang2022"
    place = "Eqs. 1-11"
    method: ClassVar = Method("struts with exact kinematics", "struts")
    levels: ClassVar = (16, 32, 64, 128)
    scans: ClassVar = (
        Scan(
            vary=(
                "T=5N m,15N m,40N m", "Z=8,12,24", "nu=2.5deg,3.15deg,5deg", "n_s=11,41",
                "e=0.3µm,1µm", "drop=0.3µm,1µm", "L=6mm,9mm",
            ),
            star=True,
        ),
        Scan(vary=("T=15N m,40N m", "Z=8,12", "nu=2.5deg,3.15deg", "L=6mm,9mm")),
    )  # fmt: skip
    readings: ClassVar = (
        "d_t in Eq. 4 is R_i tan ν, because Z normal forces N cause the torque T = Z N R_i tan ν",
        "k_n in Eq. 2 is the constant of the force law of a whole sprag: the deflection of a sprag "
        "is the sum of the deflections of both contacts; the tangent stiffness is the slope of "
        "this force law",
        "the angle of twist in Eq. 8 includes the twist under the preload torque T",
        "in Eq. 6, both contacts of a sprag have the crown L(x_k): together they reduce the "
        "deflection by 2 L(x_k)",
    )
    assumptions: ClassVar = (
        "the races are rigid; each sprag transmits a force along the line through both contacts; "
        "its deflection is the sum of the deflections of two line contacts",
        "with elastic races, the wind-up of the same clutch is almost twice the wind-up with rigid "
        "races; the verdicts of Eqs. 2, 4 and 11 use the comparison with elastic races in the case "
        "sprag-wedge",
        "the sprags roll on the races, so that the distance from the axis to the line of action of "
        "each sprag force is constant",
        "if the inner race has an offset or sprags are missing, bearings hold the inner race in "
        "position; the torque T is the same in all states",
        "the crown is a parabola; Eq. 6 is valid for any profile of the crown",
    )

    comparisons = compared.rows
    figures = drawn_by(drawn.figures)
    sketch = drawn.sketch
    warnings = advised.warnings
    advice = advised.findings
    summary = advised.summary
    refusal = advised.refusal

    def reference(self, level: int) -> Level:
        """Results of struts in all states, with `level` slices for each sprag."""
        from verify.cases.rotor.clutch.reference import solve

        return solve(self, level)


CLUTCH = adapted(ClutchLink)

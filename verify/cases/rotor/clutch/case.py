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

    Its stiffness is derived from one potential and compared with that of struts between rigid hubs.
    The struts have the inclination of the sprags, and their kinematics are exact. The terms that
    the equations neglect are derived; they give the intervals of the expected errors.
    """

    id = "rotor-clutch"
    title = "Sprag clutch as a link of two rotors"
    source = "huang2022"
    place = "Eqs. 1-11"
    method: ClassVar = Method("struts in exact kinematics", "struts")
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
        "d_t of Eq. 4 is R_i tan ν, as follows from T = Z N R_i tan ν",
        "k_n of Eq. 2 is the constant of the force law of a whole sprag with both contacts; the "
        "slope of this law is the tangent stiffness",
        "the twist of Eq. 8 includes the twist under the preload",
        "2 L(x_k) in Eq. 6: both contacts have the crown",
    )
    assumptions: ClassVar = (
        "rigid races; sprags are forces along lines, with the deflection of line contacts",
        "with elastic races, the wind-up of the same clutch is almost twice as large: the row on "
        "rigid races in sprag-wedge gives the value for the verdicts of Eqs. 2, 4 and 11",
        "sprags roll, so that the distance of their lines of action from the axis is constant",
        "with an offset or a gap, the bearings hold the inner race in position; the torque is "
        "constant",
        "the crown is a parabola; Eq. 6 is valid for any crown",
    )

    comparisons = compared.rows
    figures = drawn_by(drawn.figures)
    sketch = drawn.sketch
    warnings = advised.warnings
    advice = advised.findings
    summary = advised.summary
    refusal = advised.refusal

    def reference(self, level: int) -> Level:
        """Struts in all states, with `level` slices for each sprag."""
        from verify.cases.rotor.clutch.reference import solve

        return solve(self, level)


CLUTCH = adapted(ClutchLink)

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
    """A sprag clutch under torque is a bearing and a torsion spring between two rotors.

    Its stiffness is derived from one potential and compared with struts between rigid hubs,
    inclined as the sprags, in exact kinematics. The terms that the equations neglect are derived;
    they give the intervals of the rows.
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
        "d_t of Eq. 4 is R_i tan ν, which T = Z N R_i tan ν requires",
        "k_n of Eq. 2 is the constant of a whole sprag's law for both contacts; its slope is the "
        "tangent stiffness",
        "the twist of Eq. 8 counts the preload's",
        "2 L(x_k) of Eq. 6: both contacts have the crown",
    )
    assumptions: ClassVar = (
        "rigid races; sprags are forces along lines that deflect as line contacts",
        "with elastic races the wind-up of the same clutch is almost twice as large: the row on "
        "rigid races in sprag-wedge gives the value for the verdicts of Eqs. 2, 4 and 11",
        "sprags roll, so that the distance of their lines from the axis is constant",
        "the bearings hold an offset or a gap; the torque is constant",
        "the crown is a parabola; Eq. 6 is valid for any",
    )

    comparisons = compared.rows
    figures = drawn_by(drawn.figures)
    sketch = drawn.sketch
    warnings = advised.warnings
    advice = advised.findings
    summary = advised.summary
    refusal = advised.refusal

    def reference(self, level: int) -> Level:
        """Struts, `level` slices for each sprag."""
        from verify.cases.rotor.clutch.reference import solve

        return solve(self, level)


CLUTCH = adapted(ClutchLink)

"""Stiffness of a sprag clutch between two rotors (Eqs. 1-11), beside struts between rigid hubs."""

from verify.cases.rotor.clutch import figures as shown
from verify.cases.rotor.clutch.claims import CHECKS
from verify.cases.rotor.clutch.fem import fem
from verify.cases.rotor.clutch.inputs import ClutchInputs
from verify.cases.rotor.clutch.messages import findings, summary, too_large, warnings
from verify.cases.rotor.clutch.model import analytic
from verify.core.case import Case, Output, Scan
from verify.core.references import Method

CLUTCH = Case(
    id="rotor-clutch",
    title="Sprag clutch as a link of two rotors",
    paper="huang2022",
    place="Eqs. 1-11",
    lead="A clutch that a torque presses is a bearing and a torsion spring. Its stiffness follows "
    "from one potential; beside it stand struts between rigid hubs, inclined as the sprags are, in "
    "exact kinematics. What the equations leave out is derived, and so are the rows' intervals.",
    inputs=ClutchInputs,
    analytic=analytic,
    method=Method("struts in exact kinematics", "struts"), reference=fem,
    levels=(16, 32, 64, 128),
    scans=(
        Scan(
            vary=(
                "T=5N m,15N m,40N m", "Z=8,12,24", "nu=2.5deg,3.15deg,5deg", "n_s=11,41",
                "e=0.3µm,1µm", "drop=0.3µm,1µm",
            ),
            star=True,
        ),
    ),
    checks=CHECKS,
    outputs=(
        Output(key="N", symbol="N", unit="N", what="normal force of a sprag", judged=False),
        Output(key="delta_0", symbol="δ_0", unit="µm", what="yield of both its contacts (Eq. 2)",
               judged=False),
        Output(key="twist", symbol="γ_0", unit="deg", what="twist of the races", judged=False),
        Output(key="K_xx", symbol="K_xx", unit="N/mm", what="radial stiffness, uniform"),
        Output(key="K_tilt", symbol="K_tilt", unit="N m/rad", what="tilting stiffness, uniform"),
        Output(key="K_zz", symbol="K_zz", unit="N m/rad", what="torsional stiffness, uniform"),
        Output(key="K_xz, offset", symbol="K_xz", unit="N",
               what="coupling of bending and torsion, with the offset"),
        Output(key="K_xx, gap", symbol="K_xx", unit="N/mm",
               what="stiffness along x, with sprags missing"),
        Output(key="K_yy, gap", symbol="K_yy", unit="N/mm",
               what="stiffness along y, with sprags missing"),
        Output(key="K_xz, gap", symbol="K_xz", unit="N",
               what="coupling of bending and torsion, with sprags missing"),
        Output(key="K_tilt, crown", symbol="K_tilt", unit="N m/rad",
               what="tilting stiffness, with the crown"),
        Output(key="K_zz, together", symbol="K_zz", unit="N m/rad",
               what="torsional stiffness, with offset, crown and gap"),
    ),
    readings=(
        "d_t of Eq. 4 is R_i tan ν, which T = Z N R_i tan ν asks for",
        "k_n of Eq. 2 is the constant of a whole sprag's law for both contacts; its slope is the "
        "tangent stiffness",
        "the twist of Eq. 8 counts the preload's",
        "2 L(x_k) of Eq. 6: both contacts have the crown",
    ),
    assumptions=(
        "rigid races; sprags are forces along lines that yield as line contacts do",
        "sprags roll, so that their lines keep their distance from the axis",
        "an offset and a gap are held by the bearings; the torque stays the same",
        "the crown is a parabola; Eq. 6 takes any",
    ),
    findings=findings,
    summary=summary,
    warnings=warnings,
    too_large=too_large,
    equations=shown.equations,
    sketch=shown.sketch,
    figures=shown.figures,
)  # fmt: skip

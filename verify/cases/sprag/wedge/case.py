"""A logarithmic sprag wedged between its races (Huang, Zhao, Liu, Eqs. 6, 7, 9, 10)."""

from collections.abc import Iterator
from typing import ClassVar

from verify.case import Level, Scan, drawn_by, picture
from verify.cases.sprag.wedge import advice as advised
from verify.cases.sprag.wedge import comparisons as compared
from verify.cases.sprag.wedge import figures as drawn
from verify.cases.sprag.wedge import sketch as sketched
from verify.cases.sprag.wedge.closure import WedgeSteps
from verify.core.figures import Picture
from verify.form.adapter import adapted

STUDIED = (  # rows of the study
    "force ratio T_i/N_i against tan ν (Eq. 10), at N_0",
    "force ratio T_i/N_i against tan ν (Eq. 10), at 1.8 N_0",
    "normal force (Eq. 10), at T",
    "rotation of the sprags, at T",
    "rotation of the sprags as in the paper",
    "torque n_s N tan(ν) OA, at N_0",
    "total deflection of elastic bodies, at N_0",
    "displacement of the outer race under a sprag, taken as the mean",
    "mean displacement of the outer race (Eq. 6 as printed",
    "mean displacement of the inner race (Eq. 6 as printed",
    "peak pressure on the inner race (Hertz), at N_0",
    "peak pressure on the outer race (Hertz), at N_0",
    "excess of N_e over N_i",
    "rotation of the sprags with Palmgren's law",
    "rotation of the sprags with elastic deflections, at N_0",
    "wind-up of a clutch with rigid races",
    "torsional stiffness of a clutch with rigid races",
)
THIN_RACES = ("R_ed=23mm", "R_id=9.5mm", "T=12.5N m")  # that bend between few sprags
NEAR_FLANK = (
    "z=8",
    "nu_0=2.5deg",
    "T=12.5N m",
)  # few sprags and a small angle: contacts near the flanks


class WedgedSprag(WedgeSteps):
    """A logarithmic sprag between two races, under up to 1.8 times the force of a rigid clutch.

    The sprag rotates because its contacts, its body and the races deflect. The case gives the
    wedge angle, the normal force, the sprag rotation and the wind-up. The reference is a
    finite-element model of one pitch of both races with a free sprag. It confirms the geometric
    closure of Eqs. 9 and 10 if all deflections of the inner side are included. As printed, Eqs. 9
    and 10 give a sprag rotation that is one eighth too small for the same deflections. The
    deflections by Palmgren's law with Eqs. 6 and 7 are one quarter too large.
    """

    id = "sprag-wedge"
    title = "Logarithmic sprag wedged between its races"
    source = "huang2018"
    place = "Eqs. 6, 7, 9, 10"
    levels: ClassVar = (9, 12, 15)  # cells on half a fine zone, of which contacts take 6, 8, 10
    scans: ClassVar = (
        Scan(
            vary=("T=12.5N m,25N m,40N m", "R_ed=23mm,26.23mm,32mm",
                  "R_id=4mm,7.21mm,9.5mm", "z=8,12,16", "nu_0=2.5deg,3.15deg,5deg"),
            only=STUDIED, star=True,
        ),
        Scan(vary=("z=6,8,10,12",), only=STUDIED, at=THIN_RACES),
        Scan(vary=("T=12.5N m,22N m",), only=STUDIED, at=NEAR_FLANK),
    )  # fmt: skip
    readings: ClassVar = (
        "r_i of Table 1 is the spiral's radius of curvature at first contact",
        "a normal force acts at the deformed contact surface: the lever arms OA and OB include "
        "half of the deflection of each contact (Eq. 9)",
        "the triangle of Eq. 10 is that of the undeformed spiral: its side on the inner race "
        "includes all deflections of the inner side",
        "T is the torque of the whole clutch, N the force of one sprag on the inner race",
        "sprags and races are in plane strain (no axial strain); the rings of Eq. 6 have free ends",
    )
    assumptions: ClassVar = (
        "the sprag is a column of the width b with rounded ends; l, b and ν_0 are identified, E "
        "and ν are assumed, because the paper does not print them",
        "the finite-element model is one pitch; both races can expand freely; the undeformed "
        "contours overlap by the deflection; the friction coefficient is five times the required "
        "one",
        "five states are computed; splines over ln N interpolate between them, a power law "
        "extrapolates to smaller loads",
        "elastic deflections: the races are rings under concentrated forces, one at each sprag "
        "(Fourier series); the sprag is loaded by two opposed forces at its contacts (complex "
        "potentials)",
        "expected errors: the angles change because the column bends (its contacts lie beside the "
        "centre line) and its ends roll further. Tangential forces increase the wind-up by 0.4 "
        "tan²ν to 1.2 tan²ν (relative). The error of Hertz's theory is (a/r)²",
        "small strains: forces act at the undeformed ends of the sprag; the balance of moments "
        "omits the sideways displacement of these ends by bending",
    )

    comparisons = compared.comparisons
    figures = drawn_by(drawn.figures)
    sketch = sketched.sketch
    warnings = advised.warnings
    advice = advised.advice
    summary = advised.summary
    refusal = advised.refusal

    def reference(self, level: int) -> Level:
        """Finite-element results of one pitch with friction, at all states of the stroke."""
        from verify.cases.sprag.wedge.reference import solve

        return solve(self, level)

    def pictures(self) -> Iterator[Picture]:
        """Picture of the sector in the state with the largest load."""
        yield picture(
            "sector", "log_mises", "Von Mises stress of one pitch in the state with the largest "
            "load. The force acts along the line through both contacts, beside the centre line of "
            "the sprag. Stresses below 10 MPa have one colour", displacement="",
        )  # fmt: skip


WEDGE = adapted(WedgedSprag)

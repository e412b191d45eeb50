"""Accordion spring, the whole curve: geometrically exact beams that touch (Wang et al. 2023)."""

from collections.abc import Sequence

from analytic.spring.wide_leaf import width_factor
from verify.cases.spring.curve import figures as spring_curve_shown
from verify.cases.spring.curve.claims import CHECKS
from verify.cases.spring.curve.inputs import CurveInputs
from verify.cases.spring.curve.runs import LEVELS, fem
from verify.cases.spring.inputs import too_slender
from verify.cases.spring.stages.sketch import sketch as stages_sketch
from verify.core.case import Case, Output, Values
from verify.judging.published_checks import PrintedMeasurement

OTHER_WIDTH = 0.005  # between the factor given and that of a leaf


def analytic(q: CurveInputs) -> Values:
    form = spring_curve_shown.linear(q)
    values = {key: float(getattr(form, key)) for key in ("k1", "U_A", "F_A", "k2")}
    return {key: value for key, value in values.items() if value < float("inf")}


def warnings(q: CurveInputs, v: Values) -> Sequence[str]:
    found = []
    if q.head == "free":
        found.append("a free head buckles sideways early: see case spring-buckling for the load")
    leaf = float(width_factor(q.h, q.leaf, nu=q.nu))
    if abs(leaf / q.width_factor - 1) > OTHER_WIDTH:
        found.append(
            f"width_factor = {q.width_factor:.5g}, but leaves of this width and length are "
            f"stiffened by {leaf:.5g}: forces change by {leaf / q.width_factor - 1:+.1%}"
        )
    if "U_A" not in v:
        found.append("linear theory lets no leaves touch with these ends")
    return found


def too_large(q: CurveInputs) -> str:
    """Only guided heads are followed: a free one buckles, a hinged one moves sideways."""
    if q.head != "guided":
        return (
            f"head = {q.head}: the whole curve is followed for a guided head alone, the first "
            "stage of another is in spring-stages and its sideways movement in spring-buckling"
        )
    return too_slender(q)


CURVE = Case(
    id="spring-curve",
    title="Accordion spring, the whole curve",
    paper="wang2023",
    place="Sec. 2, Eq. 10, Fig. 9; Table 1",
    lead="Force over displacement through all stages by geometrically exact beams that touch each "
    "other with friction: how far straight lines hold, and which reading of the paper's spring "
    "gives its Eq. 10.",
    inputs=CurveInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    checks=(
        *CHECKS,
        *(
            PrintedMeasurement(
                name=f"{symbol} of the closed form against the {what}", symbol=symbol,
                unit="N/mm", analytic=key, reference=f"wang2023:{key}-{name}",
            )
            for key, symbol in (("k1", "k_1"), ("k2", "k_2"))
            for name, what in (("fea", "paper's shell model"), ("test", "paper's test"))
        ),
    ),
    outputs=(
        Output(key="k1", symbol="k_1", unit="N/mm", what="stiffness at rest"),
        Output(key="U_A", symbol="U_A", unit="mm", judged=False,
               what="displacement where leaves touch, linear theory"),
        Output(key="F_A", symbol="F_A", unit="N", what="force there, linear theory",
               judged=False),
        Output(key="k2", symbol="k_2", unit="N/mm", what="stiffness beyond, linear theory",
               judged=False),
    ),
    quick=False,
    readings=(
        "r is the radius of the arcs' centre line, as a shell model's middle surface would be "
        "drawn from the printed dimensions; chosen with tail and head by k_1 alone (calibrated)",
        "the tail is held in the middle of its leaf, the head moves along the axis and does not "
        "turn",
        "k_1 and k_2 of a curve are least-squares lines before and after the leaves touch",
        "the width factor f is that of the shell in case spring-width",
    ),
    assumptions=(
        "plane deformation of a strip with one bending stiffness; linear elastic",
        "free ends of leaves are round, b/2 in radius",
        "friction by Coulomb between leaves; none at the head, whose movement is given",
    ),
    warnings=warnings,
    too_large=too_large,
    equations=spring_curve_shown.equations,
    tables=spring_curve_shown.tables,
    sketch=stages_sketch,
    figures=spring_curve_shown.figures,
)  # fmt: skip

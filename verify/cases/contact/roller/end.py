"""A roller's end face: finite elements of both bodies where a half-space has no face at all."""

from verify.cases.contact.roller import end_figures
from verify.cases.contact.roller.accepted import Estimated
from verify.cases.contact.roller.end_fem import CROWNS, EndInputs, fem
from verify.cases.contact.roller.end_figures import BODIES
from verify.cases.contact.roller.end_formulas import analytic
from verify.core.case import Case, Context, Output, Values
from verify.judging.checks import Accepted, Approximation, Margin

FACE = 0.10  # of the load within d of the ends that the face takes at least
MOSTLY = 1 / 3  # of what the face takes, which the bodies' size stays below
EDGE_LEFT = 5e-3  # of the slope at the edge itself: terms of the order of its distances


def local(q: EndInputs, _: Values) -> tuple[float, float]:
    """Hertz at the line load at mid-length: circles and the change of load along y are neglected.

    Each with a factor of one about the square of the half-width over the radius and half-length.
    """
    most = (q.b / q.R_1) ** 2 + (2 * q.b / q.L) ** 2 + 1e-3
    return -most, most


def face(crown: str) -> Margin:
    """What the end face takes off the load near it, beyond FACE."""

    def margin(context: Context) -> tuple[float, float, str]:
        here, on, U = _apart(context, "end", crown)
        beyond, _, _ = _apart(context, "control", crown)
        told = (
            f"{here / on - 1:+.1%} of the half-space's, {here / beyond - 1:+.1%} of the control's"
        )
        return 1 - here / on - FACE, U, told

    return margin


def mostly(crown: str) -> Margin:
    """How far what the bodies' size takes is below a share of what the end face does."""

    def margin(context: Context) -> tuple[float, float, str]:
        face_, on, U = _apart(context, "end", crown)
        size, _, U_size = _apart(context, "control", crown)
        left = MOSTLY * (1 - face_ / on) - abs(1 - size / on)
        return left, MOSTLY * U + U_size, f"{size / on - 1:+.1%} against {face_ / on - 1:+.1%}"

    return margin


def _apart(context: Context, name: str, crown: str) -> tuple[float, float, float]:
    v = context.series(f"{name} {crown} ends")[1]
    on = context.analytic[f"{crown} ends"]
    return v[-1], on, 3 * (max(v) - min(v)) / on


CHECKS = (
    *(
        Approximation(
            name=f"pressure at mid-length over Hertz's at the line load there, {crown}, {words}",
            symbol="p/p_H", unit="1", fem=f"{name} {crown} local", analytic="one", formal=2,
            interval=local, demand=4e-3, demand_reason="cells across are even in pressure",
            source="argued: (b/R_1)² + (2b/l)², and 1e-3 of the cells")
        for name, words in list(BODIES.items())[:1] for crown in CROWNS
    ),
    *(
        Estimated(
            name=f"load within d of the ends, half-space, {crown}, {words}", symbol="F_d",
            unit="N", fem=f"{name} {crown} ends", analytic=f"{crown} ends", formal=1,
            interval=None, source="what a half-space costs is measured here")
        for name, words in BODIES.items() for crown in CROWNS
    ),
    *(
        Accepted(name=f"the end face takes {FACE:.0%} or more off the load near it, {crown}",
             symbol="F_d", unit="1", margin=face(crown))
        for crown in CROWNS
    ),
    *(
        Accepted(name=f"most of it is the face: the bodies' size costs less than a third, {crown}",
             symbol="F_d", unit="1", margin=mostly(crown))
        for crown in CROWNS
    ),
    Approximation(
        name="sharpness of a right-angled edge on its own material", symbol="λ − 1", unit="1",
        fem="edge slope", analytic="edge", formal=2,
        interval=lambda _q, _v: (-EDGE_LEFT, EDGE_LEFT),
        source="argued: terms of the order of the distance, 1 and 2 thousandths of the radius"),
)  # fmt: skip

OUTPUTS = (
    Output(key="Hertz p0", symbol="p_0", unit="MPa", what="Hertz's of a load spread evenly",
           judged=False),
    *(
        Output(key=f"{crown} {key}", symbol=symbol, unit=unit, what=f"{what}, {crown}, half-space",
               judged=key == "ends")
        for crown in CROWNS for key, symbol, unit, what in (
            ("mid", "p", "MPa", "pressure at mid-length"),
            ("ends", "F_d", "N", "load within d of both ends"),
        )
    ),
    Output(key="less sharp", symbol="1−λ", unit="1",
           what="exponent of the distance in the edge's pressure; 0.5 in a half-space"),
)  # fmt: skip


END = Case(
    id="contact-roller-end",
    title="End face of a roller",
    paper="huang2018",
    place="Eqs. 2-5, the half-space behind their weights",
    lead="Slices, strips and boundary elements take the roller for a half-space that goes on "
    "beyond its end. Finite elements of whole bodies, a Fourier series around the axes, say what "
    "that costs at a free end face; a control in which both bodies go on tells the face from the "
    "bodies' finite size.",
    inputs=EndInputs,
    analytic=analytic,
    reference=fem,
    levels=(2, 3, 4),
    checks=CHECKS,
    outputs=OUTPUTS,
    readings=(
        "the race goes on beyond the roller, as those of a clutch do",
        "the roller is pressed from two sides by equal races, and each race from two sides",
    ),
    assumptions=(
        "linear elasticity, no friction; solid cylinders with circular sections",
        "pressure acts along the common normal and is even in each cell of the patch",
        "harmonics around the axis are solved up to the width of a cell; those between are "
        "interpolated",
        "the edge's sharpness is that of a ring shrunk on a longer shaft, axisymmetric",
    ),
    warnings=end_figures.warnings,
    equations=end_figures.equations,
    sketch=end_figures.sketch,
    figures=end_figures.figures,
    pictures=end_figures.pictures,
    quick=False,
)

"""One's own roller freewheel: whether it holds, what ends its work, what tolerances do."""

from verify.cases.freewheel.clutch.claims import CHECKS
from verify.cases.freewheel.clutch.fem import fem, star
from verify.cases.freewheel.clutch.figures import equations, figures, sketch
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.cases.freewheel.clutch.limits import under
from verify.cases.freewheel.clutch.messages import findings, warnings
from verify.cases.freewheel.clutch.model import analytic
from verify.cases.freewheel.clutch.summary import summary
from verify.cases.freewheel.reference import LEVELS
from verify.core.case import Case, Output


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = False) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


OUTPUTS = (
    output("alpha_0", "α_0", "deg", "clamping angle without load (Eq. 4)"),
    output("alpha", "α(T)", "deg", "clamping angle under torque (Eq. 5)", judged=True),
    output("N", "F_n", "N", "normal force of one contact (Eqs. 2, 3)", judged=True),
    output("F_t", "F_t", "N", "tangential force of one contact"),
    output("F_a", "F_a", "N", "axial force of one roller"),
    output("p_i", "p_i", "MPa", "peak pressure of the inner contacts (Hertz)"),
    output("p_o", "p_o", "MPa", "peak pressure of the outer contacts (Hertz)"),
    output("d_i", "d_i", "µm", "approach of roller and inner part"),
    output("d_o", "d_o", "µm", "approach of roller and outer part"),
    output("s", "s", "µm", "travel of the rollers along the cam (Eq. 6)"),
    output("phi", "φ", "deg", "wind-up angle by exact rolling (Eq. 7, corrected)", judged=True),
    output("phi printed", "φ_7", "deg", "wind-up angle, Eq. 7 as printed"),
    output("mu_req", "μ_req", "1", "required friction coefficient (Eqs. 8, 9)"),
    output("safety", "μ/μ_req", "1", "available over required friction (Eq. 10)"),
    output("F slip", "F_ax,lim", "N", "axial load at which the contacts slip (Eq. 9)"),
    output("F tilt_lift", "F_ax,lift", "N", "axial load that lifts the rollers off at one end"),
    output("F tilt", "F_ax,tilt", "N", "axial load at which the contact forces move by (e/L)_lim"),
    output("F pressure", "F_ax,p", "N", "axial load at which the rollers' ends reach p_lim"),
    output("e/L", "e/L", "1", "how far the tilting couple moves the contact forces"),
    output("peak", "q/q_m", "1", "peak of the line load at one end over its mean"),
    output("p_end", "p_end", "MPa", "peak pressure there"),
    output("T bears", "T_min", "N m", "torque below which friction does not bear the axial load"),
    output("T slip", "T_μ", "N m", "torque at which the contacts slip"),
    output("T pressure_inner", "T_p,i", "N m", "torque at which the inner contacts reach p_lim"),
    output("T pressure_outer", "T_p,o", "N m", "torque at which the outer contacts reach p_lim"),
    output("T corner", "T_c", "N m", "torque at which the rollers reach the ends of the cam flats"),
    output("T pop_through", "T_pop", "N m", "torque at which the rollers go through"),
    output("dalpha_0/dX", "dα_0/dX", "deg/mm", "sensitivity of α_0 to X"),
    output("dalpha_0/dr", "dα_0/dr", "deg/mm", "sensitivity of α_0 to r"),
    output("dalpha_0/dR", "dα_0/dR", "deg/mm", "sensitivity of α_0 to R"),
    output("dalpha/dX", "dα(T)/dX", "deg/mm", "sensitivity of α under torque to X, over ±5 µm",
           judged=True),
    output("s(alpha_0)", "s(α_0)", "deg", "standard deviation of α_0 by the tolerances"),
    output("P(slip)", "P(slip)", "%", "clutches of like rollers that slip"),
    output("P(no wedge)", "P(gap)", "%", "clutches within tolerance that have no wedge"),
    output("P(no state)", "P(through)", "%", "clutches within tolerance that no state bears: "
           "rollers go through, or contacts are too wide"),
    output("P(corner)", "P(corner)", "%", "clutches within tolerance past the flats' corners"),
    output("share green", "green", "%", "clutches within tolerance that are green by friction"),
    output("share yellow", "yellow", "%", "clutches within tolerance that are yellow by friction"),
    output("share red", "red", "%", "clutches within tolerance that are red by friction"),
    *(
        output(f"{key}, {p} %", f"{symbol},{p}%", unit,
               f"{what} below which {p} % of the clutches that wedge lie")
        for key, symbol, unit, what in (
            ("alpha_0", "α_0", "deg", "clamping angle without load"),
            ("alpha", "α_T", "deg", "clamping angle under torque"),
            ("safety", "μ/μ_req", "1", "available over required friction"),
        )
        for p in (5, 50, 95)
    ),
)  # fmt: skip


def too_large(q: ClutchInputs) -> str:
    if not q.is_star:
        return (
            "finite elements of this case take inner cams only, case freewheel-cup compares outer "
            "cams; check it without --fem"
        )
    if q.T <= 0 or under(q) is None:
        return "finite elements need a torque that locks and that a state bears; check it without "\
            "--fem"  # fmt: skip
    if not q.like:
        return "finite elements take one material for all parts; check unlike ones without --fem"
    try:
        return star(q).refusal()
    except ValueError as error:
        words = str(error).partition("Value error, ")[2].partition(" [type=")[0] or str(error)
        return f"finite elements refuse it: {words}"


CLUTCH = Case(
    id="freewheel-clutch",
    title="Roller freewheel under torque and axial load",
    paper="nagler2021",
    place="Eqs. 1-10, Sec. 7",
    lead="Whether a roller freewheel holds, and which limit is reached first as the torque or the "
    "axial load grows: friction, pressure, the flats' corners, pop-through, tilting rollers. A few "
    "micrometres turn the clamping angle, and with it everything else.",
    inputs=ClutchInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    checks=CHECKS,
    outputs=OUTPUTS,
    readings=(
        "T and F_ax act on the whole clutch: F_a = F_ax/z on a roller, F_t = T/(zR)",
        "R, r are radii and X the distance of a flat from the axis",
        "± are limits within which parts lie: three standard deviations of a normal distribution, "
        "or all of a uniform one; s_μ is a standard deviation of a normal one always",
        "rollers are long: plane strain",
    ),
    assumptions=(
        "the paper prints no dimensions, friction or tolerances of its clutches: these are a "
        "synthetic clutch's, with an axial load and tolerances that are yours to give",
        "classes by μ/μ_req are the paper's observation on its rig (Sec. 7), adopted here; a "
        "clutch whose tan α_0 exceeds μ is red whatever its ratio",
        "all rollers of a clutch are alike and share the load; a torque that falls back, wear, "
        "crowns, centrifugal forces and springs are left out",
        "P(slip) counts such clutches: where r and X differ from roller to roller, clutches whose "
        "first roller slips are half as many again to twice as many (of this synthetic clutch), "
        "those whose rollers together cannot bear the load about as many",
        "each limit is met alone: F_ax stays as T grows, and the reverse; what the couple of the "
        "axial forces does to pressure is a linear line load",
        "a star is clamped in its bore, a shaft and every rim are free; finite elements know inner "
        "cams of one material",
    ),
    findings=findings,
    summary=summary,
    warnings=warnings,
    too_large=too_large,
    equations=equations,
    sketch=sketch,
    figures=figures,
)

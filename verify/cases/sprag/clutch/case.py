"""One's own logarithmic sprag clutch: whether it holds, what ends its work, how hard it engages."""

from collections.abc import Iterable

from verify.cases.sprag.clutch.claims import CHECKS
from verify.cases.sprag.clutch.dynamic import DYNAMIC
from verify.cases.sprag.clutch.fem import LEVELS, fem
from verify.cases.sprag.clutch.figures import equations, figures, sketch
from verify.cases.sprag.clutch.messages import SHORT, findings, summary, warnings
from verify.cases.sprag.clutch.model import built, under
from verify.cases.sprag.clutch.values import analytic
from verify.cases.sprag.inputs import ASSUMED, IDENTIFIED, EngagementInputs
from verify.core.case import Case, Output, Scan
from verify.core.inputs import meta
from verify.core.references import BY_STRIPS

FINEST = 61  # slices that the other side solves anew at each of many loads


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = False) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


OUTPUTS = (
    output("nu_0", "ν_0", "deg", "wedge angle at the inner contact, without load"),
    output("omega_0", "ω_0", "deg", "wedge angle at the outer contact, without load"),
    output("m", "m", "1", "growth of the spiral"),
    output("r_e", "r_e", "mm", "radius of the outer flank"),
    output("OC_e", "OC_e", "mm", "distance of the spiral's pole from the axis"),
    output("N_0", "N_0", "N", "force of the springs alone on each contact"),
    output("N", "N", "N", "inner contact's normal force, of a strut, no springs", judged=True),
    output("nu", "ν(T)", "deg", "wedge angle under torque, inner contact"),
    output("omega", "ω(T)", "deg", "wedge angle under torque, outer contact"),
    output("mu_req", "tan ν", "1", "required friction coefficient", judged=True),
    output("safety", "μ_s/tan ν", "1", "static friction over what torque asks for"),
    output("alpha", "α(T)", "deg", "turn of the sprags against the outer contact", judged=True),
    output("alpha elastic", "α_el", "deg", "the same, of elastic bodies (case sprag-wedge)"),
    output("theta", "θ(T)", "deg", "turn of the races against each other, by rolling", judged=True),
    output("stiffness", "dT/dθ", "N m/rad", "torsional stiffness under torque"),
    output("T/theta", "T/θ", "N m/rad", "torque over turn"),
    output("d_HI", "δ_HI", "µm", "approach of the inner contact, by slices"),
    output("d_HE", "δ_HE", "µm", "approach of the outer contact, by slices"),
    output("d_BI", "δ_BI", "µm", "deflection of the inner race (Eq. 6)"),
    output("d_BE", "δ_BE", "µm", "deflection of the outer race (Eq. 6)"),
    output("d_g", "δ_g", "µm", "compression of the sprag (Eq. 7)"),
    output("H", "H", "µm", "their sum", judged=True),
    output("d_ce", "δ_ce", "µm", "growth of the outer race by its speed (Eq. 8)", judged=True),
    output("p_i mid", "p_i(0)", "MPa", "pressure at mid-length, inner race", judged=True),
    output("p_o mid", "p_o(0)", "MPa", "pressure at mid-length, outer race", judged=True),
    output("p_i", "p_i", "MPa", "largest pressure of the slices, inner race"),
    output("p_o", "p_o", "MPa", "largest pressure of the slices, outer race"),
    output("z_end", "z_end", "µm", "drop of the crown at the middle of its end slices"),
    output("s_id", "σ_θ(R_id)", "MPa", "hoop stress at the inner race's bore, smeared load"),
    output("s_i", "σ_θ(R_i)", "MPa", "hoop stress of the inner race where sprags touch"),
    output("s_e", "σ_θ(R_e)", "MPa", "hoop stress of the outer race where sprags touch"),
    output("T slip", "T_μ", "N m", "torque at which the contacts slip", judged=True),
    output("T pressure_inner", "T_p,i", "N m", "torque at which the inner contacts reach p_lim"),
    output("T pressure_outer", "T_p,o", "N m", "torque at which the outer contacts reach p_lim"),
    output("T yield_inner", "T_R,i", "N m", "torque at which the inner race reaches R_p"),
    output("T yield_outer", "T_R,e", "N m", "torque at which the outer race reaches R_p"),
    output("T end", "T_α", "N m", "torque at which the sprags reach the end of their profile"),
    output("T wide", "T_w", "N m", "torque at which contacts become too wide for the formulas"),
    output("dnu_0/dR_i", "dν_0/dR_i", "deg/mm", "turn of the wedge angle by R_i"),
    output("dnu_0/dR_e", "dν_0/dR_e", "deg/mm", "turn of the wedge angle by R_e"),
    output("dalpha/dR_i", "dα_0/dR_i", "deg/mm", "turn of the unloaded sprags by R_i"),
    output("dalpha/dR_e", "dα_0/dR_e", "deg/mm", "turn of the unloaded sprags by R_e"),
    output("N Liu", "N_L", "N", "normal force with rigid races (Liu)", judged=True),
    output("alpha Liu", "α_L", "deg", "turn of the sprags with rigid races (Liu)", judged=True),
    output(
        "theta Liu", "θ_L", "deg", "turn of the races against each other, rigid (Liu)", judged=True
    ),
    output(
        "alpha printed",
        "α_9,10",
        "deg",
        "turn of the sprags, Eqs. 9 and 10 as printed",
        judged=True,
    ),
)


def named(inputs: Iterable[str]) -> str:
    """Symbols of the inputs."""
    fields = EngagementInputs.model_fields
    return ", ".join(str(meta(fields[name])["symbol"] or name) for name in inputs)


def too_large(q: EngagementInputs) -> str:
    now = under(q)
    if now is None or float(now.turned) > q.alpha_max:
        return "no state within the profile bears this torque; check it without --fem"
    if float(now.N) < SHORT * built(q).N_top:
        return "N is below the least load that slices are solved for; check it without --fem"
    if q.slices > FINEST:
        return f"{q.slices} slices are solved anew at each load, more than {FINEST} are slow; "\
            "check it without --fem"  # fmt: skip
    return ""


CLUTCH = Case(
    id="sprag-clutch",
    title="Sprag clutch under torque and in engagement",
    paper="huang2018",
    place="Eqs. 1-16, Table 1, Sec. 4",
    lead="Whether a logarithmic sprag clutch holds, and which limit is reached first as the torque "
    "grows: friction, pressure, the end of the profile. In time, how high the first peak of an "
    "engagement is. What stands beside the formulas here is the same sprag drawn point by point, "
    "and strips for the slices: they judge geometry, equilibrium and pressures, with the same "
    "deflections; finite elements of the whole clutch are those of sprag-wedge. "
    "The paper's figures depend on "
    f"{len(IDENTIFIED)} inputs that it does not print and that are identified here "
    f"({named(IDENTIFIED)}), and {len(ASSUMED)} that are assumed: what rests on them is "
    "calibrated, not evidence.",
    inputs=EngagementInputs,
    analytic=analytic,
    method=BY_STRIPS, reference=fem,
    levels=LEVELS,
    scans=(
        Scan(vary=("T=12N m,25N m,40N m", "R_ed=23mm,26.23mm,32mm"), star=True),
    ),
    checks=CHECKS,
    outputs=OUTPUTS,
    readings=(
        "r_i of Table 1 is the spiral's radius of curvature at first contact",
        "T acts on the whole clutch, N is the normal force of one sprag",
        "z_m is in millimetres: no unit is printed",
    ),
    assumptions=(
        *(
            f"in the paper's clutch: {named([name])} identified, {why}"
            for name, why in IDENTIFIED.items()
        ),
        "in the paper's clutch: assumed are "
        + "; ".join(f"{named([name])} ({why})" for name, why in ASSUMED.items()),
        "α_max is both where the profile ends and where the springs are slack",
        "all sprags are alike and share the load; races are smeared rings in plane stress, the "
        "sprag is a bar, contacts are slices by Palmgren's law; elastic bodies differ (α_el): "
        "finite elements of the paper's clutch turn it by 5.7° where these deflections say 7.2°",
        "n counts for the growth of the outer race alone: no centrifugal force acts on the sprags, "
        "and none in the races' stresses",
        "stresses of the races are Lamé's under the smeared forces, in plane stress; R_p limits "
        "Tresca's at both bores",
        "a verdict without --dynamic is of a torque that rises slowly",
        "the closure takes the deflections of the whole inner side to the unstrained spiral "
        "(Eqs. 9 and 10, corrected), so that the torque's work is theirs",
        "the pressures of the engagement are those of statics at its largest normal force",
        "without a crown the largest pressure is that of the end slices: it has no limit as they "
        "become more",
    ),
    findings=findings,
    summary=summary,
    warnings=warnings,
    too_large=too_large,
    equations=equations,
    sketch=sketch,
    figures=figures,
    dynamic=DYNAMIC,
)  # fmt: skip

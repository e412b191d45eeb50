"""A roller freewheel on the load paths of the test rig (Nagler, Lohrengel, Sec. 6)."""

import math
from collections.abc import Sequence

from verify.cases.freewheel.paths import figures
from verify.cases.freewheel.paths.claims import CHECKS
from verify.cases.freewheel.paths.fem import LEVELS, fem
from verify.cases.freewheel.paths.formulas import SWAY, analytic, courses, of_limit
from verify.cases.freewheel.paths.inputs import PathInputs
from verify.cases.freewheel.star_sketch import sketch
from verify.core.case import Case, Output, Values

CLOSE = 0.02  # of tan(alpha): friction that near leaves no axial load worth measuring
LIGHTEST = 0.05  # of the largest torque, down to which load case 3 is solved
SWINGS = 0.25  # of the loads, beyond which inertia is no small addition
WORN = 2.0  # mu_req up to which finite elements are asked
SETTLES = 0.6  # of the limit: alternating loads below settled, of the synthetic clutch


def findings(q: PathInputs, v: Values) -> Sequence[str]:
    paths = courses(q)
    slips = [case for case, course in paths.items() if math.isfinite(course.slips_at)]
    named = ", ".join(map(str, slips))
    found = [
        f"slips in load case{'s' * (len(slips) > 1)} {named} of {len(paths)}"
        if slips
        else f"holds to the end of all {len(paths)} load cases"
    ]
    for case, course in paths.items():
        slip, least = course.slips_at, f"{q.mu / course.peak:.3g}, {course.light}"
        found.append(
            f"{figures.NAMES[case]}: "
            + (
                f"slips at {slip:.4g} s; loaded on to the path's end as if it held, least "
                f"μ/μ_req {least}"
                if math.isfinite(slip)
                else f"holds to the end, least μ/μ_req {least}"
            )
        )
    if "F_lim" in v:
        found.append(
            f"under T = {q.T:g} N m it bears F_ax = {v['F_lim']:.4g} N; alternating loads beyond "
            f"some {SETTLES:g} of that may make the ring walk before it slips (with --fem)"
        )
    return found


def warnings(q: PathInputs, v: Values) -> Sequence[str]:
    found = []
    if "F_lim" not in v:
        found.append(
            f"tan α = {v['mu_t']:.4g} is not below μ = {q.mu:g} (Eq. 1): the torque alone lets the "
            "rollers out, no axial load needed"
        )
    if 0 < q.T_m <= q.T:
        found.append(
            "load case 3: the torque comes to zero under axial load, where no friction holds"
        )
    if v["sway"] > SWAY:
        more = f"adds some {v['sway']:.1%} to the loads" if v["sway"] < SWINGS else "rules"
        found.append(
            f"f = {q.f:g} Hz is {math.sqrt(v['sway']):.2g} of the ring's f_0 = {v['f_0']:.4g} Hz: "
            f"inertia {more}, the paths are taken as slow"
        )
    return found


def too_large(q: PathInputs) -> str:
    if reason := q.model_copy(update={"T": q.T_peak}).refusal():
        return reason
    v = analytic(q)
    if v["mu_t"] * (1 + CLOSE) > q.mu or of_limit(q, q.T) is None:
        return (
            f"tan α = {v['mu_t']:.4g} is not below μ = {q.mu:g} by {CLOSE:.0%} or more: the torque "
            "alone lets the rollers out, or nearly so; check it without --fem"
        )
    if q.T_critical < LIGHTEST * q.T_peak:
        return (
            f"T_m = {q.T_m:g} N m: load case 3 has an axial load while its torque is next to "
            "zero, where nothing holds; T_m = 0 or well above T, or check it without --fem"
        )
    if of_limit(q, q.T_critical) is None:
        return "the trough of load case 3 slips without axial load; check it without --fem"
    if v["mu_req at 1"] > WORN:
        return (
            f"F_ax = {q.F_ax:g} N asks for friction of {v['mu_req at 1']:.3g} beyond {WORN:g}; "
            "check it without --fem"
        )
    return ""


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = False) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


PATHS = Case(
    id="freewheel-paths",
    title="Load paths of the test rig",
    paper="nagler2021",
    place="Secs. 6 and 7, Eqs. 8-10",
    lead="The rig loads the clutch along three paths: a growing axial load under torque, an "
    "alternating one, and both alternating. The criterion says along each what friction is asked "
    "for and when the clutch slips; finite elements follow the paths with the history of their "
    "friction, slip at the same load by any way, and show that the ring walks before.",
    inputs=PathInputs,
    analytic=analytic,
    reference=fem,
    levels=LEVELS,
    checks=CHECKS,
    outputs=(
        output("F_lim", "F_ax,lim", "N", "axial load at slip, load cases 1 and 2 (Eq. 9)",
               judged=True),
        output("F_lim 3", "F_ax,lim", "N", "axial amplitude at slip, load case 3", judged=True),
        *(output(f"{key} {case}", symbol, unit, f"{what}, load case {case}")
          for case in (1, 2, 3)
          for key, symbol, unit, what in (
              ("peak", "μ_req", "1", "largest required friction"),
              ("when", "t", "s", "and when"),
              ("safety", "μ/μ_req", "1", "least ratio"),
              ("slip", "t_slip", "s", "first time of slip"))),
        output("mu_t", "tan α", "1", "required friction under T without axial load"),
        output("N", "F_n", "N", "normal force under T"),
        output("phi", "φ", "deg", "torsion under the largest torque"),
        output("f_0", "f_0", "Hz", "eigenfrequency of the ring by itself on the wedged rollers"),
        output("sway", "(f/f_0)²", "1", "what inertia adds to the loads, about"),
    ),
    readings=(
        "load case 2: the axial load alternates about zero, load case 3: torque and axial load "
        "are in phase; Fig. 7 is not in the text",
        "T is the steady torque of load cases 1 and 2 and the amplitude of load case 3; F_ax the "
        "amplitude at the path's end, of the whole clutch",
        "amplitudes grow in proportion to time",
        "a clutch with T < 0 overruns: the criterion asks for nothing there",
        "the classes 0.8 and 1.0 are a rule of the paper's own runs, adopted",
    ),
    assumptions=(
        "a row of rests: at 30 Hz inertia of the ring adds (f/f_0)², 0.03 % of the loads; it takes "
        "thirty times the ring's own inertia to add 1 %. Rollers and oil are left out, too",
        "times of rise and path, μ and all dimensions are yours: the settings of Table 1 are not "
        "in the text; the clutch is synthetic",
        "finite elements, load cases 1 and 2: every extreme is a step with the friction of the "
        "one before; the drive keeps the torque and turns the ring on as rollers creep. Fewer and "
        "smaller cycles than the path has: slip does not depend on them",
        "load case 3: between no torque and 26 N m rollers roll on by more than their contacts "
        "are wide; each torque has its own place, where both loads come on together",
        "expected errors: tan α of one contact by a star between a layer and a disc, and tilting "
        "surfaces; the limit multiplies them by 1/(1 − (tan α/μ)²)",
    ),
    findings=findings,
    warnings=warnings,
    too_large=too_large,
    equations=figures.equations,
    tables=figures.tables,
    sketch=sketch,
    figures=figures.figures,
    pictures=figures.pictures,
)  # fmt: skip

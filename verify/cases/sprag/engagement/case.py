"""Engagement of a sprag clutch in time (Huang, Zhao, Liu 2018, Eqs. 11-16)."""

from collections.abc import Sequence

from verify.cases.sprag.engagement import figures
from verify.cases.sprag.engagement.claims import CHECKS
from verify.cases.sprag.engagement.fem import LEVELS, fem
from verify.cases.sprag.engagement.formulas import analytic
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import Case, Output, Scan, Values
from verify.core.references import BY_INTEGRATION

MOST_STEPS = 200_000  # of a level, which finite memory and LSODA bear
SURE = 1.05  # of the friction asked for


def too_large(q: EngagementInputs) -> str:
    if LEVELS[-1] * q.t_end / q.dt > MOST_STEPS:
        return f"t_end/dt = {q.t_end / q.dt:.4g} is above {MOST_STEPS // LEVELS[-1]} steps"
    v = analytic(q)
    if "N_undamped" not in v or v["over"]:
        return "the sprags roll over: nothing is left to compare; check it without --fem"
    if "N_max more" not in v or v["over more"]:
        return "under 1.6 T, to which it is compared, the sprags roll over; check it without --fem"
    if q.mu_s < v["start"]:
        return (
            f"the sprags slide at the start, where rolling asks for μ = {v['start']:.3g}: the "
            "formulas are those of rolling; see sprag-friction"
        )
    if q.mu_s < SURE * v["mu_asked"]:
        return (
            f"mu_s = {q.mu_s:g} is not above tan ν = {v['mu_asked']:.4g} by {SURE - 1:.0%}: the "
            "sprags slip, or nearly so; see sprag-friction"
        )
    return ""


def warnings(q: EngagementInputs, v: Values) -> Sequence[str]:
    found = []
    if "N_undamped" not in v or v["over"]:
        found.append(
            f"the profile ends at α_max = {q.alpha_max:.4g} rad before the torque's swing does"
        )
    if v["start"] > q.mu_s > v["mu_asked"]:
        found.append(
            f"the springs press so little that the sprags slide at the start (μ = {v['start']:.3g} "
            f"is asked for{', above μ_c' if q.mu_c < v['mu_asked'] else ''}): the "
            "forces here are those of rolling; see sprag-friction"
        )
    if q.mu_s < v["mu_asked"]:
        found.append(
            f"friction μ_s = {q.mu_s:g} is below tan ν = {v['mu_asked']:.4g}: the sprags slip, "
            "the forces here are those of rolling"
        )
    return found


def findings(q: EngagementInputs, v: Values) -> Sequence[str]:
    if "N_undamped" not in v or v["over"]:
        return ("rolls over: the sprags turn past their profile",)
    if q.mu_s < v["mu_asked"]:
        return ("slips: friction is less than the wedge asks for",)
    return (
        f"locks: N swings to {v['N_max']:.4g} N, {v['factor']:.3g} times that at rest, after "
        f"{v['t_max'] * 1e3:.3g} ms",
        f"without the races' yielding (Liu) {v['rigid'] - 1:+.1%}",
    )


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = True) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


ENGAGEMENT = Case(
    id="sprag-engagement",
    title="Engagement of a sprag clutch in time",
    paper="huang2018",
    place="Eqs. 11-16, Sec. 2.4",
    lead="A torque that comes at once swings the races against the sprags: the paper's equations "
    "of motion, in its Runge-Kutta steps, compiled, are refined in time and stand beside LSODA "
    "with events, which shares the closure alone, and beside energy, statics and two races on "
    "a spring.",
    inputs=EngagementInputs,
    analytic=analytic,
    method=BY_INTEGRATION, reference=fem,
    levels=LEVELS,
    scans=(
        Scan(vary=("T=15N m,25N m,40N m", "k_out=30000N m/rad,100000N m/rad"), star=True),
    ),
    checks=CHECKS,
    outputs=(
        output("N_max", "N_max", "N", "largest normal force: two races on the clutch as a spring"),
        output("t_max", "t_max", "ms", "its time", judged=False),
        output("factor", "N_max/N", "1", "over N, that at rest with springs", judged=False),
        output("N", "N", "N", "normal force at rest, of a strut with springs"),
        output("N_undamped", "N_1", "N", "first peak without damping, outer race held"),
        output("N_max rigid", "N_max", "N", "with races that do not yield (Liu)", judged=False),
        output("ratio", "r", "1", "N_max under 1.6 T over that under T"),
        output("mu_asked", "tan ν", "1", "friction that rolling asks for"),
        output("f", "f", "Hz", "small oscillations, outer race held"),
        output("k", "k", "N m/rad", "stiffness of the clutch at rest", judged=False),
        output("theta", "θ", "deg", "turn of the races against each other at rest", judged=False),
        output("alpha", "α", "deg", "rotation of the sprags at rest", judged=False),
    ),
    readings=(
        "driving is positive and locks at α > 0: the mirror image of Eq. 11, with the sign of the "
        "springs that closes (ledger: eq-11-14-spring-sign)",
        "forces of the races act at OA and OB of Eq. 9, not at half of them (eq-16-lever-arms)",
        "C_be is the moment of the support, −k_out θ_e (eq-16-outer-spring)",
        "N_be = N_bi in Eqs. 14 and 16; a strut in balance has N_e = N_i cos ω/cos ν",
        "the torque comes as a step on a clutch at rest under its springs",
    ),
    assumptions=(
        "length, width, wedge angle, support and the crown's load are identified, not printed; "
        "friction, α_max and the centroid's place are assumed",
        "N follows from the rotation as at rest, by the closure that balances work: what the paper "
        "iterates is explicit in N here",
        "all sprags are alike; races turn, but neither bend nor move; no oil",
        "the centroid keeps the distance OC_g(α): its radial motion is left out, as in Eq. 14",
        "a contact sticks within a band of speeds; the band follows from the time step",
    ),
    equations=figures.equations,
    sketch=figures.sketch,
    figures=figures.figures,
    findings=findings,
    warnings=warnings,
    too_large=too_large,
)  # fmt: skip

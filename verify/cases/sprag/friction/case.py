"""Friction of a sprag clutch: stick, slip, and the band in which steps can tell them apart."""

from collections.abc import Sequence

from verify.cases.sprag.friction import figures
from verify.cases.sprag.friction.claims import CHECKS
from verify.cases.sprag.friction.fem import LEVELS, fem, settled
from verify.cases.sprag.friction.formulas import analytic
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import Case, Output, Values
from verify.core.references import BY_INTEGRATION

MOST_STEPS = 50_000  # of a level: several hundred engagements are run
SURE = 1.1  # of the friction asked for


def too_large(q: EngagementInputs) -> str:
    v = analytic(q)
    if "N_max more" not in v or "mu_b" not in v or v["over"]:
        return "the sprags roll over: nothing is left to compare; check it without --fem"
    if LEVELS[-1] * settled(q) / q.dt > MOST_STEPS:
        return (
            f"{settled(q):.4g} s, t_end or five periods, take {settled(q) / q.dt:.4g} steps of dt, "
            f"above {MOST_STEPS // LEVELS[-1]}; check it without --fem"
        )
    if q.mu_c < SURE * v["asked"]:
        return (
            f"mu_c = {q.mu_c:g} is not above tan ν = {v['asked']:.4g} by {SURE - 1:.0%}: sprags "
            "that slip at the start slip for ever; check it without --fem"
        )
    return ""


def warnings(q: EngagementInputs, v: Values) -> Sequence[str]:
    if "mu_b" not in v:
        return ("the sprags roll over before they bear the torque",)
    if q.mu_c < v["mu_b"] <= q.mu_s:
        return (
            f"μ_c = {q.mu_c:g} is below {v['mu_b']:.4g}, what the wedge asks for, μ_s = "
            f"{q.mu_s:g} above: it locks only where it does not slip first",
        )
    return ()


def findings(q: EngagementInputs, v: Values) -> Sequence[str]:
    if "mu_b" not in v:
        return ("rolls over: the sprags turn past their profile",)
    drag = (
        f"overrunning, the races drag each other with {v['drag']:.3g} N m",
    ) if "drag" in v else ()  # fmt: skip
    if q.mu_s < v["mu_b"]:
        return ("slips for ever: friction is less than the wedge asks for", *drag)
    first = f"locks: μ_s is {v['mu_s/mu_b']:.3g} times what the wedge asks for"
    return (first if q.mu_c >= v["mu_b"] else f"{first}, but μ_c less than that", *drag)


def output(key: str, symbol: str, unit: str, what: str, *, judged: bool = True) -> Output:
    return Output(key=key, symbol=symbol, unit=unit, what=what, judged=judged)


FRICTION = Case(
    id="sprag-friction",
    title="Stick and slip of a sprag clutch",
    paper="huang2018",
    place="Eqs. 12-16",
    lead="Sprags lock where friction exceeds the wedge's tangent and slide where it does not: in "
    "the paper's steps, in closed form and by LSODA with events. A step that passes the whole "
    "band of sticking gives wrong forces and no sign of it; a guard refuses it.",
    inputs=EngagementInputs,
    analytic=analytic,
    method=BY_INTEGRATION, reference=fem,
    levels=LEVELS,
    checks=CHECKS,
    outputs=(
        output("mu_b", "μ_b", "1", "friction from which on it locks, asked for at rest under T"),
        output("tan", "tan ν", "1", "wedge angle there", judged=False),
        output("mu_s/mu_b", "μ_s/μ_b", "1", "static friction over that", judged=False),
        output("mu_c/mu_b", "μ_c/μ_b", "1", "friction of fast sliding over that", judged=False),
        output("N slides", "N", "N", "force of sprags that slide for ever, μ = 0.9 tan ν_0"),
        output("T slides", "T", "N m", "torque of the clutch then", judged=False),
        output("N overruns", "N", "N", "normal force where the race overruns, with μ_s"),
        output("drag", "T_o", "N m", "torque with which it drags then", judged=False),
    ),
    readings=(
        "T_bis = μ_s N: only so the branches of Eq. 12 join (ledger: eq-12-static-limit)",
        "T_stick keeps both contacts rolling and lets what sliding is left die away; printed is "
        "that it keeps pure rolling",
        "ν is that at rest under T; the wedge asks for T_i/N, less than tan ν by what the springs "
        "bear",
    ),
    assumptions=(
        "μ_s, μ_c, γ_b and D_V are assumed: the paper prints none",
        "length, width, wedge angle and support are identified, not printed",
        "weak springs have a 25th of K_r: with the printed one no sprag slips at the start",
        "no oil, no centrifugal force on the sprags; contacts keep their places",
    ),
    equations=figures.equations,
    sketch=figures.sketch,
    figures=figures.figures,
    findings=findings,
    warnings=warnings,
    too_large=too_large,
)  # fmt: skip

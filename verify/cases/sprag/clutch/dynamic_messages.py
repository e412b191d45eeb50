"""Statements on an engagement, and one verdict on statics and engagement together."""

import math
from collections.abc import Sequence

from analytic.sprag.steps import enough
from verify.cases.freewheel.clutch.numbers import newton, pascal
from verify.cases.sprag.clutch.formulas import ClutchFormulas
from verify.cases.sprag.clutch.recommendations import verdict, why
from verify.cases.sprag.clutch.run_fem import Run, run_fem
from verify.core.case import Values

WORSE = ("holds", "not followed", "overloaded", "disengages", "slips", "rolls over", "no state")
AT_REST = {
    "holds": "holds at rest",
    "overloaded": "is overloaded at rest",
    "slips": "slips at rest",
    "rolls over": "rolls over at rest",
    "no state": "the formulas give no equilibrium at rest",
}
IN_TIME = {
    "holds": "holds at the first force peak",
    "not followed": "the computed time ends before the peak of the engagement",
    "overloaded": "is overloaded at the first force peak",
    "disengages": "its contacts are separated at the end",
    "slips": "slips permanently in the engagement",
    "rolls over": "rolls over at the first force peak",
    "no state": "the first force peak is beyond the range of the formulas",
}
WORDS = {
    "locks": "the clutch locks",
    "slips": "a contact continues to slide: the clutch does not lock",
    "over the end": "the sprags roll over",
    "disengages": "the contacts are separated at the end",
    "not followed": "the computed time ends before the peak",
}
WELL = 1e-3  # relative to the work: larger energy errors are reported
SPARE = 1.2  # over half a period: stiffness grows with the load
DECAYS = 5.0  # time constants of a force that creeps


def overall(q: ClutchFormulas, v: Values) -> tuple[str, tuple[str, ...]]:
    """The worse of two verdicts (at rest, on the engagement), and two sentences.

    The first sentence states both verdicts, the second the reason of the verdict at rest.
    """
    still, moving = verdict(q), in_time(q, v)
    worst = max(still, moving, key=WORSE.index)
    if still == moving and still in ("holds", "overloaded", "rolls over"):
        head = f"{AT_REST[still]} and at the first force peak"
    else:
        head = f"{AT_REST[still]}, {IN_TIME[moving]}"
    if moving == "rolls over" and still in ("holds", "overloaded"):
        head += "; longer, more or wider sprags, thicker races, or a slower rise of the torque " \
            "can avoid this"  # fmt: skip
    return worst, (head, f"at rest: {still}: {why(q)}")


def in_time(q: ClutchFormulas, v: Values) -> str:
    """Verdict on the engagement, expressed by the words used for the verdict at rest."""
    run = run_fem(q)
    found = run.engagement.verdict
    if found == "over the end":
        return "rolls over" if run.end_of_profile else "no state"
    if found != "locks":
        return found
    return "overloaded" if max(v["p_i_max"], v["p_o_max"]) > (q.p_lim or math.inf) else "holds"


def unfollowed(q: ClutchFormulas) -> str:
    """Message that t_end is too short, with the required value if known."""
    if not q.state:
        return f"t_e = {q.t_end * 1e3:.3g} ms is too short"
    return f"t_e = {q.t_end * 1e3:.3g} ms is too short; increase t_end to at least " \
        f"{least_time(q) * 1e3:.4g} ms"  # fmt: skip


def least_time(q: ClutchFormulas) -> float:
    """Upper bound [s] of the time of the first peak, rounded up to two digits.

    It is the sum of the rise time of the torque, the deceleration of an overrunning race, half a
    period of the inner race on clutch and support in series, and the delay by damping.
    """
    k = 1 / (1 / q.T_per_theta + 1 / q.k_out)
    back = q.I_bi * max(0.0, -q.w_i) / q.T
    t = q.t_ramp + back + SPARE * math.pi * math.sqrt(q.I_bi / k) + DECAYS * q.C_rl / k
    unit = 10.0 ** (math.floor(math.log10(t)) - 1)
    return math.ceil(t / unit) * unit


def outcome(found: Run) -> str:
    """Sentence on the verdict of an engagement, or on contacts too wide for the formulas."""
    e = found.engagement
    if e.over and not found.end_of_profile:
        return "the contacts become too wide for the formulas"
    return WORDS[e.verdict]


def findings(q: ClutchFormulas, v: Values) -> Sequence[str]:
    found = run_fem(q)
    e = found.engagement
    lines = peaks(q, v, found) if e.followed else [
        f"in time: {outcome(found)}: {unfollowed(q)}; "
        + ("the inner race still overruns" if e.overruns else
           f"the normal force still rises and is {newton(v['N_max'])} at {e.t[-1] * 1e3:.3g} ms")
    ]  # fmt: skip
    if v["t_slip"] > 0:
        lines.append(
            f"contacts slide for {v['t_slip'] * 1e3:.3g} ms: the inner contacts slide by "
            f"{distance(v['slid_i'])}, the outer contacts by {distance(v['slid_o'])}; the work of "
            f"friction is {v['friction']:.3g} J"
        )
    if v["missing"] > WELL:
        lines.append(
            f"inaccurate: the energy balance has an error of {v['missing']:.2%}, because Δt = "
            f"{q.dt:g} s is too long; use dt = {enough(e.table, e.motion, q.dt):g} s"
        )
    return lines


def peaks(q: ClutchFormulas, v: Values, found: Run) -> list[str]:
    """Sentences on the outcome, the largest force and the pressures of an engagement."""
    e = found.engagement
    factor = f", {v['peak_factor']:.3g} times that at rest" if "peak_factor" in v else ""
    when, reaches = (f" at {e.t[-1] * 1e3:.3g} ms", "has reached") if e.over else ("", "reaches")
    lines = [
        f"in time: {outcome(found)}{when}; the normal force {reaches} {newton(v['N_max'])} at "
        f"{v['t_max'] * 1e3:.3g} ms{factor}",
        f"under this force the largest pressure of the inner contacts is {pascal(v['p_i_max'])}, "
        f"that of the outer contacts {pascal(v['p_o_max'])}",
    ]
    if q.p_lim is not None and max(v["p_i_max"], v["p_o_max"]) > q.p_lim:
        lines.append(f"the largest pressure exceeds p_lim = {pascal(q.p_lim)}")
    return lines


def distance(s: float) -> str:
    """Distance `s` [m] as text with a suitable unit."""
    return f"{s * 1e6:.3g} µm" if s < 1e-3 else f"{s * 1e3:.3g} mm" if s < 1 else f"{s:.3g} m"

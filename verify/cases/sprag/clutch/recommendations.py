"""Why a sprag clutch holds or does not, and what would change it."""

import math
from collections.abc import Callable

from verify.cases.freewheel.clutch.numbers import newton_metres, pascal
from verify.cases.sprag.clutch.limits import WORDS, verdict
from verify.cases.sprag.inputs import SpragInputs
from verify.core.case import Values

DEGREE = math.degrees(1.0)


def why(q: SpragInputs, v: Values) -> str:
    """What the verdict rests on, and what would change it."""
    state = verdict(q, v)
    if v["mu_0"] > q.mu_s:
        return f"tan ν_0 = {v['mu_0']:.4g} exceeds μ_s = {q.mu_s:g}: the sprags do not wedge, " \
            f"any torque slides them; {wedging(q, v)}"  # fmt: skip
    if state == "slips":
        return f"tan ν = {v['mu_req']:.4g} under torque exceeds μ_s = {q.mu_s:g}; {wedging(q, v)}"
    if state == "rolls over":
        return (
            f"the sprags reach the end of their profile, α_max = {q.alpha_max * DEGREE:.4g}°, "
            f"at {newton_metres(v['T end'])}, before T = {newton_metres(q.T)}; {profile(v)}"
        )
    if state == "no state":
        last = v.get("T wide", math.nan)
        at = f" at {newton_metres(last)}" if math.isfinite(last) else ""
        return f"no state bears T = {newton_metres(q.T)}: {WORDS['wide']}{at}; take more or " \
            "longer sprags"  # fmt: skip
    friction = f"torque asks for tan ν = {v['mu_req']:.4g} of friction, μ_s is {q.mu_s:g} " \
        f"(μ_s/tan ν = {v['safety']:.3g})"  # fmt: skip
    if state == "overloaded":
        return f"friction holds, but {overload(q, v)}; {friction}"
    return friction


def wedging(q: SpragInputs, v: Values) -> str:
    """Wedge angle and friction with which the clutch would hold."""
    asked = v.get("mu_req", v["mu_0"])
    grows = max(1.0, asked / v["mu_0"]) ** 2  # a smaller angle bears more force, which opens it
    nu = math.atan(q.mu_s / grows) * DEGREE
    return f"take ν_0 below {rounded(nu, math.floor):g}° or μ_s above " \
        f"{rounded(max(asked, v['mu_0']), math.ceil):g}"  # fmt: skip


def profile(v: Values) -> str:
    """What keeps the sprags on their profile."""
    parts = "thicker races, more or longer sprags"
    if "turned" not in v:
        return f"take {parts}"
    least = rounded(v["turned"] * DEGREE, math.ceil)
    return f"take a profile with α_max of at least {least:g}°, or {parts}"


def overload(q: SpragInputs, v: Values) -> str:
    """What is borne beyond its limit, and what would lower it."""
    p, race = max((v["p_i"], "inner"), (v["p_o"], "outer"))
    if q.p_lim is not None and p > q.p_lim:
        times = rounded((p / q.p_lim) ** 2, math.ceil)
        return f"the {race} contacts bear {pascal(p)}, p_lim is {pascal(q.p_lim)}: take about " \
            f"{times:g} times as many sprags, or as long ones"  # fmt: skip
    s, race = max((v["Tresca_i"], "inner"), (v["Tresca_e"], "outer"))
    return f"the {race} race bears {pascal(s)} at its bore (Tresca), R_p is " \
        f"{pascal(q.R_p or 0)}: take thicker races or longer sprags"  # fmt: skip


def rounded(x: float, to: Callable[[float], int], digits: int = 3) -> float:
    """`x` to so many digits, up or down."""
    unit = 10.0 ** (math.floor(math.log10(x)) + 1 - digits)
    return to(x / unit) * unit

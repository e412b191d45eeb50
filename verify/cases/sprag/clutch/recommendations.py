"""Reasons why a sprag clutch holds or slips, and recommended changes."""

import math
from collections.abc import Callable

from verify.cases.freewheel.clutch.numbers import newton_metres, pascal
from verify.cases.sprag.clutch.formulas import ClutchFormulas
from verify.cases.sprag.clutch.limits import WORDS

DEGREE = math.degrees(1.0)


def verdict(q: ClutchFormulas) -> str:
    """Verdict: "holds", "slips", "rolls over", "overloaded", or "no state" without a solution."""
    if max(q.mu_0, q.mu_req if q.state else 0.0) > q.mu_s:
        return "slips"
    if q.T_end < q.T:
        return "rolls over"
    if not q.state:
        return "no state"
    pressed = q.p_lim is not None and max(q.p_i, q.p_o) > q.p_lim
    yields = q.R_p is not None and max(q.tresca) > q.R_p
    return "overloaded" if pressed or yields else "holds"


def why(q: ClutchFormulas) -> str:
    """Sentence with the reason of the verdict and recommended changes."""
    state = verdict(q)
    if q.mu_0 > q.mu_s:
        return f"tan ν_0 = {q.mu_0:.4g} exceeds μ_s = {q.mu_s:g}: the sprags do not wedge and " \
            f"slip at any torque; {wedging(q)}"  # fmt: skip
    if state == "slips":
        return f"tan ν = {q.mu_req:.4g} under torque exceeds μ_s = {q.mu_s:g}; {wedging(q)}"
    if state == "rolls over":
        return (
            f"the sprags reach the end of their profile, α_max = {q.alpha_max * DEGREE:.4g}°, "
            f"at {newton_metres(q.T_end)}, below T = {newton_metres(q.T)}; {profile(q)}"
        )
    if state == "no state":
        last = q.T_wide
        at = f" at {newton_metres(last)}" if math.isfinite(last) else ""
        return f"no equilibrium exists at T = {newton_metres(q.T)}: {WORDS['wide']}{at}; use " \
            "more or longer sprags"  # fmt: skip
    friction = f"required friction coefficient tan ν = {q.mu_req:.4g}, available μ_s = " \
        f"{q.mu_s:g} (margin μ_s/tan ν = {q.safety:.3g})"  # fmt: skip
    if state == "overloaded":
        return f"friction is sufficient, but {overload(q)}; {friction}"
    return friction


def wedging(q: ClutchFormulas) -> str:
    """Recommendation: a wedge angle, or a friction coefficient, with which the clutch holds."""
    asked = q.mu_req if q.state else q.mu_0
    grows = max(1.0, asked / q.mu_0) ** 2  # a smaller angle gives a larger force, which opens it
    nu = math.atan(q.mu_s / grows) * DEGREE
    return f"choose ν_0 below {rounded(nu, math.floor):g}° or μ_s above " \
        f"{rounded(max(asked, q.mu_0), math.ceil):g}"  # fmt: skip


def profile(q: ClutchFormulas) -> str:
    """Recommended changes against rollover of the sprags."""
    parts = "thicker races, more or longer sprags"
    if not q.state:
        return f"use {parts}"
    least = rounded(q.turned * DEGREE, math.ceil)
    return f"use a profile with α_max of at least {least:g}°, or {parts}"


def overload(q: ClutchFormulas) -> str:
    """Pressure or stress that exceeds its limit, and recommended changes."""
    p, race = max((q.p_i, "inner"), (q.p_o, "outer"))
    if q.p_lim is not None and p > q.p_lim:
        times = rounded((p / q.p_lim) ** 2, math.ceil)
        return f"the {race} contacts have {pascal(p)}, p_lim is {pascal(q.p_lim)}: use about " \
            f"{times:g} times as many sprags, or sprags as many times longer"  # fmt: skip
    s, race = max(zip(q.tresca, ("inner", "outer"), strict=True))
    return f"the {race} race has {pascal(s)} at its bore (Tresca), R_p is " \
        f"{pascal(q.R_p or 0)}: use thicker races or longer sprags"  # fmt: skip


def rounded(x: float, to: Callable[[float], int], digits: int = 3) -> float:
    """The value `x` rounded to `digits` digits, up (ceil) or down (floor)."""
    unit = 10.0 ** (math.floor(math.log10(x)) + 1 - digits)
    return to(x / unit) * unit

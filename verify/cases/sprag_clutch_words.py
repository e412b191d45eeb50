"""What is told of a sprag clutch first: whether it holds, what ends its work, its radii."""

import math
from collections.abc import Sequence
from typing import Any

from verify.case import Values
from verify.cases.freewheel_clutch_numbers import newton, newton_metres, pascal
from verify.cases.sprag_clutch_limits import WORDS, Limit, as_torque_grows, verdict
from verify.cases.sprag_clutch_model import built
from verify.cases.sprag_inputs import SpragInputs

DEGREE = math.degrees(1.0)
UM = 1e-6
STEEL = (195e9, 220e9)  # Pa, of which Palmgren's law is
SHORT = 1e-4  # of the law's last load: below it slices are not solved
HARD = 0.1  # of N, by which springs press
LOOSE = 0.25  # rad, beyond which a sprag has turned a lot


def findings(q: SpragInputs, v: Values) -> Sequence[str]:
    found = [f"{verdict(q, v)}: {why(q, v)}"]
    found += first_limits(q)
    if "N" in v:
        found += [stiff(v), crowned(v), beside(v)]
        if verdict(q, v) in ("slips", "rolls over"):
            found.append("forces, turns and pressures below are those it would have if it held")
    return [*found, sensitive(v)]


def why(q: SpragInputs, v: Values) -> str:
    """What the verdict rests on."""
    state = verdict(q, v)
    if v["mu_0"] > q.mu_s:
        return f"tan ν_0 = {v['mu_0']:.4g} exceeds μ_s = {q.mu_s:g}: the sprags do not wedge, " \
            "any torque slides them"  # fmt: skip
    if state == "slips":
        return f"tan ν = {v['mu_req']:.4g} under torque exceeds μ_s = {q.mu_s:g}"
    if state == "rolls over":
        return f"the sprags reach the end of their profile, α_max = {q.alpha_max * DEGREE:.4g}°, " \
            f"at {newton_metres(v['T end'])}, before T = {newton_metres(q.T)}"  # fmt: skip
    if state == "no state":
        last = v.get("T wide", math.nan)
        at = f" at {newton_metres(last)}" if math.isfinite(last) else ""
        return f"no state bears T = {newton_metres(q.T)}: {WORDS['wide']}{at}"
    friction = f"torque asks for tan ν = {v['mu_req']:.4g} of friction, μ_s is {q.mu_s:g} " \
        f"(μ_s/tan ν = {v['safety']:.3g})"  # fmt: skip
    if state == "overloaded":
        p, race = max((v["p_i"], "inner"), (v["p_o"], "outer"))
        return f"friction holds, but the {race} contacts bear {pascal(p)}, p_lim is " \
            f"{pascal(q.p_lim or 0)}; {friction}"  # fmt: skip
    return friction


def first_limits(q: SpragInputs) -> list[str]:
    """What comes first as the torque grows, and what after it."""
    ahead = [x for x in as_torque_grows(q) if x.at > q.T and x.key != "wide"]
    if not ahead:
        return []
    told = "; then ".join(f"{x.words} at {newton_metres(x.at)}" for x in ahead[:3])
    return [f"as the torque grows, {told}"]


def stiff(v: Values) -> str:
    return (
        f"each sprag bears {newton(v['N'])} and has turned by {v['alpha'] * DEGREE:.3g}°; the "
        f"races have turned by {v['theta'] * DEGREE:.3g}° against each other, "
        f"{v['stiffness']:.4g} N m/rad at this torque"
    )


def crowned(v: Values) -> str:
    """Pressures of both races, the crown's peak over the middle's."""
    told = [
        f"{pascal(v[f'p_{k}'])} at the {race} race ({v[f'p_{k}'] / v[f'p_{k} mid']:.3g} times "
        "that at mid-length)"
        for k, race in (("i", "inner"), ("o", "outer"))
    ]
    return f"the contacts' slices bear up to {' and '.join(told)}"


def beside(v: Values) -> str:
    """What two other models say at the same torque."""
    return (
        f"with rigid races (Liu) the sprags would turn by {v['alpha Liu'] * DEGREE:.3g}°, by Eqs. "
        f"9 and 10 as printed by {v['alpha printed'] * DEGREE:.3g}°"
    )


def sensitive(v: Values) -> str:
    turn, tilt = v["dalpha/dR_i"] * 10 * UM * DEGREE, v["dnu_0/dR_i"] * 10 * UM * DEGREE
    return (
        f"10 µm of R_i or R_e turn the unloaded sprags by {abs(turn):.3g}°; the spiral keeps "
        f"their wedge angle to {abs(tilt):.2g}°"
    )


def warnings(q: SpragInputs, v: Values) -> Sequence[str]:
    found = []
    if not STEEL[0] <= q.E <= STEEL[1]:
        found.append(
            f"slices follow Palmgren's law, which is steel's whatever E = {q.E / 1e9:.4g} GPa says"
        )
    if "N" in v and v["N"] < SHORT * built(q).N_top:
        found.append(f"N = {newton(v['N'])} is below the least load for which slices were solved")
    if v.get("alpha", 0.0) > LOOSE:
        found.append(
            f"the sprags turn by {v['alpha'] * DEGREE:.3g}° under T: a part of their profile that "
            "few sprags have"
        )
    if v.get("N_0", math.inf) > HARD * v.get("N", math.inf):
        found.append(
            f"the springs alone press with {newton(v['N_0'])}, more than a tenth of what the "
            "torque asks for"
            if "N_0" in v
            else "the springs turn the sprags to their end"
        )
    if q.l < q.b:
        found.append("sprags are shorter than wide: line contacts they hardly have")
    return found


def summary(q: SpragInputs, v: Values) -> dict[str, Any]:
    """JSON; `margin` is mu_s/tan(nu), None without a state; limits of T [N m]."""
    return {
        "verdict": verdict(q, v), "margin": v.get("safety"),
        "limits": [_limit(q, x) for x in as_torque_grows(q)],
    }  # fmt: skip


def _limit(q: SpragInputs, limit: Limit) -> dict[str, Any]:
    return {"of": "T", "key": limit.key, "what": limit.words, "at": limit.at, "unit": "N m",
            "passed": limit.at < q.T}  # fmt: skip

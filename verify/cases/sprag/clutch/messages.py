"""What is told of a sprag clutch first: whether it holds, what ends its work, its radii."""

import math
from collections.abc import Sequence
from typing import Any

from verify.cases.freewheel.clutch.numbers import newton, newton_metres, pascal
from verify.cases.sprag.clutch.bodies import thrown
from verify.cases.sprag.clutch.limits import Limit, as_torque_grows, verdict
from verify.cases.sprag.clutch.model import built
from verify.cases.sprag.clutch.recommendations import why
from verify.cases.sprag.inputs import EngagementInputs, SpragInputs
from verify.core.case import Values

DEGREE = math.degrees(1.0)
UM = 1e-6
STEEL = (195e9, 220e9)  # Pa, of which Palmgren's law is
SHORT = 1e-4  # of the law's last load: below it slices are not solved
HARD = 0.1  # of N, by which springs press
REACHED = 0.5  # of z_m: an end slice that drops by less is told
DEEPER = 1.05  # times what it drops, by twice z_m: not worth it
UNEVEN = 1.5  # over Eq. 6's smeared ring
THROWN = 0.1  # of N_0, by which centrifugal forces change it
SLOWLY = "; this is of a torque that rises slowly: one that comes at once nearly doubles the " \
    "force (check --dynamic)"  # fmt: skip
LOOSE = 0.25  # rad, beyond which a sprag has turned a lot


def findings(q: SpragInputs, v: Values) -> Sequence[str]:
    state = verdict(q, v)
    stands = state in ("holds", "overloaded")
    found = [f"{state}: {why(q, v)}" + (SLOWLY if state == "holds" else "")]
    if "N" in v and not stands:
        found.append("forces, turns, pressures and stresses below are those it would have if it "
                     "held")  # fmt: skip
    if state != "slips":
        found += as_it_grows(q)
    if "N" in v:
        found += [stiff(v, stands), crowned(v, stands), *dropped(q, v), beside(v), *elastic(v)]
    return [*found, sensitive(v)]


def as_it_grows(q: SpragInputs) -> list[str]:
    """Limits that the torque has passed, and what comes first as it grows."""
    known = [x for x in as_torque_grows(q) if x.key != "wide"]
    passed, ahead = [x for x in known if x.at <= q.T], [x for x in known if x.at > q.T]
    lines = []
    if passed:
        lines.append(f"passed already: {'; '.join(map(_at, passed))}")
    if ahead:
        lines.append(f"as the torque grows, {'; then '.join(map(_at, ahead[:3]))}")
    return lines


def _at(limit: Limit) -> str:
    return f"{limit.words} at {newton_metres(limit.at)}"


def stiff(v: Values, stands: bool) -> str:
    bears, has, have = ("bears", "has", "have") if stands else ("would bear", *("would have",) * 2)
    return (
        f"each sprag {bears} {newton(v['N'])} and {has} turned by {v['alpha'] * DEGREE:.3g}°; the "
        f"races {have} turned by {v['theta'] * DEGREE:.3g}° against each other, "
        f"{v['stiffness']:.4g} N m/rad at this torque"
    )


def crowned(v: Values, stands: bool) -> str:
    """Pressures of both races, the crown's peak over the middle's."""
    told = [
        f"{pascal(v[f'p_{k}'])} at the {race} race ({v[f'p_{k}'] / v[f'p_{k} mid']:.3g} times "
        "that at mid-length)"
        for k, race in (("i", "inner"), ("o", "outer"))
    ]
    return f"the contacts' slices {'' if stands else 'would '}bear up to {' and '.join(told)}"


def dropped(q: SpragInputs, v: Values) -> list[str]:
    """Where z_m is reached at the very ends alone."""
    if q.z_m == 0 or v["z_end"] > REACHED * q.z_m:
        return []
    flat = v["z_end, 2 z_m"] < DEEPER * v["z_end"]
    more = ", a larger one changes little" if flat else ""
    return [
        f"the crown drops by {v['z_end'] / UM:.3g} µm at the middle of its end slices: z_m = "
        f"{q.z_m / UM:.3g} µm is reached at the very ends alone{more}"
    ]


def beside(v: Values) -> str:
    """What two other models say at the same torque."""
    return (
        f"with rigid races (Liu) the sprags would turn by {v['alpha Liu'] * DEGREE:.3g}°, by Eqs. "
        f"9 and 10 as printed by {v['alpha printed'] * DEGREE:.3g}°"
    )


def elastic(v: Values) -> list[str]:
    """What the parts' elasticity makes of the turn, and of the engagement's time."""
    if not {"alpha elastic", "theta elastic"} <= set(v):
        return []
    share = v["theta"] / v["theta elastic"]
    times = math.sqrt(share)
    spring = "softer" if share > 1 else "stiffer"
    return [
        "as elastic bodies (case sprag-wedge, where finite elements judge them) the sprags turn "
        f"by {v['alpha elastic'] * DEGREE:.3g}°: the paper's deflections, used here, make the "
        f"clutch {spring} and its period of oscillation about {times:.3g} times as long"
    ]


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
            else "no state that bears the springs alone was found: N_0 is not known"
        )
    found += [
        f"the {race} race deflects {v[key]:.3g} times as much under each sprag as Eq. 6's smeared "
        "ring: few sprags or a thin wall make it no round race, its stress is not the smeared one's"
        for key, race in (("uneven_i", "inner"), ("uneven_e", "outer"))
        if v.get(key, 0.0) > UNEVEN
    ]
    if isinstance(q, EngagementInputs) and (F := thrown(q)) > THROWN * v.get("N_0", math.inf):
        found.append(
            f"at n each sprag feels m_g ω² r = {newton(F)} of centrifugal force, its springs press "
            f"with {newton(v['N_0'])}: n counts for the growth of the outer race alone here"
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

"""Advice on a sprag clutch: whether it holds, what ends its grip first, warnings, refusal."""

import math
from collections.abc import Sequence
from typing import Any

from verify.cases.freewheel.clutch.numbers import newton, newton_metres, pascal
from verify.cases.sprag.clutch.bodies import centrifugal_force
from verify.cases.sprag.clutch.formulas import ClutchFormulas
from verify.cases.sprag.clutch.limits import Limit, as_torque_grows
from verify.cases.sprag.clutch.model import built, under
from verify.cases.sprag.clutch.recommendations import verdict, why
from verify.cases.sprag.inputs import EngagementInputs

DEGREE = math.degrees(1.0)
UM = 1e-6
STEEL = (195e9, 220e9)  # Pa, of which Palmgren's law is
SHORT = 1e-4  # of the law's last load: below it slices are not solved
HARD = 0.1  # of N, by which springs press
REACHED = 0.5  # of z_m: an end slice that drops by less is stated
DEEPER = 1.05  # times what it drops, by twice z_m: not worth it
UNEVEN = 1.5  # over Eq. 6's smeared ring
CENTRIFUGAL = 0.1  # of N_0, by which centrifugal forces change it
SLOWLY = "; this is of a torque that rises slowly: one that comes at once nearly doubles the " \
    "force (check --dynamic)"  # fmt: skip
FINEST = 61  # slices that the reference solves at each of many loads
LOOSE = 0.25  # rad, beyond which a sprag has turned a lot


def findings(q: ClutchFormulas) -> Sequence[str]:
    state = verdict(q)
    stands = state in ("holds", "overloaded")
    found = [f"{state}: {why(q)}" + (SLOWLY if state == "holds" else "")]
    if q.state and not stands:
        found.append("forces, turns, pressures and stresses below are those it would have if it "
                     "held")  # fmt: skip
    if state != "slips":
        found += as_it_grows(q)
    if q.state:
        found += [stiff(q, stands), crowned(q, stands), *dropped(q), beside(q), *elastic(q)]
    return [*found, sensitive(q)]


def as_it_grows(q: ClutchFormulas) -> list[str]:
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


def stiff(q: ClutchFormulas, stands: bool) -> str:
    bears, has, have = ("bears", "has", "have") if stands else ("would bear", *("would have",) * 2)
    return (
        f"each sprag {bears} {newton(q.N)} and {has} turned by {q.alpha * DEGREE:.3g}°; the "
        f"races {have} turned by {q.theta * DEGREE:.3g}° against each other, "
        f"{q.stiffness:.4g} N m/rad at this torque"
    )


def crowned(q: ClutchFormulas, stands: bool) -> str:
    """Pressures of both races, the crown's peak over the middle's."""
    pressures = [
        f"{pascal(p)} at the {race} race ({p / mid:.3g} times that at mid-length)"
        for p, mid, race in ((q.p_i, q.p_i_mid, "inner"), (q.p_o, q.p_o_mid, "outer"))
    ]
    return f"the contacts' slices {'' if stands else 'would '}bear up to {' and '.join(pressures)}"


def dropped(q: ClutchFormulas) -> list[str]:
    """Where z_m is reached at the very ends alone."""
    if q.z_m == 0 or q.z_end > REACHED * q.z_m:
        return []
    flat = q.z_end_deeper < DEEPER * q.z_end
    more = ", a larger one changes little" if flat else ""
    return [
        f"the crown drops by {q.z_end / UM:.3g} µm at the middle of its end slices: z_m = "
        f"{q.z_m / UM:.3g} µm is reached at the very ends alone{more}"
    ]


def beside(q: ClutchFormulas) -> str:
    """What two other models say at the same torque."""
    return (
        f"with rigid races (Liu) the sprags would turn by {q.alpha_Liu * DEGREE:.3g}°, by Eqs. "
        f"9 and 10 as printed by {q.alpha_printed * DEGREE:.3g}°"
    )


def elastic(q: ClutchFormulas) -> list[str]:
    """What the parts' elasticity makes of the turn, and of the engagement's time."""
    if not math.isfinite(q.alpha_elastic + q.theta_elastic):
        return []
    share = q.theta / q.theta_elastic
    times = math.sqrt(share)
    spring = "softer" if share > 1 else "stiffer"
    return [
        "as elastic bodies (case sprag-wedge, where finite elements judge them) the sprags turn "
        f"by {q.alpha_elastic * DEGREE:.3g}°: the paper's deflections, used here, make the "
        f"clutch {spring} and its period of oscillation about {times:.3g} times as long"
    ]


def sensitive(q: ClutchFormulas) -> str:
    turn, tilt = q.dalpha_per_dR_i * 10 * UM * DEGREE, q.dnu_0_per_dR_i * 10 * UM * DEGREE
    return (
        f"10 µm of R_i or R_e turn the unloaded sprags by {abs(turn):.3g}°; the spiral keeps "
        f"their wedge angle to {abs(tilt):.2g}°"
    )


def warnings(q: ClutchFormulas) -> Sequence[str]:
    found = []
    if not STEEL[0] <= q.E <= STEEL[1]:
        found.append(
            f"slices follow Palmgren's law, which is steel's whatever E = {q.E / 1e9:.4g} GPa says"
        )
    if q.state and SHORT * built(q).N_top > q.N:
        found.append(f"N = {newton(q.N)} is below the least load for which slices were solved")
    if q.alpha > LOOSE:
        found.append(
            f"the sprags turn by {q.alpha * DEGREE:.3g}° under T: a part of their profile that "
            "few sprags have"
        )
    if not HARD * (q.N if q.state else math.inf) >= q.N_0:
        found.append(
            f"the springs alone press with {newton(q.N_0)}, more than a tenth of what the "
            "torque asks for"
            if math.isfinite(q.N_0)
            else "no state that bears the springs alone was found: N_0 is not known"
        )
    found += [
        f"the {race} race deflects {times:.3g} times as much under each sprag as Eq. 6's smeared "
        "ring: few sprags or a thin wall make it no round race, its stress is not the smeared one's"
        for times, race in zip(q.uneven, ("inner", "outer"), strict=True)
        if times > UNEVEN
    ]
    if (F := centrifugal_force(q)) > CENTRIFUGAL * q.N_0:
        found.append(
            f"at n each sprag feels m_g ω² r = {newton(F)} of centrifugal force, its springs press "
            f"with {newton(q.N_0)}: n counts for the growth of the outer race alone here"
        )
    if q.l < q.b:
        found.append("sprags are shorter than wide: line contacts they hardly have")
    return found


def refusal(q: EngagementInputs) -> str:
    """Why the drawn sprag and strips cannot solve these inputs."""
    now = under(q)
    if now is None or float(now.turned) > q.alpha_max:
        return "no state within the profile bears this torque; check it without --fem"
    if float(now.N) < SHORT * built(q).N_top:
        return "N is below the least load that slices are solved for; check it without --fem"
    if q.slices > FINEST:
        return f"{q.slices} slices are solved anew at each load, more than {FINEST} are slow; "\
            "check it without --fem"  # fmt: skip
    return ""


def summary(q: ClutchFormulas) -> dict[str, Any]:
    """JSON; `margin` is mu_s/tan(nu), None without a state; limits of T [N m]."""
    return {
        "verdict": verdict(q), "margin": q.safety if q.state else None,
        "limits": [_limit(q, x) for x in as_torque_grows(q)],
    }  # fmt: skip


def _limit(q: ClutchFormulas, limit: Limit) -> dict[str, Any]:
    return {"of": "T", "key": limit.key, "what": limit.words, "at": limit.at, "unit": "N m",
            "passed": limit.at < q.T}  # fmt: skip

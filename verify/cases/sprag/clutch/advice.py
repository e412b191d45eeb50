"""Advice on a sprag clutch: verdict, first limit reached, warnings, refusal."""

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
SHORT = 1e-4  # over the law's last load: slices are not solved below it
HARD = 0.1  # spring force over N
REACHED = 0.5  # over z_m: a smaller drop of an end slice is reported
DEEPER = 1.05  # ratio of the drop with twice z_m to the drop: no benefit below it
UNEVEN = 1.5  # deflection over the uniformly loaded ring of Eq. 6
CENTRIFUGAL = 0.1  # relative change of N_0 by centrifugal forces
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
    """Limits exceeded by the torque, and the first limit as it grows."""
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
    carries = "carries" if stands else "would carry"
    has, have = ("has", "have") if stands else ("would have",) * 2
    return (
        f"each sprag {carries} {newton(q.N)} and {has} rotated by {q.alpha * DEGREE:.3g}°; the "
        f"races {have} a wind-up of {q.theta * DEGREE:.3g}°, "
        f"{q.stiffness:.4g} N m/rad at this torque"
    )


def crowned(q: ClutchFormulas, stands: bool) -> str:
    """Pressures of both races, the crown's peak over the middle's."""
    pressures = [
        f"{pascal(p)} at the {race} race ({p / mid:.3g} times that at mid-length)"
        for p, mid, race in ((q.p_i, q.p_i_mid, "inner"), (q.p_o, q.p_o_mid, "outer"))
    ]
    largest = f"largest pressure of the contacts' slices{'' if stands else ' if it held'}"
    return f"{largest}: {' and '.join(pressures)}"


def dropped(q: ClutchFormulas) -> list[str]:
    """Warning if the drop reaches z_m only at the outermost ends."""
    if q.z_m == 0 or q.z_end > REACHED * q.z_m:
        return []
    flat = q.z_end_deeper < DEEPER * q.z_end
    more = ", a larger one changes little" if flat else ""
    return [
        f"the crown drops by {q.z_end / UM:.3g} µm at the middle of its end slices: z_m = "
        f"{q.z_m / UM:.3g} µm is reached at the very ends only{more}"
    ]


def beside(q: ClutchFormulas) -> str:
    """Results of two other models at this torque."""
    return (
        f"with rigid races (Liu) the sprags would turn by {q.alpha_Liu * DEGREE:.3g}°, by Eqs. "
        f"9 and 10 as printed by {q.alpha_printed * DEGREE:.3g}°"
    )


def elastic(q: ClutchFormulas) -> list[str]:
    """Effect of elastic parts on the rotation and on the duration of the engagement."""
    if not math.isfinite(q.alpha_elastic + q.theta_elastic):
        return []
    share = q.theta / q.theta_elastic
    times = math.sqrt(share)
    spring = "softer" if share > 1 else "stiffer"
    return [
        "as elastic bodies (case sprag-wedge, checked there by finite elements) the sprags turn "
        f"by {q.alpha_elastic * DEGREE:.3g}°: the paper's deflections, used here, make the "
        f"clutch {spring} and its period of oscillation about {times:.3g} times as long"
    ]


def sensitive(q: ClutchFormulas) -> str:
    turn, tilt = q.dalpha_per_dR_i * 10 * UM * DEGREE, q.dnu_0_per_dR_i * 10 * UM * DEGREE
    return (
        f"10 µm of R_i or R_e rotate the unloaded sprags by {abs(turn):.3g}°; the spiral "
        f"maintains their wedge angle to {abs(tilt):.2g}°"
    )


def warnings(q: ClutchFormulas) -> Sequence[str]:
    found = []
    if not STEEL[0] <= q.E <= STEEL[1]:
        found.append(
            f"slices follow Palmgren's law, which is of steel and independent of E = "
            f"{q.E / 1e9:.4g} GPa"
        )
    if q.state and SHORT * built(q).N_top > q.N:
        found.append(f"N = {newton(q.N)} is below the least load for which slices were solved")
    if q.alpha > LOOSE:
        found.append(
            f"the sprags turn by {q.alpha * DEGREE:.3g}° under T: few sprags have a "
            "profile that long"
        )
    if not HARD * (q.N if q.state else math.inf) >= q.N_0:
        found.append(
            f"the springs alone press with {newton(q.N_0)}, more than a tenth of the force "
            "under the torque"
            if math.isfinite(q.N_0)
            else "no equilibrium under the springs alone was found: N_0 is not known"
        )
    found += [
        f"the {race} race deflects {times:.3g} times as much under each sprag as the uniformly "
        "loaded ring of Eq. 6: few sprags or a thin wall, its shape and stress are not uniform"
        for times, race in zip(q.uneven, ("inner", "outer"), strict=True)
        if times > UNEVEN
    ]
    if (F := centrifugal_force(q)) > CENTRIFUGAL * q.N_0:
        found.append(
            f"at n the centrifugal force on a sprag is m_g ω² r = {newton(F)}, its springs press "
            f"with {newton(q.N_0)}: here n affects the growth of the outer race only"
        )
    if q.l < q.b:
        found.append("sprags are shorter than wide: their contacts are hardly line contacts")
    return found


def refusal(q: EngagementInputs) -> str:
    """Why the drawn sprag and strips cannot solve these inputs."""
    now = under(q)
    if now is None or float(now.turned) > q.alpha_max:
        return "no equilibrium within the profile exists at this torque; check it without --fem"
    if float(now.N) < SHORT * built(q).N_top:
        return "N is below the least load that slices are solved for; check it without --fem"
    if q.slices > FINEST:
        return f"{q.slices} slices are solved again at each load, more than {FINEST} are slow; "\
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

"""Statements on a sprag clutch: verdict, limits, warnings, reasons why no reference exists."""

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
SLOWLY = "; this applies to a slowly rising torque: a suddenly applied torque nearly doubles the " \
    "force (see freewheel check --dynamic)"  # fmt: skip
FINEST = 61  # slices that the reference solves at each of many loads
LOOSE = 0.25  # rad, beyond which a sprag has turned a lot


def findings(q: ClutchFormulas) -> Sequence[str]:
    state = verdict(q)
    stands = state in ("holds", "overloaded")
    found = [f"{state}: {why(q)}" + (SLOWLY if state == "holds" else "")]
    if q.state and not stands:
        found.append("the forces, rotations, pressures and stresses below assume that the clutch "
                     "holds")  # fmt: skip
    if state != "slips":
        found += as_it_grows(q)
    if q.state:
        found += [stiff(q, stands), crowned(q, stands), *dropped(q), beside(q), *elastic(q)]
    return [*found, sensitive(q)]


def as_it_grows(q: ClutchFormulas) -> list[str]:
    """Sentences on limits that the torque exceeds, and on limits reached next if it increases."""
    known = [x for x in as_torque_grows(q) if x.key != "wide"]
    passed, ahead = [x for x in known if x.at <= q.T], [x for x in known if x.at > q.T]
    lines = []
    if passed:
        lines.append(f"limits below T: {'; '.join(map(_at, passed))}")
    if ahead:
        lines.append(f"if the torque increases, {'; then '.join(map(_at, ahead[:3]))}")
    return lines


def _at(limit: Limit) -> str:
    return f"{limit.words} at {newton_metres(limit.at)}"


def stiff(q: ClutchFormulas, stands: bool) -> str:
    carries = "carries" if stands else "would carry"
    has, have = ("has", "have") if stands else ("would have",) * 2
    return (
        f"each sprag {carries} {newton(q.N)} and {has} rotated by {q.alpha * DEGREE:.3g}°; the "
        f"races {have} a wind-up of {q.theta * DEGREE:.3g}°; the torsional stiffness at this "
        f"torque is {q.stiffness:.4g} N m/rad"
    )


def crowned(q: ClutchFormulas, stands: bool) -> str:
    """Sentence on the largest pressures of both races, relative to those at mid-length."""
    pressures = [
        f"{pascal(p)} at the {race} race ({p / mid:.3g} times that at mid-length)"
        for p, mid, race in ((q.p_i, q.p_i_mid, "inner"), (q.p_o, q.p_o_mid, "outer"))
    ]
    largest = f"largest pressure of the slices{'' if stands else ' if the clutch held'}"
    return f"{largest}: {' and '.join(pressures)}"


def dropped(q: ClutchFormulas) -> list[str]:
    """Warning if the drop of the crown reaches z_m only at the ends; empty otherwise."""
    if q.z_m == 0 or q.z_end > REACHED * q.z_m:
        return []
    flat = q.z_end_deeper < DEEPER * q.z_end
    more = "; a larger z_m hardly changes the drop of these slices" if flat else ""
    return [
        f"the drop of the crown is {q.z_end / UM:.3g} µm at the middle of its end slices: z_m = "
        f"{q.z_m / UM:.3g} µm is reached only at the ends{more}"
    ]


def beside(q: ClutchFormulas) -> str:
    """Sentence on the sprag rotation with rigid races, and by Eqs. 9 and 10 as printed."""
    return (
        f"sprag rotation by other models: {q.alpha_Liu * DEGREE:.3g}° with rigid races (Liu), "
        f"{q.alpha_printed * DEGREE:.3g}° by Eqs. 9 and 10 as printed"
    )


def elastic(q: ClutchFormulas) -> list[str]:
    """Sentence on the rotation with elastic bodies, and on the effect on the oscillation period."""
    if not math.isfinite(q.alpha_elastic + q.theta_elastic):
        return []
    share = q.theta / q.theta_elastic
    times = math.sqrt(share)
    spring = "softer" if share > 1 else "stiffer"
    return [
        "with the deflections of elastic bodies (case sprag-wedge, verified by finite elements), "
        f"the sprags rotate by {q.alpha_elastic * DEGREE:.3g}°; with the deflections of the paper, "
        f"used here, the clutch is {spring} than with elastic bodies and its period of "
        f"oscillation is about {times:.3g} times as long"
    ]


def sensitive(q: ClutchFormulas) -> str:
    turn, tilt = q.dalpha_per_dR_i * 10 * UM * DEGREE, q.dnu_0_per_dR_i * 10 * UM * DEGREE
    return (
        f"a change of R_i or R_e by 10 µm rotates the unloaded sprags by {abs(turn):.3g}°; the "
        f"wedge angle of the spiral changes by only {abs(tilt):.2g}°"
    )


def warnings(q: ClutchFormulas) -> Sequence[str]:
    found = []
    if not STEEL[0] <= q.E <= STEEL[1]:
        found.append(
            f"the slices use Palmgren's law, which applies to steel only and does not depend on E "
            f"= {q.E / 1e9:.4g} GPa"
        )
    if q.state and SHORT * built(q).N_top > q.N:
        found.append(f"N = {newton(q.N)} is below the smallest load for which slices were solved")
    if q.alpha > LOOSE:
        found.append(
            f"the sprags rotate by {q.alpha * DEGREE:.3g}° under T: the profile of most sprags "
            "ends at a smaller rotation"
        )
    if not HARD * (q.N if q.state else math.inf) >= q.N_0:
        found.append(
            f"the contact force by the springs alone is {newton(q.N_0)}, more than a tenth of the "
            "force under the torque"
            if math.isfinite(q.N_0)
            else "no equilibrium under the springs alone was found: N_0 is unknown"
        )
    found += [
        f"the {race} race deflects {times:.3g} times as much under each sprag as the uniformly "
        "loaded ring of Eq. 6: because of few sprags or a thin wall, its stress is not uniform"
        for times, race in zip(q.uneven, ("inner", "outer"), strict=True)
        if times > UNEVEN
    ]
    if (F := centrifugal_force(q)) > CENTRIFUGAL * q.N_0:
        found.append(
            f"at n the centrifugal force on a sprag is m_g ω² r = {newton(F)}, the contact force "
            f"by its springs is {newton(q.N_0)}: the formulas omit centrifugal forces on sprags"
        )
    if q.l < q.b:
        found.append("l < b: sprags shorter than their width do not have line contacts")
    return found


def refusal(q: EngagementInputs) -> str:
    """Reason why the reference cannot solve these inputs; empty if it can."""
    now = under(q)
    if now is None or float(now.turned) > q.alpha_max:
        return "at this torque no equilibrium exists within the profile; check it without --fem"
    if float(now.N) < SHORT * built(q).N_top:
        return "N is below the smallest load of the contact laws; check it without --fem"
    if q.slices > FINEST:
        return f"the reference solves {q.slices} slices at each load; the limit is {FINEST}; "\
            "check it without --fem"  # fmt: skip
    return ""


def summary(q: ClutchFormulas) -> dict[str, Any]:
    """Results for JSON: verdict, `margin` mu_s/tan(nu) (None without a state), limits of T."""
    return {
        "verdict": verdict(q), "margin": q.safety if q.state else None,
        "limits": [_limit(q, x) for x in as_torque_grows(q)],
    }  # fmt: skip


def _limit(q: ClutchFormulas, limit: Limit) -> dict[str, Any]:
    return {"of": "T", "key": limit.key, "what": limit.words, "at": limit.at, "unit": "N m",
            "passed": limit.at < q.T}  # fmt: skip

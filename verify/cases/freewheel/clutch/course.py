"""Messages on the limits of a freewheel: limits exceeded now, or reached next under more load."""

import math
from collections.abc import Sequence

from analytic.freewheel.duty import SEVERITY, Limit
from verify.cases.freewheel.clutch.classes import past_corners
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.cases.freewheel.clutch.numbers import newton, newton_metres, pascal
from verify.core.case import Values

FAR = 10.0  # limits beyond this multiple of the next limit are not reported


def torque(q: ClutchInputs, v: Values) -> list[str]:
    """Messages on limits of the torque, exceeded or reached next, at constant axial load."""
    limits = q.duty.of_torque
    passed = [limit for limit in limits if limit.at < q.T]
    ahead = [limit for limit in limits if limit.at > q.T]
    ahead = [limit for k, limit in enumerate(ahead) if k == 0 or limit.key != "hertz"]
    found = [
        f"already beyond a limit of the torque: {limit.words} at {newton_metres(limit.at)}"
        for limit in sorted(passed, key=lambda x: SEVERITY.index(x.key))
    ]
    if v["safety"] < 1:
        found.append(where_friction_holds(q))
    if ahead:
        listed = _listed(ahead, q.T, "T")
        found.append(
            "next limits as the torque grows (stresses in the rings and at the rollers' ends are "
            f"not included): {listed}"
        )
    if (least := v.get("T_bears", 0.0)) > 0 and not past_corners(q, v):
        found.append(
            f"limit as the torque falls: below {newton_metres(least)} ({least / q.T:.3g} times T) "
            f"the clutch slips axially under F_ax = {newton(q.F_ax)}"
        )
    return found


def where_friction_holds(q: ClutchInputs) -> str:
    ranges = q.duty.friction_holds
    if q.F_ax == 0 and ranges and math.isfinite(ranges[0][1]):
        return f"without axial load, friction holds up to {newton_metres(ranges[0][1])}"
    parts = [f"{a:.4g} to {newton_metres(b)}" if math.isfinite(b) else f"{newton_metres(a)} upwards"
            for a, b in ranges]  # fmt: skip
    at = f"at torques from {' and from '.join(parts)}" if parts else "at no value of the torque"
    return f"friction transmits F_ax = {newton(q.F_ax)} {at}"


def axial(q: ClutchInputs, v: Values) -> list[str]:
    """Messages on limits of the axial load, exceeded or reached next, at constant torque."""
    if v["F_slip"] == 0:
        return ["friction transmits no axial load at this torque"]
    limits = [limit for limit in q.duty.of_axial_load if limit.at > 0]
    passed = [limit for limit in limits if limit.at < q.F_ax]
    ahead = [limit for limit in limits if limit.at >= q.F_ax]
    found = [
        f"already beyond a limit of the axial load: {limit.words} at {newton(limit.at)}"
        for limit in sorted(passed, key=lambda x: SEVERITY.index(x.key))
    ]
    if ahead:
        found.append(f"next limits as the axial load grows: {_listed(ahead, q.F_ax, 'F_ax')}")
    return found


def tilted(q: ClutchInputs, v: Values) -> list[str]:
    if q.F_ax == 0:
        return []
    end = f"{pascal(v['p_end'])} at one end" if "p_end" in v else "unbounded at one end"
    return [
        "the couple of the axial forces tilts the rollers: the normal forces shift by "
        f"{v['e_L']:.2g} L along the rollers, and the peak pressure is {end}; the friction "
        "criterion does not include the tilt"
    ]


def _listed(limits: Sequence[Limit], now: float, symbol: str) -> str:
    """Text with the limit reached next, the one after it if near, and their ratios to `now`."""
    parts, written = [], newton if symbol == "F_ax" else newton_metres
    for k, limit in enumerate(limits[:2]):
        if limit.at > FAR * max(limits[0].at, now):
            break
        margin = f", {limit.at / now:.3g} times {symbol}" if now > 0 else ""
        parts.append(f"{'first ' if k == 0 else ''}{limit.words} ({written(limit.at)}{margin})")
    return ", then ".join(parts)

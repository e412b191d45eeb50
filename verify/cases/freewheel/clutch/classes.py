"""Class of a freewheel by its worst limit."""

import math

from analytic.freewheel import criterion
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.core.case import Values


def light(q: ClutchInputs, v: Values) -> str:
    """Class by the worst limit: "free", "green", "overloaded", "yellow" or "red".

    The class is also red if the torque alone releases the rollers, or if the rollers are beyond the
    ends of the flats. The class is overloaded if friction holds, but pressure or tilt is beyond its
    limit.
    """
    if q.T < 0:
        return "free"
    if q.T == 0 and q.F_ax == 0:
        return "green" if v["mu_0"] <= q.mu else "red"
    if "safety" not in v or v["mu_0"] > q.mu or past_corners(q, v):
        return "red"
    found = str(criterion.traffic_light(v["safety"]))
    return "overloaded" if found == "green" and overloaded(q, v) else found


def past_corners(q: ClutchInputs, v: Values) -> bool:
    return v.get("T_corner", math.inf) < q.T


def overloaded(q: ClutchInputs, v: Values) -> bool:
    """Whether the pressure (also at the rollers' ends) exceeds p_lim, or the tilt its limit."""
    pressed = q.p_lim is not None and v.get("p_end", math.inf) > q.p_lim
    return pressed or v["e_L"] > q.duty.allowed_shift

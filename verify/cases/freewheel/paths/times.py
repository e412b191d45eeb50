"""When a load path reaches what finite elements bear: paths and slip written anew.

From the definitions of the paths (Sec. 6 and the case's readings) and numbers of finite elements
alone; nothing here comes from the formulas' side, whose times of slip are judged against these.
"""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from verify.core.case import Values

Array = NDArray[np.float64]

FINE = 400  # times of a cycle: a crossing below the top by less than 4e-5 of it may be missed
ROUND_OFF = 1e-9  # of the cycles, so that their times are the same on all processors
MU_REQ = {1.0: "mu_req_high", 0.3: "mu_req_low"}  # of finite elements, by sines of load case 3


def time_of_slip(q: Any, case: int, F: float, fem: Values) -> float:
    """First time [s] at which the path asks for more than `F` [N] bears; inf where it never does.

    `F` is what finite elements bear under T, of load case 3 under its critical torque; `fem` has
    their mu_req at two torques of load case 3, between which tan(alpha) is linear: to 2e-3 of
    the case's clutch, 0.3 % of the load where its path slips.
    """
    if case == 1:
        t: float = q.rise + F / q.F_ax * (q.duration - q.rise)
        return t if t <= q.duration else math.inf
    if case == 2:
        span = q.duration - q.rise

        def beyond(t: float) -> float:
            s = t - q.rise
            return float(q.F_ax * s / span * abs(math.sin(2 * math.pi * q.f * s)) - F)

        return _first(beyond, q.rise, q.duration, q.f)
    tan = tan_of(q, fem)
    mu = tan(q.T_critical) * math.hypot(1, q.R * F / q.T_critical)

    def asks(t: float) -> float:
        sine = math.sin(2 * math.pi * q.f * t)
        T, load = q.T_m + q.T * sine, q.F_ax * t / q.duration * sine
        return tan(T) * math.hypot(1, q.R * load / T) - mu if T > 0 else -mu

    return _first(asks, 0.0, q.duration, q.f)


def tan_of(q: Any, fem: Values) -> Callable[[float], float]:
    """tan(alpha) of finite elements over the torque [N m], by a line through two of them."""

    def at(sine: float) -> tuple[float, float]:
        T = q.T_m + sine * q.T
        return T, fem[MU_REQ[sine]] / math.hypot(1, q.R * sine * q.F_ax / T)

    (T, tan), (T_low, tan_low) = map(at, MU_REQ)
    return lambda torque: tan + (torque - T) * (tan - tan_low) / (T - T_low)


def _first(beyond: Callable[[float], float], start: float, end: float, f: float) -> float:
    """First root of `beyond` after which it is positive."""
    cycles = f * (end - start) * (1 - ROUND_OFF)
    times = np.linspace(start, end, 1 + math.ceil(FINE * cycles))
    above = np.flatnonzero([beyond(float(t)) > 0 for t in times])
    if not above.size:
        return math.inf
    k = int(above[0])
    return float(brentq(beyond, times[k - 1], times[k])) if k else start

"""Formulas of an engagement: statics, energy, small oscillations, two races on a spring.

Rolling contacts couple the motion of the sprags to the relative rotation theta of the races. With
massless sprags, the clutch is a spring T(theta) with the normal force N(theta). Its statics satisfy
the work balance. The two races oscillate on this spring.
"""

import math
from collections.abc import Mapping
from functools import lru_cache

import numpy as np

from analytic.sprag import swing as swinging
from analytic.sprag.swing import Driven, Swing
from analytic.sprag.work_balance import (
    asked,
    asked_at_start,
    at_rest,
    by_turning,
    frequency,
    left_out,
    passed_on,
    sprags_inertia,
    undamped,
)
from verify.cases.sprag.engagement.model import crowned_for, motion, wedge
from verify.cases.sprag.inputs import EngagementInputs

MORE = 1.6  # torque of the second engagement: 40 N m for the paper's 25


@lru_cache(maxsize=64)
def swing(q: EngagementInputs, *, rigid: bool = False) -> Swing:
    """Oscillation of two races, with the clutch as a spring.

    The races are rigid (Liu) if `rigid`.
    """
    driven = Driven(T=q.T, t_ramp=q.t_ramp, w_i=q.w_i, t_end=q.t_end)
    return swinging.swing(wedge(q, rigid=rigid), driven, motion(q))


def analytic(q: EngagementInputs) -> Mapping[str, float]:
    """Values of all formulas in SI units by name; values without a solution are omitted."""
    w = wedge(q)
    first, found, force = w.states, swing(q), w.force()
    rest, peak = at_rest(w, q.T), undamped(w, q.T)
    N, N_max = float(force(rest)), found.peak[1]
    more = swing(with_torque(q)).peak[1]
    rigid = swing(q, rigid=True).peak[1]
    values = {
        "N_max": N_max, "t_max": found.peak[0], "factor": N_max / N, "N": N, "theta": rest,
        "alpha": float(np.interp(rest, w.theta, first.alpha)),
        "k": float(w.resistance()(rest, 1)), "f": frequency(w, q.T, motion(q)),
        "N_undamped": float(force(peak)), "N_max more": more, "N_max rigid": rigid,
        "ratio": more / N_max, "rigid": rigid / N_max,
        "mu_asked": asked(w, float(np.interp(N_max, first.N, w.theta))),
        "work": q.T * float(np.interp(N_max, first.N, w.theta)),
        "unequal": float(np.interp(N_max, first.N[1:], first.N_e[1:] / first.N[1:])) - 1,
        "left out": left_out(w, float(force(peak))), "by turning": by_turning(w),
        "passed on": passed_on(w, q.T), "inertia": sprags_inertia(w, rest, motion(q)) / q.I_bi,
        "over": float(found.over), "over more": float(swing(with_torque(q)).over),
        "start": asked_at_start(w, q.T, motion(q)) if q.t_ramp == 0 else 0.0,
    }  # fmt: skip
    return {key: value for key, value in values.items() if math.isfinite(value)}


def with_torque(q: EngagementInputs, factor: float = MORE) -> EngagementInputs:
    """Inputs of the clutch under `factor` times the torque, with unchanged crown."""
    return q.model_copy(update={"T": factor * q.T, "Q": crowned_for(q)})

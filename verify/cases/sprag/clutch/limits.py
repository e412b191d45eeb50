"""What ends a sprag clutch's work first as its torque grows: friction, pressure, its profile."""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.optimize import brentq

from analytic.sprag.closure import wedged
from verify.cases.sprag.clutch.bodies import least_force
from verify.cases.sprag.clutch.model import built, grip
from verify.cases.sprag.inputs import SpragInputs

LEAST = 1e-4  # of the largest load: below, no pressure is searched

WORDS = {
    "slip": "the contacts slip",
    "pressure_inner": "the inner contacts reach p_lim",
    "pressure_outer": "the outer contacts reach p_lim",
    "yield_inner": "the inner race yields at its bore",
    "yield_outer": "the outer race yields at its bore",
    "end": "the sprags reach the end of their profile and roll over",
    "wide": "contacts 0.15 of their relative radius wide, where the formulas end",
}


@dataclass(frozen=True)
class Limit:
    """A limit of the torque [N m]: its key in `WORDS` and its value."""

    key: str
    at: float

    @property
    def words(self) -> str:
        return WORDS[self.key]


@lru_cache(maxsize=16)
def as_torque_grows(q: SpragInputs) -> tuple[Limit, ...]:
    """Limits of the torque, the first one first; those that are not met are left out."""
    one = built(q)
    alone = grip(q)
    found = {
        "slip": float(alone.slip), "end": float(alone.end_of_cam),
        "wide": float(wedged(one.clutch, one.N_top).T),
    }  # fmt: skip
    if q.p_lim is not None:
        for k, name in enumerate(("inner", "outer")):
            found[f"pressure_{name}"] = _pressed(q, k)
    if q.R_p is not None:
        for k, name in enumerate(("inner", "outer")):
            N = least_force(q, k)
            found[f"yield_{name}"] = float(wedged(one.clutch, N).T) if one.N_top >= N else math.inf
    ordered = sorted((Limit(k, at) for k, at in found.items() if math.isfinite(at)), key=_place)
    return tuple(ordered)


def _place(limit: Limit) -> float:
    return limit.at


def _pressed(q: SpragInputs, contact: int) -> float:
    """Torque [N m] at which the inner (0) or outer (1) contact's peak is p_lim; inf if never."""
    one, p_lim = built(q), float(q.p_lim or math.inf)

    def over(log_N: float) -> float:
        return math.log(one.peaks(math.exp(log_N))[contact] / p_lim)

    low, high = math.log(LEAST * one.N_top), math.log(one.N_top)
    if over(high) < 0:
        return math.inf
    N = 0.0 if over(low) > 0 else math.exp(brentq(over, low, high, xtol=1e-9))
    T = float(wedged(one.clutch, N).T)
    return T if np.isfinite(T) else math.inf

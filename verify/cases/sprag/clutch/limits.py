"""Limits of the torque of a sprag clutch: friction, pressure, yield, end of the profile."""

import math
from dataclasses import dataclass
from functools import lru_cache

from analytic.sprag.closure import wedged
from verify.cases.sprag.clutch.bodies import least_force
from verify.cases.sprag.clutch.model import built, grip
from verify.cases.sprag.inputs import SpragInputs

WORDS = {
    "slip": "the contacts slip",
    "pressure_inner": "the inner contacts reach p_lim",
    "pressure_outer": "the outer contacts reach p_lim",
    "yield_inner": "the inner race yields at its bore",
    "yield_outer": "the outer race yields at its bore",
    "end": "the sprags reach the end of their profile and roll over",
    "wide": "the half-width of a contact reaches 0.15 of its relative radius (end of the formulas)",
}


@dataclass(frozen=True)
class Limit:
    """A limit of the torque: key of its text in `WORDS`, and torque [N m]."""

    key: str
    at: float

    @property
    def words(self) -> str:
        return WORDS[self.key]


@lru_cache(maxsize=16)
def as_torque_grows(q: SpragInputs) -> tuple[Limit, ...]:
    """Limits of the torque, the smallest first; limits that no torque reaches are omitted."""
    one = built(q)
    alone = grip(q)
    found = {
        "slip": float(alone.slip), "end": float(alone.end_of_cam),
        "wide": float(wedged(one.clutch, one.N_top).T),
    }  # fmt: skip
    if q.p_lim is not None:
        for k, name in enumerate(("inner", "outer")):
            found[f"pressure_{name}"] = one.torque_at(q.p_lim, k)
    if q.R_p is not None:
        for k, name in enumerate(("inner", "outer")):
            N = least_force(q, k)
            found[f"yield_{name}"] = float(wedged(one.clutch, N).T) if one.N_top >= N else math.inf
    ordered = sorted((Limit(k, at) for k, at in found.items() if math.isfinite(at)), key=_place)
    return tuple(ordered)


def _place(limit: Limit) -> float:
    return limit.at

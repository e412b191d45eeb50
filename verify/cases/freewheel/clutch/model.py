"""Formulas of a roller freewheel under torque and axial load, with its limits and its scatter."""

import math
from functools import lru_cache
from typing import Any

import numpy as np

from analytic.freewheel import criterion, state, tilt
from verify.cases.freewheel.clutch.fem import off
from verify.cases.freewheel.clutch.inputs import ClutchInputs
from verify.cases.freewheel.clutch.limits import (
    allowed_shift,
    as_axial_load_grows,
    as_torque_grows,
    least_torque,
    under,
)
from verify.cases.freewheel.clutch.scatter import deviation, scatter, slopes
from verify.core.case import Values


@lru_cache(maxsize=8)
def analytic(q: ClutchInputs) -> Values:
    """SI values; those that the clutch does not have, or that are infinite, are left out."""
    alpha_0 = float(q.cam.alpha0)
    values = {"alpha_0": alpha_0, "mu_0": math.tan(alpha_0), "s(alpha_0)": deviation(q)}
    values |= {f"dalpha_0/d{s.name}": s.slope for s in slopes(q)}
    values |= {f"share {s.name}": s.share for s in slopes(q)}
    if q.T >= 0:
        values |= {f"T {limit.key}": limit.at for limit in as_torque_grows(q)}
        values["T bears"] = least_torque(q)
    values |= _loaded(q)
    if (ensemble := scatter(q)) is not None:
        values |= ensemble.values()
    return {key: float(value) for key, value in values.items() if np.isfinite(value)}


def turn(q: ClutchInputs) -> float:
    """dalpha(T)/dX [rad/m] between flats a few µm to either side; nan where there is none."""
    low, high = (float(state.loaded(q.moved(dX), q.T).alpha) for dX in (-off(q), off(q)))
    return (high - low) / (2 * off(q))


def _loaded(q: ClutchInputs) -> dict[str, Any]:
    now = under(q)
    if now is None:
        return {}
    F_a = q.F_ax / q.z
    mu_req = float(criterion.required_friction(alpha=now.alpha, T=q.T, F_ax=q.F_ax, R=q.cam.race))
    e = float(tilt.offset(F_a=F_a, F_n=now.N, r=q.r, alpha=now.alpha))
    peak = float(tilt.peak_factor(e=e, L=q.L)) if e < q.L / 2 else math.inf
    p_i, p_o = float(now.p_i), float(now.p_o)
    values = {
        "alpha": now.alpha, "N": now.N, "F_t": now.F_t, "F_a": F_a, "p_i": p_i,
        "p_o": p_o, "a_i": now.a_i, "a_o": now.a_o, "d_i": now.d_i, "d_o": now.d_o,
        "s": now.s, "phi": now.phi, "phi printed": now.phi_printed, "mu_req": mu_req,
        "safety": q.mu / mu_req, "e/L": e / q.L, "peak": peak, "dalpha/dX": turn(q),
        "p_end": max(p_i, p_o) * math.sqrt(peak),
    }  # fmt: skip
    values |= {f"F {limit.key}": limit.at for limit in as_axial_load_grows(q)}
    return values


def light(q: ClutchInputs, v: Values) -> str:
    """Class by the worst limit: "free", "green", "overloaded", "yellow" or "red".

    Red also where torque alone drives the rollers out, or where they are past the flats' corners;
    overloaded where friction holds and pressure or tilt is beyond its limit.
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
    return v.get("T corner", math.inf) < q.T


def overloaded(q: ClutchInputs, v: Values) -> bool:
    """Whether contacts, their ends included, press beyond p_lim, or the rollers tilt."""
    pressed = q.p_lim is not None and v.get("p_end", math.inf) > q.p_lim
    return pressed or v["e/L"] > allowed_shift(q)

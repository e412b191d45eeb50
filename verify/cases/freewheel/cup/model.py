"""Formulas of a drawn-cup roller clutch under torque, up to the summit of its torque.

An outer cam's roller moves towards psi = 0: alpha falls, and the torque z R_s N tan(alpha) has a
largest value before the rollers go through.
"""

from functools import lru_cache
from typing import Any

import numpy as np
from scipy.optimize import minimize_scalar

from analytic.freewheel.clutch import Clutch, Material
from analytic.freewheel.limits import Limits, limits
from analytic.freewheel.state import State, at_angle, at_normal_force, loaded
from verify.cases.freewheel.cup.inputs import CupInputs
from verify.core.case import Values

HARD = 4000e6  # Pa, what hardened rollers bear in static contact (ISO 76)
FRICTION = 0.1  # what oiled steel hardly exceeds
GIVEN = 0.25  # of the overlap at which rollers go through, at the angle that is given


@lru_cache(maxsize=8)
def clutch(q: CupInputs) -> Clutch:
    steel = Material(E=q.E, nu=q.nu)
    return Clutch(
        cam=q.cam, L=q.L, r_b=q.r_b, R_a=q.R_a, roller=steel, inner=steel, outer=steel
    )  # fmt: skip


@lru_cache(maxsize=8)
def bounds(q: CupInputs) -> Limits:
    """Torques at the clutch's limits."""
    return limits(clutch(q), mu=FRICTION, p_lim=HARD)


def rigid_normal_force(q: CupInputs) -> float:
    """N_0 [N] of a clutch that keeps its angle alpha_0."""
    return float(q.T / (q.z * q.R_s * np.tan(q.cam.alpha0)))


def given_angle(q: CupInputs) -> float:
    """The angle psi [rad] at which both approaches are `GIVEN` of what lets rollers through."""
    d = GIVEN * float(q.cam.pop_through) / 2
    return float(2 * q.cam.alpha(d_i=d, d_o=d))


@lru_cache(maxsize=8)
def at_summit(q: CupInputs) -> State:
    """The state with the largest torque."""
    whole, T = clutch(q), float(bounds(q).pop_through)
    if not np.isfinite(T):
        raise ValueError(
            "contacts are wider than half the rollers' radius before the torque has its summit: "
            f"α_0 = {np.degrees(float(q.cam.alpha0)):.4g}° is more than these formulas know"
        )
    N = float(loaded(whole, 0.99 * T).N)
    found = minimize_scalar(
        lambda N: -float(np.nan_to_num(at_normal_force(whole, N).T)), bounds=(N, 1.4 * N),
        method="bounded", options={"xatol": 1e-9 * N},
    )  # fmt: skip
    return at_normal_force(whole, found.x)


def analytic(q: CupInputs) -> Values:
    whole, N_0, top = clutch(q), rigid_normal_force(q), at_summit(q)
    under, same = loaded(whole, q.T), at_normal_force(whole, N_0)
    if not np.isfinite(under.N):
        raise ValueError(
            f"T = {q.T:g} N m is more than the largest torque, {float(top.T):.5g} N m: beyond it "
            "the rollers go through between shaft and cup"
        )
    given = at_angle(whole, given_angle(q))
    values: dict[str, Any] = {
        "alpha_0": q.cam.alpha0, "alpha": under.alpha, "N": under.N, "F_t": under.F_t,
        "F_t/N": np.tan(under.alpha), "s": under.s, "phi": under.phi,
        "phi printed": under.phi_printed, "d_i": under.d_i, "d_o": under.d_o, "a_i": under.a_i,
        "a_o": under.a_o, "p_i": under.p_i, "p_o": under.p_o, "one": 1.0, "N_0": N_0,
        "d_i at N": same.d_i, "d_o at N": same.d_o, "a_i at N": same.a_i, "a_o at N": same.a_o,
        "p_i at N": same.p_i, "p_o at N": same.p_o, "T at N": same.T, "N at angle": given.N,
        "T summit": top.T, "N summit": top.N, "alpha summit": top.alpha,
        "p summit": np.maximum(top.p_i, top.p_o), "through": q.cam.pop_through,
        "share": (top.d_i + top.d_o) / q.cam.pop_through,
    }  # fmt: skip
    return {key: float(value) for key, value in values.items()}

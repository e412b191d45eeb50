"""Formulas of the friction in a sprag clutch: what it asks for at rest, and what sliding bears.

Where one contact slides at a constant speed the two equations of the sprag (Eq. 14) leave N to
the blades alone. Driven, it is the inner one, T_i = mu N:

    N = K_r (alpha_max - alpha) / (h - b_i mu - b_e [(OA + b_i) mu - h]/(OB - b_e)),

which grows without end as mu comes near what rest asks for. Where the race overruns the outer
contact would have to bear more, slides with T_e = -mu N, and the sprags go round with the race.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from verify.cases.sprag.engagement.formulas import MORE, at_rest, swing, with_torque
from verify.cases.sprag.engagement.formulas import asked as asked_at
from verify.cases.sprag.engagement.model import Wedge, wedge
from verify.cases.sprag.inputs import EngagementInputs

WEAK = 0.04  # of the blades' stiffness: springs that let the sprags slip at the start
BELOW = 0.9  # of tan(nu_0), the friction with which they slide for ever


def asked(q: EngagementInputs, factor: float = 1.0) -> tuple[float, float]:
    """T_i/N that rest under `factor` times the torque asks for, and tan(nu) there."""
    p = with_torque(q, factor)
    w = wedge(p)
    rest = at_rest(w, p.T)
    if math.isnan(rest):
        return math.nan, math.nan
    return asked_at(w, rest), float(np.tan(np.interp(rest, w.theta, w.states.nu)))


@dataclass(frozen=True)
class Sliding:
    """N [N] of a sprag that slides, T_i/N, and whether it does so on the outer race."""

    N: float
    share: float
    outside: bool


def sliding(w: Wedge, mu: float) -> Sliding:
    """The state with friction `mu` at the contact that slides, negative where the race overruns.

    The contact slides that otherwise would have to bear more than friction. Where both would, for
    |mu| below h/2 over OC_g, there is no such state, and N is nan.
    """
    q, now = w.q, w.states
    h = now.h_i - now.h_e
    inner, outer = np.full_like(h, mu), ((now.OA + now.b_i) * mu - h) / (now.OB - now.b_e)
    outside = bool(np.abs(outer[0]) > abs(mu))
    if outside:
        outer = np.full_like(h, np.copysign(mu, outer[0]))
        inner = ((now.OB - now.b_e) * outer + h) / (now.OA + now.b_i)
        if abs(inner[0]) > abs(mu):
            return Sliding(math.nan, math.nan, outside)
    left = now.N * (h - now.b_i * inner - now.b_e * outer) - q.K_r * (q.alpha_max - now.alpha)
    if left[-1] <= 0:
        return Sliding(math.nan, math.nan, outside)
    N = float(brentq(lambda N: float(np.interp(N, now.N, left)), 0.0, now.N[-1]))
    return Sliding(N, float(np.interp(N, now.N, inner)), outside)


def weak(q: EngagementInputs, factor: float = 1.0) -> EngagementInputs:
    """The same clutch with weak springs under `factor` times the torque."""
    return with_torque(q, factor).model_copy(update={"K_r": WEAK * q.K_r})


def analytic(q: EngagementInputs) -> Mapping[str, float]:
    """Values in SI units; what has no answer is left out."""
    w = wedge(q)
    mu, tan = asked(q)
    below = BELOW * math.tan(q.nu_0)
    slides, overruns = sliding(w, below), sliding(w, -q.mu_s)
    values = {
        "mu_b": mu, "tan": tan, "mu_b/tan": mu / tan, "tan_0": math.tan(q.nu_0),
        "mu_s/mu_b": q.mu_s / mu, "mu_c/mu_b": q.mu_c / mu,
        "N slides": slides.N, "N overruns": overruns.N,
        "drag": -q.z * q.R_i * overruns.share * overruns.N,
        "T slides": q.z * q.R_i * slides.share * slides.N,
        "unequal": float((w.states.N_e / np.maximum(w.states.N, 1e-300))[-1]) - 1,
        "N_max": swing(q).peak[1], "t_max": swing(q).peak[0],
        "N_max more": swing(with_torque(q, MORE)).peak[1],
        "asked": float(np.tan(np.interp(swing(q).peak[1], w.states.N, w.states.nu))),
        "over": float(swing(q).over),
    }  # fmt: skip
    return {key: value for key, value in values.items() if math.isfinite(value)}

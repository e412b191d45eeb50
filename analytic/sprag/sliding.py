"""Sprags that slide permanently: their forces, and the contact that slides.

If one contact slides at a constant speed, N follows from the two equations of the sprag (Eq. 14)
and the moment of the energizing springs. If the clutch is driven, the inner contact slides with
T_i = mu N:

    N = K_r (alpha_max - alpha) / (h - b_i mu - b_e [(OA + b_i) mu - h]/(OB - b_e)).

N increases without limit as mu approaches the required friction coefficient at rest. If the race
overruns, the outer contact requires more friction than the inner contact. Therefore, the outer
contact slides with T_e = -mu N, and the sprags rotate with the inner race.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from analytic.sprag.race_spring import RaceSpring


@dataclass(frozen=True)
class Sliding:
    """Normal force N [N] of a sliding sprag, ratio T_i/N, and whether the outer contact slides."""

    N: float
    share: float
    outside: bool


def sliding(w: RaceSpring, mu: float) -> Sliding:
    """Steady state with the friction `mu` at the sliding contact; mu < 0 if the race overruns.

    The contact slides whose friction force would otherwise exceed mu N. If this applies to both
    contacts (|mu| below h/(2 OC_g)), no such state exists, and N is nan.
    """
    blades, now = w.blades, w.states
    h = now.h_i - now.h_e
    inner, outer = np.full_like(h, mu), ((now.OA + now.b_i) * mu - h) / (now.OB - now.b_e)
    outside = bool(np.abs(outer[0]) > abs(mu))
    if outside:
        outer = np.full_like(h, np.copysign(mu, outer[0]))
        inner = ((now.OB - now.b_e) * outer + h) / (now.OA + now.b_i)
        if abs(inner[0]) > abs(mu):
            return Sliding(math.nan, math.nan, outside)
    arm = h - now.b_i * inner - now.b_e * outer
    left = now.N * arm - blades.K_r * (blades.alpha_max - now.alpha)
    if left[-1] <= 0:
        return Sliding(math.nan, math.nan, outside)
    N = float(brentq(lambda N: float(np.interp(N, now.N, left)), 0.0, now.N[-1]))
    return Sliding(N, float(np.interp(N, now.N, inner)), outside)

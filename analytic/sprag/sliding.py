"""Sprags that slide permanently: their forces, and which contact slides.

If one contact slides at a constant speed, N follows from the two equations of the sprag (Eq. 14)
and the moment of the blades. If the clutch is driven, the inner contact slides, T_i = mu N:

    N = K_r (alpha_max - alpha) / (h - b_i mu - b_e [(OA + b_i) mu - h]/(OB - b_e)),

which grows without limit if mu approaches the friction required at rest. If the race overruns, the
outer contact has the larger required friction and slides with T_e = -mu N, and the sprags rotate
with the race.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from analytic.sprag.race_spring import RaceSpring


@dataclass(frozen=True)
class Sliding:
    """N [N] of a sliding sprag, T_i/N, and whether the outer contact slides."""

    N: float
    share: float
    outside: bool


def sliding(w: RaceSpring, mu: float) -> Sliding:
    """State with the friction `mu` at the sliding contact; mu is negative if the race overruns.

    The contact slides that would otherwise have to transmit more than friction. If this applies to
    both contacts (|mu| below h/2 over OC_g), no such state exists, and N is nan.
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

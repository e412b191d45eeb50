"""What formulas say of a crown before any engagement: the load that it suits, statics."""

from functools import lru_cache

import numpy as np

from analytic.contact import crown
from verify.cases.sprag.clutch.model import built, mid, under
from verify.cases.sprag.engagement.model import crowned_for
from verify.cases.sprag.optimum.inputs import OptimumInputs


@lru_cache(maxsize=16)
def analytic(q: OptimumInputs) -> dict[str, float]:
    """SI values; those of a state under the torque are left out where there is none."""
    one, Q, now = built(q), crowned_for(q), under(q)
    A = q.K_1 * Q / (np.pi * q.l * float(one.parts.E_star))
    found = {
        "Q": Q, "K_1 Q": q.K_1 * Q, "A": A, "z_end": float(one.gap[0]),
        "straight": float(crown.straight_length(K_2=q.K_2, length=q.l)),
        "designs": float(q.levels**3),
    }  # fmt: skip
    if now is None:
        return found
    N = float(now.N)
    inner, _ = one.pressed(N)
    return found | {
        "N": N, "mu_req": float(np.tan(now.nu)), "static mid": mid(inner),
        "static peak": float(inner.peak_pressure.max()),
        "static end": float(inner.peak_pressure[0]),
    }  # fmt: skip

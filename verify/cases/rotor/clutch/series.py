"""How struts' stiffness goes with wedge angle, yield and offset, for fits."""

import math

import numpy as np

from verify.cases.rotor.clutch.fem import ANGLES, HARD, SMALL, STIFFER
from verify.core.case import Context

Points = tuple[list[float], list[float], list[float]]


def over_angle(context: Context) -> Points:
    """What Eq. 3 leaves out over sin ν, at the same normal forces."""
    K, v = context.fem[-1].arrays["K_xx over nu"], context.analytic
    sines = [math.sin(share * context.inputs.nu) for share in ANGLES]
    return sines, (HARD * v["K_xx"] / K - 1).tolist(), [1e-13] * len(sines)


def over_yield(context: Context) -> Points:
    """1 - struts/formula over how much the contacts yield, delta_0/l, ends held in both races."""
    K, q, v = context.fem[-1].arrays["K_zz over yield, pinned"], context.inputs, context.analytic
    eps = [v["delta_0"] / s / (q.R_e - q.R_i) for s in reversed(STIFFER)]
    d = (1 - K / (v["K_zz"] * np.array(STIFFER)))[::-1]
    return eps, d.tolist(), [1e-13] * len(eps)


def over_offset(context: Context) -> Points:
    """First-order coupling over that of struts, Eq. 3 corrected in both, over dx/delta_0.

    The term after the one that is fitted counts as uncertainty, beside round-off: the coupling is
    what little is left of entries that cancel.
    """
    K, q, v = context.fem[-1].arrays["K_xz over small offsets"], context.inputs, context.analytic
    formula = v["K_xz, first order"] * np.array(SMALL) * v["delta_0"] / q.e
    d = formula / math.cos(q.nu) ** 2 / K - 1
    return list(SMALL), d.tolist(), [1e-13 / eps + eps**4 for eps in SMALL]

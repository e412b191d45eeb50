"""Reference of a sprag clutch: strips, numerical profiles, computed engagements."""

import math
from typing import Any

import numpy as np

from analytic.contact.strips import Strips
from analytic.sprag.closure import wedged
from analytic.sprag.drawn import Touching
from verify.case import Level, solved
from verify.cases.sprag.clutch.drawn_fem import crowned, drawn, places
from verify.cases.sprag.clutch.model import (
    HALF,
    built,
    fast,
    grip,
    literal,
    low_friction,
    normal_force,
    rigid,
    under,
)
from verify.cases.sprag.clutch.paper_fem import paper_fem
from verify.cases.sprag.engagement.model import in_strips
from verify.core.figures import Array

POINTS = 2  # points of the drawn spiral per radian, over the number of strips


def solve(q: Any, level: int) -> Level:
    """Results of one level: `level` strips, and 2 `level` points per radian of the profile."""
    now = under(q)
    assert now is not None  # refused without an equilibrium
    one = drawn(q, POINTS * level)
    found = one.at_torque(q.T, float(now.N))
    values = {
        "N": found.N, "alpha": found.alpha, "mu_req": float(np.tan(found.nu)),
        "H": sum(one.yields(found.N).values()),
    }  # fmt: skip
    values |= others(q, level, found)
    arrays: dict[str, Array] = {}
    for contact, name in enumerate("io"):
        half = by_strips(q, level, HALF * found.N, contact)
        values |= {f"p_{name}_mid_half": float(half.mid), f"p_{name}_half": float(half.peak)}
        arrays[f"strips, {name}"] = by_strips(q, level, found.N, contact).pressure
    arrays["strips, y"] = places(q, level)
    if level == q.levels[-1] and q.is_default:
        arrays |= paper_fem()
    return solved(1 / level, iteration={"N": 1e-12}, **values, **arrays)


def others(q: Any, level: int, found: Touching) -> dict[str, float]:
    """Values by numerical profiles: rolling, rigid races, printed Eqs. 9 and 10, two variants.

    The formulas supply the search intervals; the roots do not depend on these intervals.
    """
    points, steps = POINTS * level, level // 2
    one = drawn(q, points)
    values = {"theta": one.rolled(found.N, steps)}
    if math.isfinite(near := normal_force(rigid(q))):
        stiff = drawn(q, points, rigid=True)
        liu = stiff.at_torque(q.T, near)
        values |= {
            "N_Liu": liu.N, "alpha_Liu": liu.alpha, "theta_Liu": stiff.rolled(liu.N, steps)
        }  # fmt: skip
    if math.isfinite(near := normal_force(literal(q))):
        as_printed = drawn(q, points, printed=True).at_torque(q.T, near)
        values["alpha_printed"] = as_printed.alpha
    if q.is_default:
        mu = low_friction(q)
        near = float(grip(q.model_copy(update={"mu_s": mu})).slip) / (q.z * q.R_i * mu)
        quick = drawn(fast(q), points)
        state = quick.at_torque(q.T, found.N)
        values |= {
            "T_slip_low": one.at_friction(mu, near).T, "d_ce_fast": quick.grown(),
            "alpha_fast": state.alpha, "theta_fast": quick.rolled(state.N, steps),
        }  # fmt: skip
    return values


def by_strips(q: Any, n: int, N: float, contact: int) -> Strips:
    """Contact by n strips at the inner (0) or outer (1) race; N [N] acts on the inner race."""
    one = built(q)
    now = wedged(one.clutch, N)
    load = N if contact == 0 else float(now.N_e)
    return in_strips(q, crowned(q, n), one.radii(now)[contact], load)

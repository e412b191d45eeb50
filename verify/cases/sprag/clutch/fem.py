"""What stands beside the formulas of a sprag clutch: strips, drawn sprags, compiled engagements."""

from typing import TYPE_CHECKING

import numpy as np

from analytic.sprag.closure import wedged
from verify.cases.sprag.clutch.drawn_fem import Drawn, Touching, crowned, places
from verify.cases.sprag.clutch.model import HALF, built, under
from verify.cases.sprag.clutch.paper_fem import paper_fem
from verify.cases.sprag.clutch.values import analytic
from verify.cases.sprag.clutch.variants import fast
from verify.cases.sprag.inputs import EngagementInputs
from verify.core.case import FemResult
from verify.core.figures import Array

if TYPE_CHECKING:
    from analytic.contact.strips import Strips

LEVELS = (41, 81, 161)  # strips along a sprag
POINTS = 2  # of the drawn spiral on a radian, over the strips' number


def fem(q: EngagementInputs, level: int) -> FemResult:
    now = under(q)
    assert now is not None  # refused where there is none
    drawn = Drawn(q, POINTS * level)
    found = drawn.at_torque(q.T, float(now.N))
    values = {
        "N": found.N, "alpha": found.alpha, "nu": found.nu, "mu_req": float(np.tan(found.nu)),
        "H": sum(drawn.yields(found.N).values()),
    }  # fmt: skip
    values |= others_fem(q, level, found)
    arrays: dict[str, Array] = {}
    for name, key in (("i", 0), ("o", 1)):
        half = by_strips_fem(q, level, HALF * found.N, key)
        values |= {f"p_{name} mid, half": float(half.mid), f"p_{name} peak, half": float(half.peak)}
        arrays[f"strips, {name}"] = by_strips_fem(q, level, found.N, key).pressure
    arrays["strips, y"] = places(q, level)
    if level == LEVELS[-1] and q == EngagementInputs():
        arrays |= paper_fem()
    return FemResult(h=1 / level, values=values, u_it={"N": 1e-12 * found.N}, arrays=arrays)


def others_fem(q: EngagementInputs, level: int, found: Touching) -> dict[str, float]:
    """By drawing: rolling, rigid races (Liu), Eqs. 9 and 10 as printed, and the two variants."""
    v, points, steps = analytic(q), POINTS * level, level // 2
    one = Drawn(q, points)
    values = {"theta": one.rolled(found.N, steps)}
    if "N Liu" in v:
        stiff = Drawn(q, points, rigid=True)
        liu = stiff.at_torque(q.T, v["N Liu"])
        rigid = {"N Liu": liu.N, "alpha Liu": liu.alpha, "theta Liu": stiff.rolled(liu.N, steps)}
        values |= rigid
    if "N printed" in v:
        literal = Drawn(q, points, printed=True).at_torque(q.T, v["N printed"])
        values["alpha printed"] = literal.alpha
    if "T slip low" in v:
        near = v["T slip low"] / (q.z * q.R_i * v["mu low"])
        quick = Drawn(fast(q), points)
        state = quick.at_torque(q.T, found.N)
        values |= {
            "T slip low": one.at_friction(v["mu low"], near).T, "d_ce fast": quick.grown(),
            "alpha fast": state.alpha, "theta fast": quick.rolled(state.N, steps),
        }  # fmt: skip
    return values


def by_strips_fem(q: EngagementInputs, n: int, N: float, contact: int) -> "Strips":
    """The inner (0) or outer (1) contact by n strips under its own share of N [N]."""
    from analytic.contact import strips

    one = built(q)
    now = wedged(one.clutch, N)
    load = N if contact == 0 else float(now.N_e)
    return strips.press(crowned(q, n), length=q.l, R=one.radii(now)[contact],
                        E_star=float(one.parts.E_star), load=load)  # fmt: skip

"""Reference of a crown: numerical profiles, strips, computed engagements."""

from typing import Any

import numpy as np

from verify.case import Level, solved
from verify.cases.sprag.clutch.drawn_fem import crowned
from verify.cases.sprag.clutch.reference import by_strips
from verify.cases.sprag.clutch.run_fem import run_fem
from verify.cases.sprag.crown.box_fem import FEW, SHARES, box_fem
from verify.cases.sprag.crown.formulas import DEEP, factorial
from verify.cases.sprag.crown.paper_fem import paper_fem
from verify.cases.sprag.peaks import peaks_fem, with_crown

POINTS = 1200  # points of a drawn profile per strip
STEP = 1e-3  # relative step of z_m, for its share
ROUNDED = {"mean": 1e-12, "share": 1e-9}  # relative round-off by the number of terms and by STEP


def solve(q: Any, level: int) -> Level:
    """Results of one level: `level` strips, and a profile with 1200 points per strip."""
    run = run_fem(q)
    N = run.engagement.N_max
    own = by_strips(q, level, N, 0)
    values = {"N_max": N, "p_mid_peak": float(own.mid)} | drawn(q, POINTS * level)
    arrays = {"strips": own.pressure}
    if q.is_default:
        for k, crown in enumerate(DEEP):
            found = by_strips(with_crown(q, crown), level, N, 0)
            values[f"p_peak_deep_{k}"] = float(found.peak)
    if level == q.levels[-1]:
        shares = SHARES if q.is_default else (1.0,)
        few = peaks_fem(q, factorial(q, FEW), q.T * np.array(shares))
        arrays |= box_fem(q, few.of(shares.index(1.0)))
        if q.is_default:
            arrays |= paper_fem(q, few)
    return solved(1 / level, iteration=ROUNDED, **values, **arrays)


def drawn(q: Any, n: int) -> dict[str, float]:
    """Mean drop [m] of a profile of n points, and its increase in per cent for 1 % more z_m."""

    def mean(step: float) -> float:
        return float(crowned(q.model_copy(update={"z_m": q.z_m * (1 + step)}), n).mean())

    near, far = ((mean(h) - mean(-h)) / (2 * h) for h in (STEP, 2 * STEP))
    return {"mean": mean(0.0), "share": (4 * near - far) / 3 / mean(0.0)}

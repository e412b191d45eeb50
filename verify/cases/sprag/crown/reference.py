"""What stands beside the formulas of a crown: drawn profiles, strips, compiled engagements."""

import numpy as np

from verify.cases.sprag.clutch.drawn_fem import crowned
from verify.cases.sprag.clutch.reference import by_strips
from verify.cases.sprag.clutch.run_fem import run_fem
from verify.cases.sprag.crown.box_fem import FEW, SHARES, box_fem
from verify.cases.sprag.crown.formulas import DEEP, factorial, label
from verify.cases.sprag.crown.paper_fem import paper_fem
from verify.cases.sprag.inputs import EngagementInputs
from verify.cases.sprag.peaks import peaks_fem, with_crown
from verify.core.case import FemResult

LEVELS = (41, 81, 161)  # strips along a sprag
POINTS = 1200  # of a drawn profile for each strip
STEP = 1e-3  # of z_m, for its share
ROUNDED = {"mean": 1e-12, "share": 1e-9}  # of themselves, by so many terms and that step


def fem(q: EngagementInputs, level: int) -> FemResult:
    run = run_fem(q)
    N = run.engagement.N_max
    own = by_strips(q, level, N, 0)
    values = {"N_max": N, "p mid peak": float(own.mid)} | drawn_fem(q, POINTS * level)
    arrays = {"strips": own.pressure}
    paper = q == EngagementInputs()
    if paper:
        for crown in DEEP:
            found = by_strips(with_crown(q, crown), level, N, 0)
            values[f"{label(crown)} p"] = float(found.peak)
    if level == LEVELS[-1]:
        shares = SHARES if paper else (1.0,)
        few = peaks_fem(q, factorial(q, FEW), q.T * np.array(shares))
        arrays |= box_fem(q, few.of(shares.index(1.0)))
        if paper:
            arrays |= paper_fem(q, few)
    u_it = {key: share * values[key] for key, share in ROUNDED.items()}
    return FemResult(h=1 / level, values=values, u_it=u_it, arrays=arrays)


def drawn_fem(q: EngagementInputs, n: int) -> dict[str, float]:
    """Mean of the drop [m] at n places of the sprag, and by how many per cent one of z_m adds."""

    def mean(step: float) -> float:
        return float(crowned(q.model_copy(update={"z_m": q.z_m * (1 + step)}), n).mean())

    near, far = ((mean(h) - mean(-h)) / (2 * h) for h in (STEP, 2 * STEP))
    return {"mean": mean(0.0), "share": (4 * near - far) / 3 / mean(0.0)}

"""Definition search: what the garbled Eqs. 3 and 5 give under every reading of their symbols."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

from analytic.spring.garbled import SIGNS, flexibility
from verify.core.case import Context
from verify.core.figures import Table
from verify.papers.digits import half_last_digit
from verify.papers.ledger import published

LEAVES = {"L_1/sin α": 1.0, "2 L_1/sin α": 2.0}
OFFSETS = {"r + b/2": (1.0, "b"), "r + b": (2.0, "b"), "r": (0.0, "b"), "r + h/2": (1.0, "h")}
RADII = ("r", "r + b/2")
STARTS = {"F (L_1/2 + r)": 1.0, "F L_1/2": 0.0}


@dataclass(frozen=True)
class Reading:
    """One reading of the equations and the stiffness [N/m] it gives."""

    leaf: str
    offset: str
    radius: str
    signs: str
    start: str
    k: float

    @property
    def is_adopted(self) -> bool:
        """The reading of `analytic.spring.energy`."""
        return (self.leaf, self.offset, self.radius, self.signs, self.start) == (
            "L_1/sin α", "r + b/2", "r", "alternating", "F (L_1/2 + r)",
        )  # fmt: skip


def search(q: Any) -> list[Reading]:
    """All readings, by direct quadrature of the printed moments."""
    found = []
    for leaf, offset, radius, signs, start in product(LEAVES, OFFSETS, RADII, SIGNS, STARTS):
        r = q.r if radius == "r" else q.r + q.b / 2
        halves, thickness = OFFSETS[offset]
        inner = q.r + halves * (q.b if thickness == "b" else q.h) / 2
        L2 = LEAVES[leaf] * q.L1 / math.sin(q.alpha) + 2 * inner / math.tan(q.alpha)
        f = flexibility(q.n, q.L1 / 2, r, L2, q.alpha, signs, STARTS[start])
        found.append(Reading(leaf, offset, radius, signs, start, q.E * q.h * q.b**3 / 12 / f))
    return found


def tables(context: Context) -> Sequence[Table]:
    """The readings nearest to the printed value first; only for the paper's own numbers."""
    if not context.is_paper:
        return ()
    entry = published("wang2023:k1-theory")
    half_digit = half_last_digit(entry.printed)
    readings = sorted(search(context.inputs), key=lambda x: abs(x.k / 1e3 - entry.value))
    meet = [x for x in readings if abs(x.k / 1e3 - entry.value) <= half_digit]
    rows = tuple(
        (x.leaf, x.offset, x.radius, x.signs, x.start, round(x.k / 1e3, 5),
         "yes" if x in meet else "", "adopted" if x.is_adopted else "")
        for x in readings
    )  # fmt: skip
    return (
        Table(
            title=f"Readings of Eqs. 3 and 5: {len(meet)} of {len(readings)} give the printed "
            f"{entry.printed} N/mm",
            header=("leaf in L_2", "radius in L_2", "arc radius", "signs", "first couple",
                    "k_1 [N/mm]", "printed digits met", ""),
            rows=rows,
            note="Statics (M = F y with matching ends) settles the signs, the first couple and "
            "half of L_1 in L_2. It does not settle the radius: with r in the arcs and r + b/2 in "
            "L_2, as printed but for h in place of b, the loops end b cos α apart; closed loops "
            "need r or r + b/2 throughout (0.60320 or 0.58202 N/mm). What is adopted is the "
            "printed text with h read as b.",
        ),
    )  # fmt: skip

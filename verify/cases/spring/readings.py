"""Definition search: what the garbled Eqs. 3 and 5 give under every reading of their symbols."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np

from verify.core.case import Context
from verify.core.figures import Table
from verify.papers.digits import half_last_digit
from verify.papers.ledger import published

LEAVES = {"L_1/sin α": 1.0, "2 L_1/sin α": 2.0}
OFFSETS = {"r + b/2": (1.0, "b"), "r + b": (2.0, "b"), "r": (0.0, "b"), "r + h/2": (1.0, "h")}
RADII = ("r", "r + b/2")
SIGNS = ("alternating", "all plus", "M_2 as printed")
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


def flexibility(
    n: int,
    a: float,
    r: float,
    L2: float,
    alpha: float,
    signs: str,
    start: float,
    ends: tuple[float, float] = (math.pi / 2, math.pi / 2),
) -> float:
    """Integral of (M/F)^2 along the spring with the chosen signs and first couple.

    `ends` are the angles [rad] over which the arcs of head and tail are taken.
    """
    t, w = np.polynomial.legendre.leggauss(24)
    t, w = (t + 1) / 2, w / 2

    def over(length: float, moment: Any) -> float:
        return float(length * (w @ np.square(moment)))

    head, tail, angle, x = ends[0] * t, ends[1] * t, alpha * t, L2 * t
    total = over(a, a * t) + over(r * ends[0], a + r * np.sin(head))
    T, A = a + start * r, r * (1 - math.cos(alpha))
    for i in range(2, n):
        s = 1.0 if signs == "all plus" or i % 2 else -1.0
        total += over(r * alpha, T + s * r * (1 - np.cos(angle)))
        if signs == "M_2 as printed":  # the sign stands before T and the arc's share, not F x
            total += over(L2, x * math.sin(alpha) + s * (T + A))
        else:
            total += over(L2, T + s * (A + x * math.sin(alpha)))
        top = T + s * (A + L2 * math.sin(alpha))
        total += over(r * alpha, top + s * r * (np.cos(alpha - angle) - math.cos(alpha)))
        T = top + s * A
    return total + over(r * ends[1], T - r * (1 - np.cos(tail)))

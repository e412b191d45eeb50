"""Search of readings: results of the misprinted Eqs. 3 and 5 for every reading of their symbols."""

from collections.abc import Sequence
from typing import Any

from analytic.spring.garbled import Reading, readings
from verify.core.case import Context
from verify.core.figures import Table
from verify.papers.digits import half_last_digit
from verify.papers.ledger import published


def search(q: Any) -> list[Reading]:
    """Results of Eqs. 3 and 5 in all readings, for the inputs `q`."""
    return readings(n=q.n, b=q.b, h=q.h, r=q.r, L1=q.L1, alpha=q.alpha, E=q.E)


def tables(context: Context) -> Sequence[Table]:
    """Table of the readings, sorted by distance from the printed value; for the paper only."""
    if not context.is_paper:
        return ()
    entry = published("wang2023:k1-theory")
    half_digit = half_last_digit(entry.printed)
    nearest = sorted(search(context.inputs), key=lambda x: abs(x.k / 1e3 - entry.value))
    meet = [x for x in nearest if abs(x.k / 1e3 - entry.value) <= half_digit]
    rows = tuple(
        (x.leaf, x.offset, x.radius, x.signs, x.start, round(x.k / 1e3, 5),
         "yes" if x in meet else "", "adopted" if x.is_adopted else "")
        for x in nearest
    )  # fmt: skip
    return (
        Table(
            title=f"Readings of Eqs. 3 and 5 that give the printed k_1: {len(meet)} of "
            f"{len(nearest)} ({entry.printed} N/mm)",
            header=("leaf in L_2", "radius in L_2", "arc radius", "signs", "first couple T_1",
                    "k_1 [N/mm]", "equal to printed digits", ""),
            rows=rows,
            note="The bending moment is F y, with the distance y from the line of force, and is "
            "continuous between the segments. This determines the signs, the first couple T_1, and "
            "the factor 1/2 of L_1 in L_2, but not the radius. The printed text has r in the arcs "
            "and r + h/2 in L_2. With b instead of h, the loops have gaps of b cos α. Closed loops "
            "require r everywhere (0.60320 N/mm) or r + b/2 everywhere (0.58202 N/mm). The adopted "
            "reading is the printed text with b instead of h.",
        ),
    )  # fmt: skip

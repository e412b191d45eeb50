"""Sixteen readings of the paper's spring, compared with Eq. 10.

The paper does not state the supports of head and tail, the radius of the arcs (r or r + b/2), or
by how much the width of its shell model increases the stiffness. A reading is chosen only by k_1.
Its k_2 and point A are then predictions, but have the status CALIBRATED.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import product
from typing import Any

from analytic.spring.lines import Lines
from analytic.spring.loops import Tail
from analytic.spring.stages import Head, Stages, stages
from verify.cases.spring.claims import left_open
from verify.cases.spring.inputs import strip_of
from verify.cases.spring.stages.inputs import StagesInputs
from verify.core.case import Context
from verify.core.figures import Table
from verify.judging.checks import Margin
from verify.judging.judge import expanded
from verify.papers.ledger import published

MET = 0.01  # accepted relative difference of k_1 from the printed value
ACCEPTED = 0.05  # tolerances of k_2 and the crossing
EQ10_END = 16.85e-3  # m: 11 N, the end of the tests, on the second line
FITTED = "calibrated: of sixteen readings, this one has the k_1 nearest to the printed k_1"
LOOSE = "valid in linear theory only: this spring buckles near 1 N, see case spring-buckling"
N_PER_MM, mm = 1e3, 1e-3


@dataclass(frozen=True)
class Reading:
    """One reading of the paper's spring, with the stages [SI] that it gives."""

    tail: Tail
    head: Head
    radius: str
    strip: str
    factor: float
    stages: Stages
    k1: float
    k2: float
    U_A: float
    F_A: float

    @property
    def off(self) -> float:
        """Relative deviation of k_1 from Eq. 10."""
        return self.k1 / eq10().k1 - 1

    def __str__(self) -> str:
        return f"tail clamped at {self.tail}, head {self.head}, {self.radius}, {self.strip}"


def _entries() -> tuple[tuple[float, float], ...]:
    """Values and standard uncertainties [SI] of the constants of Eq. 10."""
    found = []
    for name, factor in (("k1-fea", N_PER_MM), ("eq10-oa-intercept", 1.0), ("k2-fea", N_PER_MM),
                         ("eq10-ab-intercept", 1.0)):  # fmt: skip
        entry = published(f"wang2023:{name}")
        found.append((entry.value * factor, (entry.standard_uncertainty or 0.0) * factor))
    return tuple(found)


@cache
def eq10() -> Lines:
    """Both lines of Eq. 10 as printed [SI]."""
    return Lines(*(value for value, _ in _entries()))


def uncertainties() -> dict[str, float]:
    """Standard uncertainties [SI] of the values of Eq. 10 due to its printed digits."""
    u = [u for _, u in _entries()]
    U, F = eq10().spread(*u)
    return {"k1": u[0], "k2": u[2], "U": U, "F": F}


def readings(q: StagesInputs) -> list[Reading]:
    """Sixteen readings of tail, head, radius and strip; 24 if a width factor is given."""
    strips = [("E I", 1.0), ("E I/(1 − ν²)", q.widest)]
    if q.width_factor is not None:
        strips.append((f"{q.width_factor:.5g} E I", q.width_factor))
    found = []
    for (tail, head, radius, path), (strip, factor) in product(left_open(q), strips):
        s = stages(**path, **strip_of(q), width_factor=factor, head=head, tail=tail)
        numbers = {key: float(getattr(s, key)) for key in ("k1", "k2", "U_A", "F_A")}
        found.append(Reading(tail, head, radius, strip, factor, s, **numbers))
    return found


def meeting(q: StagesInputs) -> list[Reading]:
    """Readings whose k_1 differs by at most 1 % from the printed k_1; the nearest first."""
    near = sorted(readings(q), key=lambda x: abs(x.off))
    return [x for x in near if abs(x.off) <= MET]


def chosen(q: StagesInputs) -> Reading:
    """Reading whose k_1 is nearest to Eq. 10; a width factor in the inputs is not used."""
    return min(readings(q.model_copy(update={"width_factor": None})), key=lambda x: abs(x.off))


def keeps(key: str, figure: float) -> Margin:
    """Function that returns a positive margin if a value differs from Eq. 10 by less than `figure`.

    The difference is that of k1, k2, U or F (`key`) of the reading whose k_1 is
    nearest to Eq. 10.
    """

    def margin(context: Context) -> tuple[float, float, str]:
        reading, printed = chosen(context.inputs), float(getattr(eq10(), key))
        off = float(getattr(reading, {"U": "U_A", "F": "F_A"}.get(key, key))) / printed - 1
        words = f"difference from the printed value {off:+.1%}, {figure:.0%} accepted ({reading}"
        words += f"; {LOOSE})" if reading.head == "free" else ")"
        return (figure - abs(off)) * printed, expanded(0.0, uncertainties()[key]), words

    return margin


def tables(q: StagesInputs, context: Context) -> Sequence[Table]:
    """Table of all readings; for the paper's spring, also differences from Eq. 10 and the tests."""
    test = {name: published(f"wang2023:{name}-test").value * N_PER_MM for name in ("k1", "k2")}
    rows = []
    for x in readings(q):
        row: tuple[Any, ...] = (x.tail, x.head, x.radius, x.strip, round(x.k1 / N_PER_MM, 4),
               round(x.U_A / mm, 3), round(x.F_A, 3), round(x.k2 / N_PER_MM, 4))  # fmt: skip
        if context.is_paper:
            row += (percent(x.off), percent(x.U_A / eq10().U - 1), percent(x.F_A / eq10().F - 1),
                    percent(x.k2 / eq10().k2 - 1), percent(x.k1 / test["k1"] - 1),
                    percent(x.k2 / test["k2"] - 1), "yes" if abs(x.off) <= MET else "")  # fmt: skip
        rows.append(row)
    header: tuple[str, ...] = ("tail clamped at", "head", "arc radius", "strip", "k_1 [N/mm]",
                               "U_A [mm]", "F_A [N]", "k_2 [N/mm]")  # fmt: skip
    title = "Stages OA and AB for all readings that the paper leaves open"
    if not context.is_paper:
        return (Table(title=title, header=header, rows=tuple(rows), note=NOTE),)
    header += ("k_1, Eq. 10", "U_A", "F_A", "k_2", "k_1, test", "k_2, test", "k_1 within 1 %")
    return (Table(title=f"{title}, with differences from Eq. 10 and the tests", header=header,
                  rows=tuple(rows), note=f"{predictions(q)} {NOTE}"),)  # fmt: skip


NOTE = (
    "All values by linear theory. Point A is the first contact of a tip, k_2 the slope beyond A. "
    "If the tail is clamped at mid-leaf, both tips touch; if the tail is clamped at its arc, only "
    "the tip of the head touches. U_A does not depend on the width factor; k_1, F_A and k_2 are "
    "proportional to the width factor."
)


def predictions(q: StagesInputs) -> str:
    """Text: readings that give the printed k_1, and deviations of U_A, F_A and k_2 from Eq. 10."""
    found = meeting(q)
    if not found:
        return f"No reading gives the printed k_1 within {MET:.0%}."
    names = "; ".join(
        f"{x}: k_1 {x.off:+.1%}, U_A {x.U_A / eq10().U - 1:+.1%}, F_A {x.F_A / eq10().F - 1:+.1%}, "
        f"k_2 {x.k2 / eq10().k2 - 1:+.1%}"
        for x in found
    )
    return (
        f"Printed: k_1 = {eq10().k1 / N_PER_MM:.3f} N/mm, k_2 = {eq10().k2 / N_PER_MM:.3f} N/mm; "
        f"the lines intersect at U = {eq10().U / mm:.2f} mm, F = {eq10().F:.2f} N. Readings with "
        f"k_1 within {MET:.0%} of the printed k_1, with their differences from Eq. 10: {names}."
    )


def percent(share: float) -> str:
    """Text of a signed deviation in per cent with one decimal."""
    return f"{100 * share:+.1f} %"

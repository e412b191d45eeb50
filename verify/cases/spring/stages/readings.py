"""Readings of the paper's spring against Eq. 10: sixteen springs, one line each.

The paper does not state the supports of head and tail, the radius of the arcs (r or r + b/2), or
the increase of its shell model's stiffness by the width. A reading is chosen by k_1 alone; its k_2
and point A are then predictions, but count as calibrated.
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
FITTED = "calibrated: of the sixteen readings the one whose k_1 is nearest to the printed one"
LOOSE = "linear theory alone: such a spring buckles near 1 N, see spring-buckling and spring-curve"
N_PER_MM, mm = 1e3, 1e-3


@dataclass(frozen=True)
class Reading:
    """One reading of the paper's spring, and its stages [SI]."""

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
        return f"tail at {self.tail}, head {self.head}, {self.radius}, {self.strip}"


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
    """The lines as printed."""
    return Lines(*(value for value, _ in _entries()))


def uncertainties() -> dict[str, float]:
    """Standard uncertainties [SI] of values of Eq. 10, from its printed digits."""
    u = [u for _, u in _entries()]
    U, F = eq10().spread(*u)
    return {"k1": u[0], "k2": u[2], "U": U, "F": F}


def readings(q: StagesInputs) -> list[Reading]:
    """Tail, head, radius and strip: sixteen, and eight more with a given width factor."""
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
    """The readings with k_1 within 1 % of the printed value, the nearest first."""
    near = sorted(readings(q), key=lambda x: abs(x.off))
    return [x for x in near if abs(x.off) <= MET]


def chosen(q: StagesInputs) -> Reading:
    """The reading chosen by k_1 only, among the sixteen without a given factor."""
    return min(readings(q.model_copy(update={"width_factor": None})), key=lambda x: abs(x.off))


def keeps(key: str, figure: float) -> Margin:
    """Margin of the chosen reading below `figure` for k1, k2, U or F of Eq. 10 [SI]."""

    def margin(context: Context) -> tuple[float, float, str]:
        reading, printed = chosen(context.inputs), float(getattr(eq10(), key))
        off = float(getattr(reading, {"U": "U_A", "F": "F_A"}.get(key, key))) / printed - 1
        words = f"{off:+.1%} of the printed one, {figure:.0%} accepted ({reading}"
        words += f"; {LOOSE})" if reading.head == "free" else ")"
        return (figure - abs(off)) * printed, expanded(0.0, uncertainties()[key]), words

    return margin


def tables(q: StagesInputs, context: Context) -> Sequence[Table]:
    """Every reading against Eq. 10 and the tests; deviations for the numbers of the paper."""
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
    title = "Not stated in the paper: stages OA and AB for every combination"
    if not context.is_paper:
        return (Table(title=title, header=header, rows=tuple(rows), note=NOTE),)
    header += ("k_1, Eq. 10", "U_A", "F_A", "k_2", "k_1, test", "k_2, test", "k_1 within 1 %")
    return (Table(title=f"{title}, beside Eq. 10 and the tests", header=header, rows=tuple(rows),
                  note=f"{predictions(q)} {NOTE}"),)  # fmt: skip


NOTE = (
    "Linear theory; point A is where the first tip touches, k_2 the slope from there on (both "
    "tips for a tail clamped at mid-leaf, only the head's for one clamped at its arc). U_A does "
    "not depend on the strip's factor; k_1, F_A and k_2 are proportional to it."
)


def predictions(q: StagesInputs) -> str:
    """Which readings meet the printed k_1, and the differences of their predictions."""
    found = meeting(q)
    if not found:
        return f"No reading meets the printed k_1 within {MET:.0%}."
    names = "; ".join(
        f"{x} ({x.off:+.1%}): U_A {x.U_A / eq10().U - 1:+.1%}, F_A {x.F_A / eq10().F - 1:+.1%}, "
        f"k_2 {x.k2 / eq10().k2 - 1:+.1%}"
        for x in found
    )
    return (
        f"Printed: k_1 = {eq10().k1 / N_PER_MM:.3f}, k_2 = {eq10().k2 / N_PER_MM:.3f} N/mm, lines "
        f"crossing at {eq10().U / mm:.2f} mm and {eq10().F:.2f} N. Chosen by k_1 alone, within "
        f"{MET:.0%}: {names}."
    )


def percent(share: float) -> str:
    """A signed deviation in per cent with one decimal."""
    return f"{100 * share:+.1f} %"

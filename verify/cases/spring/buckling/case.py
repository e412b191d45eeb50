"""Lateral buckling of an accordion spring: Haringx's column, the elastica, finite elements."""

import math
from collections.abc import Iterator
from typing import ClassVar

from verify.case import (
    Comparison,
    Level,
    Scan,
    State,
    approximation,
    drawn_by,
    identity,
    underived,
)
from verify.cases.spring import sketch as sketched
from verify.cases.spring.buckling import claims
from verify.cases.spring.buckling import figures as drawn
from verify.cases.spring.buckling import reference as beams
from verify.cases.spring.buckling.formulas import MOST, BucklingFormulas, critical_point
from verify.cases.spring.buckling.inputs import DRIFT, KEYS, TAILS
from verify.core.case import Check
from verify.form.adapter import adapted
from verify.judging.checks import Accepted, Limit
from verify.judging.tolerance_checks import Agreement, suites

CUBE = 1e-3  # tolerance of the exponent; strain and shear change it by (b/L_1)^2
SPREAD = 0.005  # spread of U_cr over a fourfold thickness
HINGED_TO = 0.7  # over the free length
NOT_FOUND = "no equilibrium of the elastica was found before a critical point"
FEW = 5e-4, "the reference is one unit, modelled with a few curved elements"
EXACT = 1e-3, "the exact elastica and geometrically exact beams have the same equations"
SHARED = "narrow strip, E I; no contact of leaves"
WHERE = {"arc": "tail clamped at its arc", "mid-leaf": "tail clamped at mid-leaf"}


class BucklingSpring(BucklingFormulas):
    """Compression at which a spring buckles laterally if its head is not guided.

    Two formulas give this compression: Haringx's column with the stiffnesses of the units (arc,
    leaf, arc) of the spring, and the exact elastica of the leaves and arcs. Both are compared with
    geometrically exact beams.
    """

    id = "spring-buckling"
    title = "Lateral buckling of an accordion spring"
    source = "wang2023"
    place = "Sec. 3, Eq. 13, Fig. 11 (lateral displacement)"
    levels: ClassVar = (4, beams.SWEPT, 16)
    scans: ClassVar = (Scan(vary=("n=8,10,14", "b=0.1mm,0.2mm"), star=True),)
    readings: ClassVar = (
        "free head: the force has a constant direction and acts at O, which moves and rotates "
        "with the head; P is the Euler load of a cantilever column that has the length of the "
        "spring and the bending compliance of the unfolded strip",
        "buckling: the spring is compressed with a guided head, and the guide is then replaced by "
        "its reactions as dead loads; the spring buckles at the compression at which the head can "
        "then move without a change of these loads",
        "r is the inner radius: the centre line of the arcs has the radius r + b/2",
    )
    assumptions: ClassVar = (
        "leaves do not touch: the paper's spring buckles before its leaves touch",
        "narrow strip: E I without the factor 1/(1 − ν²), which affects forces but not "
        "displacements",
        "the tail is clamped at the end of its arc or in the middle of its leaf",
    )

    def reference(self, level: int) -> Level:
        """Reference: a unit of the spring, and geometrically exact beams with both tails."""
        return beams.solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows: one unit of the spring, the elastica and the column, each against beams; claims."""
        spring = BucklingSpring
        tails = [State(self.held(tail), KEYS[tail].removeprefix("_"), WHERE[tail])
                 for tail in TAILS]  # fmt: skip
        for q in (spring.unit_turn, spring.unit_axial, spring.unit_lateral):
            yield identity(q, order=4, sensitivity=FEW, shares=SHARED)
        for state in tails:
            for q in (spring.U_cr, spring.F_cr, spring.F_lin, spring.k_y):
                yield identity(q, state=state, order=4, sensitivity=EXACT, shares=SHARED)
            for share in DRIFT:
                yield identity(spring.drift(share), state=state, symbol="u_y", order=4,
                               sensitivity=EXACT, shares=SHARED)  # fmt: skip
        for tail in TAILS:
            yield approximation(
                spring.column_U, f"U_cr{KEYS[tail]}", symbol="U_cr", order=4,
                name=f"displacement at buckling by Haringx's column with the {WHERE[tail]}",
                shares=SHARED, expected=underived("head and tail are not units (arc, leaf, arc)"),
            )  # fmt: skip
        yield Comparison(quantity=spring.column_U, check=Limit(
            name="error of Haringx's column tends to zero as the number of units increases, "
            "tail clamped at its arc",
            symbol="U_cr", unit="1", points=claims.many_units, exponent=0.5, paper_only=True,
        ))  # fmt: skip
        yield from _swept()

    def refusal(self) -> str:
        """Reason why nothing is compared; empty if the spring is compared.

        Reasons are too many segments, no buckling, and no equilibrium path.
        """
        if self.n > MOST:
            return (
                f"n = {self.n} segments are more than {MOST}: the elastica takes too long, but the "
                "error of Haringx's column is below 3 %, check it without --fem"
            )
        buckles = math.isfinite(self.xi)
        try:
            if buckles and all(critical_point(self, tail) for tail in TAILS):
                return ""
        except ArithmeticError as error:
            return f"{NOT_FOUND} ({error}): check it without --fem"
        return (
            "this spring is too short to buckle sideways before its leaves touch: there is nothing "
            "to compare, check it without --fem"
        )

    figures = drawn_by(drawn.figures)
    tables = drawn.tables
    sketch = sketched.sketch


def _swept() -> Iterator[Check]:
    """Rows on springs with other thicknesses and lengths, and on paths of free and hinged heads."""
    yield Agreement(
        name="the buckling force grows with the cube of the thickness", symbol="q", unit="1",
        pair=claims.by_cube, accepted=CUBE / 3, by="theory",
        source=suites("1e-3 for the exponent, which axial strain and shear change by (b/L_1)²"),
    )  # fmt: skip
    yield Agreement(
        name="U_cr of springs with the same centre line is equal for thicknesses of 0.5 b to 2 b",
        symbol="U_cr", unit="mm", pair=claims.spread, accepted=SPREAD,
        source=suites("half of the required sensitivity of 1 %"),
    )  # fmt: skip
    yield Accepted(
        name="springs with equal L_0/b buckle at displacements that differ by a factor of more "
        "than 5",
        symbol="U_cr/L_0", unit="1", margin=claims.one_ratio,
        printed=("wang2023:rule-length-thickness-max",),
    )  # fmt: skip
    for name, margin in (
        ("a head that is never guided moves sideways without a critical point",
         claims.stays),
        (f"a spring with a hinged head does not buckle at displacements up to {HINGED_TO:.0%} "
         "of L_0", claims.hinged),
    ):  # fmt: skip
        for tail in TAILS:
            yield Accepted(name=f"{name}, {WHERE[tail]}", symbol="det", unit="1",
                           margin=margin(tail))  # fmt: skip


BUCKLING = adapted(BucklingSpring)

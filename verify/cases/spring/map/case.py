"""Validity of Eqs. 1-9 of the accordion spring: radius, displacement, guide of the head."""

from collections.abc import Iterator
from typing import Any, ClassVar

import numpy as np

from verify.case import (
    Comparison,
    Level,
    Scan,
    approximation,
    drawn_by,
    identity,
    underived,
)
from verify.cases.spring import sketch as sketched
from verify.cases.spring.claims import stored
from verify.cases.spring.map import claims
from verify.cases.spring.map import fem as beams
from verify.cases.spring.map import figures as drawn
from verify.cases.spring.map.formulas import PARTS, MapFormulas
from verify.cases.spring.map.inputs import DEEP_ANGLES, DEEP_SEGMENTS, MapInputs, points
from verify.core import case as core
from verify.core.case import Check, Context
from verify.core.figures import Figure
from verify.form.adapter import adapted
from verify.jobs.deep_results import measured
from verify.judging.checks import Accepted
from verify.judging.published_checks import Contradiction
from verify.judging.tolerance_checks import Agreement, demanded, suites

WAY = 0.01  # relative to the force at the end of a straight path
EXACT = 1e-3, "exact elastica and exact beam"
SHARED = "narrow strip, E I; no contact of leaves"


def _maps(context: Context) -> Iterator[Figure]:
    """The maps as solved; for the paper's numbers the finer measurement if available."""
    q, finer = context.inputs, measured(DEEP_MAP) if context.is_paper else None
    if not context.fem:
        return
    over, first = [], 0
    for name, cells in points(q, deep=finer is not None).items():
        if finer is None:
            k = stored(context, name)
        else:
            parts = finer.parts[first : first + len(cells)]
            k = np.array([part.arrays["cells"] for part in parts])
            first += len(cells)
        m = claims.errors(q, cells, k)
        yield from drawn.maps(name, m, finer.date if finer else "")
        over.append((np.array([[c.b / c.R for c in row] for row in cells]), m[..., 0]))
    yield drawn.radius(over)


class MapSpring(MapFormulas):
    """The formula's error over thickness, segments, leaves and angle.

    At small displacement only the arcs' radius has an effect; at the displacements that Eq. 12
    allows, the formula is compared with geometrically exact beams without contact.
    """

    id = "spring-map"
    title = "Range of validity of Eqs. 1-9 of the accordion spring"
    source = "wang2023"
    place = "Eqs. 1-9, Eqs. 12 and 13, Fig. 10; Sec. 1.2, Fig. 5 (travel of the roller)"
    levels: ClassVar = (4, beams.MAPPED, 16)
    scans: ClassVar = (Scan(vary=("n=8,10,14", "b=0.1mm,0.2mm,0.4mm"), star=True),)
    readings: ClassVar = (
        "r is the inner radius: Eqs. 1-9 take it for the arcs' radius, finite elements r + b/2",
        "Eqs. 1-9 leave the head free to turn and to move sideways, a roller's slot guides it",
    )
    assumptions: ClassVar = (
        "leaves do not touch: at 60 % of the length those of the paper's spring have touched",
        "narrow strip: E I without 1 − ν², on both sides",
        "the roller's travel begins where the spring is unloaded, its head does not turn",
    )

    def reference(self, level: int) -> Level:
        """Geometrically exact beams of the spring, and the maps."""
        return beams.solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows: elastica and Eq. 9 against beams; claims of the paper on Eqs. 1-9."""
        spring = MapSpring
        exact: dict[str, Any] = {"order": 4, "sensitivity": EXACT, "shares": SHARED}
        for share in PARTS:
            yield identity(spring.F(share), symbol="F", **exact)
        for q, words in ((spring.F_x, "axial"), (spring.F_y, "transverse")):
            scale = {"F_x, aside": self.F_x} if q is spring.F_y else None
            yield identity(q, scale=scale, **exact,
                           name=f"{words} force at the end of the roller's travel")  # fmt: skip
        for share, q in zip(PARTS, (spring.linear_0_3, spring.linear_0_6), strict=True):
            yield approximation(
                q, f"F_{share}", name=f"Eq. 9 at {share:.0%} of the length, head guided",
                symbol="F", order=4, expected=underived("measured: radius, guide and displacement"),
                shares=SHARED,
            )  # fmt: skip
        yield from _of_paper()

    figures = drawn_by(_maps)
    tables = drawn.tables
    sketch = sketched.sketch


def _of_paper() -> Iterator[Comparison]:
    """The paper's claims of its stiffness, of a free head, of the path and of the tests."""
    k1 = MapSpring.k1
    yield Comparison(quantity=k1, check=Accepted(
        name="Eqs. 1-9 are within 10 % from L_0/b = 240 on, n <= 24, small displacement",
        symbol="k_1", unit="1", margin=claims.within_claim,
        printed=("wang2023:k1-error-large-z",),
    ))  # fmt: skip
    yield Comparison(quantity=k1, check=Accepted(
        name="error of Eqs. 1-9 at small displacement falls as L_0/b grows on one centre line",
        symbol="k_1", unit="1", margin=claims.falls,
        printed=("wang2023:k1-error-large-z", "wang2023:rule-length-thickness-max"),
    ))  # fmt: skip
    yield Comparison(quantity=MapSpring.linear_0_3, check=Accepted(
        name="a free head carries less than a third of Eq. 9's force at 30 % of the length",
        symbol="F", unit="1", margin=claims.free_head,
    ))  # fmt: skip
    yield Comparison(check=Agreement(
        name="a straight path replaces the roller's within 1 % of the force", symbol="F_x",
        unit="N", pair=claims.travel, accepted=WAY, source=suites("as far off as rows may be"),
        **demanded(WAY),
    ))  # fmt: skip
    yield Comparison(quantity=MapSpring.error_of_tests, check=Contradiction(
        name="Eq. 9 against Eq. 10 at the tests' largest force", symbol="e_r", unit="%",
        analytic="error_of_tests", reference="wang2023:theory-fea-error-max",
        erratum="wang2023:theory-error-six-percent",
    ))  # fmt: skip


MAP = adapted(MapSpring)

# the record of a measurement, which names this function and these inputs
DEEP_MAP = core.Case(
    id="spring-map-deep",
    title="Range of validity of Eqs. 1-9 of the accordion spring, finer",
    paper="wang2023",
    place="Eqs. 1-9, Eqs. 12 and 13, Fig. 10",
    lead="The maps of spring-map with every number of segments and angle between.",
    inputs=MapInputs,
    analytic=lambda _: {},
    reference=beams.deep_fem,
    levels=tuple(range(len(DEEP_SEGMENTS) + len(DEEP_ANGLES))),
    checks=(),
    outputs=(),
)  # fmt: skip

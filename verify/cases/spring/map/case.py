"""Range of validity of Eqs. 1-9 of the accordion spring: radius, displacement, guided head."""

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
EXACT = 1e-3, "the exact elastica and geometrically exact beams have the same equations"
SHARED = "narrow strip, E I; no contact of leaves"


def _maps(context: Context) -> Iterator[Figure]:
    """Maps of the errors; for the paper's spring, those of the long study if available."""
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
    """Error of Eqs. 1-9 over thickness, number of segments, leaf length and angle.

    At small displacement, only the radius of the arcs causes an error. At the displacements that
    Eq. 12 allows, the formula is compared with geometrically exact beams without contact.
    """

    id = "spring-map"
    title = "Range of validity of Eqs. 1-9 of the accordion spring"
    source = "wang2023"
    place = "Eqs. 1-9, Eqs. 12 and 13, Fig. 10; Sec. 1.2, Fig. 5 (travel of the roller)"
    levels: ClassVar = (4, beams.MAPPED, 16)
    scans: ClassVar = (Scan(vary=("n=8,10,14", "b=0.1mm,0.2mm,0.4mm"), star=True),)
    readings: ClassVar = (
        "r is the inner radius: the arcs have the radius r in Eqs. 1-9, but r + b/2 in the finite "
        "elements",
        "in Eqs. 1-9 the head can rotate and move sideways; in a clutch, the slot of the roller "
        "guides the head",
    )
    assumptions: ClassVar = (
        "contact of leaves is neglected, although the leaves of the paper's spring touch before a "
        "displacement of 60 % of the length",
        "narrow strip: both models use E I without the factor 1/(1 − ν²)",
        "the spring is unloaded when the travel of the roller begins; the head does not rotate",
    )

    def reference(self, level: int) -> Level:
        """Reference: geometrically exact beams of the spring, and of all springs of the maps."""
        return beams.solve(self, level)

    def comparisons(self) -> Iterator[Comparison | Check]:
        """Rows: elastica and Eq. 9 against beams; the paper's statements on Eqs. 1-9."""
        spring = MapSpring
        exact: dict[str, Any] = {"order": 4, "sensitivity": EXACT, "shares": SHARED}
        for share in PARTS:
            yield identity(spring.F(share), symbol="F", **exact)
        for q, words in ((spring.F_x, "axial"), (spring.F_y, "transverse")):
            scale = {"F_x on the slanted path": self.F_x} if q is spring.F_y else None
            yield identity(q, scale=scale, **exact,
                           name=f"{words} force at the end of the roller's slanted path",
                           )  # fmt: skip
        for share, q in zip(PARTS, (spring.linear_0_3, spring.linear_0_6), strict=True):
            yield approximation(
                q, f"F_{share}",
                name=f"force by Eq. 9 against the guided spring, at a displacement of {share:.0%} "
                "of the length",
                symbol="F", order=4, expected=underived("arc radius, guide, large displacement"),
                shares=SHARED,
            )  # fmt: skip
        yield from _of_paper()

    figures = drawn_by(_maps)
    tables = drawn.tables
    sketch = sketched.sketch


def _of_paper() -> Iterator[Comparison]:
    """Rows on statements of the paper: stiffness, free head, path of the roller, tests."""
    k1 = MapSpring.k1
    yield Comparison(quantity=k1, check=Accepted(
        name="error of Eqs. 1-9 is below 10 % for L_0/b >= 240, n <= 24, small displacement",
        symbol="k_1", unit="1", margin=claims.within_claim,
        printed=("wang2023:k1-error-large-z",),
    ))  # fmt: skip
    yield Comparison(quantity=k1, check=Accepted(
        name="error of Eqs. 1-9 at small displacement decreases with increasing L_0/b for the "
        "same centre line",
        symbol="k_1", unit="1", margin=claims.falls,
        printed=("wang2023:k1-error-large-z", "wang2023:rule-length-thickness-max"),
    ))  # fmt: skip
    yield Comparison(quantity=MapSpring.linear_0_3, check=Accepted(
        name="at a displacement of 30 % of the length, a free head carries less than a third of "
        "the force by Eq. 9",
        symbol="F", unit="1", margin=claims.free_head,
    ))  # fmt: skip
    yield Comparison(check=Agreement(
        name="the axial force on a straight path is within 1 % of the axial force on the roller's "
        "slanted path",
        symbol="F_x", unit="N", pair=claims.travel, accepted=WAY,
        source=suites("equal to the default required sensitivity of a row"), **demanded(WAY),
    ))  # fmt: skip
    yield Comparison(quantity=MapSpring.error_of_tests, check=Contradiction(
        name="force by Eq. 9, compared with the force by Eq. 10, at the largest test force",
        symbol="e_r", unit="%", analytic="error_of_tests",
        reference="wang2023:theory-fea-error-max",
        erratum="wang2023:theory-error-six-percent",
    ))  # fmt: skip


MAP = adapted(MapSpring)

# the record of a measurement, which names this function and these inputs
DEEP_MAP = core.Case(
    id="spring-map-deep",
    title="Range of validity of Eqs. 1-9 of the accordion spring, finer maps",
    paper="wang2023",
    place="Eqs. 1-9, Eqs. 12 and 13, Fig. 10",
    lead="The maps of case spring-map with more numbers of segments and more angles.",
    inputs=MapInputs,
    analytic=lambda _: {},
    reference=beams.deep_fem,
    levels=tuple(range(len(DEEP_SEGMENTS) + len(DEEP_ANGLES))),
    checks=(),
    outputs=(),
)  # fmt: skip

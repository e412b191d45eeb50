"""Error budgets of springs: slenderness, large displacement, width, and the plane assumption."""

from collections.abc import Mapping
from typing import Any

from verify.cases.spring.curve.inputs import CurveInputs
from verify.cases.spring.limits import Share
from verify.cases.spring.map.inputs import SHARES, Cell, MapInputs
from verify.core.case import FemResult
from verify.judging.budget_statement import (
    Argument,
    Cause,
    Corrected,
    Left,
    Rerun,
    Statement,
    Without,
    plane_strain,
)

SECTION = "fem.beam.section:Section"
RIGID = 1e11  # N, five orders above the value of a strip of this size
THINNER, MORE, SMALL, FIRMER = 4, 3, 1e-4, 10.0


def thin(q: Any) -> Any:
    """Inputs with a quarter of the thickness."""
    return q.model_copy(update={"b": q.b / THINNER})


def half_as_thick(q: Any) -> Any:
    """Inputs with half of the thickness."""
    return q.model_copy(update={"b": q.b / 2})


def many(q: Any) -> Any:
    """Inputs with three times as many segments."""
    return q.model_copy(update={"n": MORE * q.n})


def long_leaf(q: Any) -> Any:
    """Inputs with leaves twice as long, a strip twice as wide, and unchanged arcs."""
    return q.model_copy(update={"L1": 2 * q.L1, "h": 2 * q.h})


def fem_small(q: MapInputs, level: int) -> FemResult:
    """Forces of the guided spring, extrapolated in proportion from a very small displacement."""
    from verify.cases.spring.map.fem import spring

    here = Cell(q.n, q.b, q.r, q.L1, q.alpha)
    one = spring(q, here, level, max(1, level // 2))
    return proportional(level, one.force(one.compressed([SMALL * here.length])[-1]), SMALL)


def fem_free(q: MapInputs, level: int) -> FemResult:
    """Forces of the spring with a free head: its initial stiffness times each displacement."""
    from verify.cases.spring.map.fem import spring

    here = Cell(q.n, q.b, q.r, q.L1, q.alpha)
    k = spring(q, here, level, max(1, level // 2)).stiffness
    return proportional(level, k * here.length, 1.0)


def fem_paper(q: MapInputs, level: int) -> FemResult:
    """Forces of a spring whose arcs have the inner radius: initial stiffness times displacement."""
    from verify.cases.spring.large_fem import spring_fem

    path = q.paper_path | {"tail": "arc"}
    one = spring_fem(path, q.b, q.h, q.E, q.nu, per_arc=level, per_leaf=max(1, level // 2))
    return proportional(level, one.stiffness * q.length, 1.0)


def proportional(level: int, force: float, share: float) -> FemResult:
    """Forces that are proportional to the displacement, at the displacements of the case.

    The force is `force` at the displacement `share`. Displacements are divided by the free length.
    """
    values = {f"F_{target}": target / share * force for target in map(Share, SHARES)}
    return FemResult(h=1 / level, values=values)


def fem_firmer(q: CurveInputs, level: int) -> FemResult:
    """Initial stiffness of the spring as in the case, but with tenfold contact stiffness."""
    from verify.cases.spring.curve.fem import fem_compress
    from verify.cases.spring.curve.reference import FIRST, spring_of

    pressed = [FIRST * q.stroke, 2 * FIRST * q.stroke]
    rest = fem_compress(spring_of(q), pressed, per_arc=level, times=FIRMER)
    once, twice = rest.F / rest.U
    return FemResult(h=1 / level, values={"k1": float(2 * once - twice)})


PROPORTION = "very small displacement; the force is scaled in proportion to the displacement"
HEAD = "at very small displacement, a free head instead of a guided head"
EQ_9_FAR = ("force by Eq. 9 against the guided spring*",)
EQ_9 = ("stiffness by Eqs. 1-9 against curved beam elements",)
HARINGX = ("displacement at buckling by Haringx*",)
NO_PLANE = Without(
    Cause.PLANE, "both models are beams; see spring-width for the effect of the width"
)

STATEMENTS: Mapping[str, Statement] = {
    "spring-accordion": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="no shear of the strip", rows=EQ_9,
                  changes=(Argument(SECTION, {"GA": RIGID}),)),
            Rerun(cause=Cause.GEOMETRY, what="no stretching of the strip", rows=EQ_9,
                  changes=(Argument(SECTION, {"EA": RIGID}),)),
        ),
        without=(NO_PLANE, Without(Cause.DISPLACEMENT, "both models assume small displacements")),
        corrected=(
            Corrected("stiffness by Eqs. 1-9 with the inner radius in all arcs, against a frame "
                      "with the true centre line", "k_V",
                      "inner radius of the arcs instead of the radius of their centre line"),
            *(Corrected(f"stiffness by Eqs. 1-9 with the inner radius only in {part}", "k_V",
                        "inner radius of these arcs instead of the radius of their centre line")
              for part in ("the arc of one end, head or tail (Eqs. 1, 2, 6)",
                           "the inner segments (Eqs. 3, 4)")),
            Corrected("stiffness by Eqs. 1-9 with the leaf length as printed in Eq. 3", "k1",
                      "leaf length by the geometry instead of Eq. 3 as printed"),
            Corrected("stiffness of a spring with five segments, Eq. 5 (tail) with the printed "
                      "sign",
                      "k1_five", "sign of Eq. 5 for an odd number of segments"),
        ),
        finer=48,
    ),
    "spring-continuum": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="half of the strip thickness", inputs=half_as_thick,
                  levels=(2, 4)),
            Rerun(cause=Cause.PLANE, what="plane strain instead of plane stress",
                  rows=("*plane stress",), changes=plane_strain(), shared=True),
        ),
        without=(Without(Cause.DISPLACEMENT, "both models assume small displacements"),),
    ),
    "spring-stages": Statement(
        without=(NO_PLANE, Without(Cause.CONTACT, "0 by construction: closed contacts are "
                                   "rigid links, open contacts carry no force")),
        finer=48,
    ),
    "spring-width": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="leaves twice as long, strip twice as wide, same arcs",
                  rows=("width factor of the spring, estimated by the factor of one leaf",),
                  inputs=long_leaf),
        ),
        without=(Without(Cause.PLANE, "shells and solids have the true width"),),
        corrected=(
            Corrected("k_1 of a narrow strip (E I), compared with the shell model of the suite",
                      "k", "E I instead of E I times the width factor of a leaf"),
        ),
    ),
    "spring-curve": Statement(
        reruns=(
            Rerun(cause=Cause.CONTACT, fem=fem_firmer,
                  what="tenfold contact stiffness (no contact in the unloaded spring)"),
        ),
        without=(NO_PLANE,),
    ),
    "spring-buckling": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="three times as many segments", rows=HARINGX,
                  inputs=many, levels=(4,)),
            Rerun(cause=Cause.GEOMETRY, what="a quarter of the strip thickness", rows=HARINGX,
                  inputs=thin, levels=(4,)),
        ),
        left=(
            Left(("displacement at buckling by Haringx's column*",),
                 "neither the thickness nor the number of segments explains the difference; the "
                 "end conditions were not varied"),
        ),
        without=(NO_PLANE,), finer=24,
    ),
    "spring-map": Statement(
        reruns=(
            Rerun(cause=Cause.DISPLACEMENT, what=PROPORTION, rows=EQ_9_FAR, fem=fem_small),
            Rerun(cause=Cause.GEOMETRY, what=HEAD, rows=EQ_9_FAR, fem=fem_free, after=PROPORTION),
            Rerun(cause=Cause.GEOMETRY,
                  what="at very small displacement and with a free head, arcs of the inner radius",
                  rows=EQ_9_FAR, fem=fem_paper, after=HEAD),
        ),
        without=(NO_PLANE,), finer=24,
    ),
}  # fmt: skip

"""Causes of error in contact formulas: contact width, wall, ends, and plane assumption."""

import math
from collections.abc import Callable, Mapping
from typing import Any

from verify.core.case import FemResult
from verify.judging.budget_statement import Cause, Left, Rerun, Statement, Without, plane_stress

PROBLEM = "fem.contact.problem:ContactProblem"
LIGHTER, POINT, THICKER, LONGER = 100, 1000, 4, 4
NARROWER = 10


def light(q: Any) -> Any:
    """The inputs `q` with a hundredth of the load: a line contact with a tenth of the width."""
    return q.model_copy(update={"F": q.F / LIGHTER})


def light_point(q: Any) -> Any:
    """The inputs `q` with a thousandth of the load: a point contact with a tenth of the radius."""
    return q.model_copy(update={"P": q.P / POINT})


def thick(q: Any) -> Any:
    """The inputs `q` with a wall of the race four times as thick."""
    return q.model_copy(update={"r_o": q.r_i + THICKER * (q.r_o - q.r_i)})


def long(q: Any) -> Any:
    """The inputs `q` with four times the length, load and crown load: equal load per length."""
    more = {"F": LONGER * q.F, "L": LONGER * q.L}
    if getattr(q, "Q", None):
        more["Q"] = LONGER * q.Q
    return q.model_copy(update=more)


def long_races(q: Any) -> Any:
    """The inputs `q` with races that extend four times as far beyond the roller."""
    return q.model_copy(update={"overhang": THICKER * q.overhang})


def straight(q: Any) -> Any:
    """The inputs of `long` with a quarter of the tilt, so that the ends rise as much as in `q`."""
    return long(q).model_copy(update={"theta": q.theta / LONGER})


def fem_narrow_disc(q: Any, level: int) -> FemResult:
    """Values of the disc with the widest contact, scaled from a contact a tenth as wide."""
    from verify.cases.contact.line.flat import WIDEST, key
    from verify.cases.contact.line.reference import disc_fem

    e = WIDEST / NARROWER
    small, wide = q.at_ratio(e), q.at_ratio(WIDEST)
    found = disc_fem(q, small.P, e * q.R, level).values()
    return FemResult(h=1 / level, values={
        f"{name}_{key(WIDEST)}": value * getattr(wide, name) / getattr(small, name)
        for name, value in found.items()
    })  # fmt: skip


def fem_narrow_unlike(q: Any, level: int) -> FemResult:
    """Values for different materials, scaled by Hertz from a contact about a tenth as wide."""
    from verify.cases.contact.line.reference import pair_fem

    found = pair_fem(light(q.unlike()), level).values()
    # by Hertz the half-width and the pressure follow the root of the load
    return FemResult(h=1 / level, values={
        f"{name}_unlike": math.sqrt(LIGHTER) * found[name] for name in ("p_0", "a")
    })  # fmt: skip


# the other rows have separate loads
AT_LOAD = ("peak pressure, Hertz", "half-width, Hertz", "approach of flat and roller centre, Hertz",
            "approach of the centres, Hertz", "approach of roller centre and rim",
            "largest shear stress, Hertz")  # fmt: skip
NARROW = Rerun(cause=Cause.GEOMETRY, what="load × 1/100, hence contact width × 1/10",
               rows=AT_LOAD, inputs=light)  # fmt: skip
PLANE = Rerun(cause=Cause.PLANE, what="plane stress instead of plane strain", shared=True,
              rows=("*Hertz", "app*"), changes=plane_stress(PROBLEM))  # fmt: skip
LONG = Rerun(cause=Cause.GEOMETRY, what="length × 4, equal load per length",
             inputs=long)  # fmt: skip
SLICED = (
    Left(("*slices",), "slices follow Palmgren's law for a whole roller; a half-space cannot be "
         "recomputed with this law"),
)  # fmt: skip
HALF_SPACE = (
    Without(Cause.CONTACT, "none: the contact law is exact (no negative pressure)"),
    Without(Cause.PLANE, "none: the half-space is a three-dimensional model"),
)


def in_proportion(rows: str, fem: Callable[[Any, int], FemResult]) -> Rerun:
    """Rerun that shows the error due to contact width: `fem` solves a contact a tenth as wide."""
    return Rerun(cause=Cause.GEOMETRY, what="contact width × 1/10, values scaled",
                 rows=(rows,), fem=fem)  # fmt: skip


def line_contact(more: Rerun) -> Statement:
    """Causes of error of a line contact: the two common to all line contacts, and `more`."""
    return Statement(reruns=(NARROW, PLANE, more), finer=8)


STATEMENTS: Mapping[str, Statement] = {
    "contact-flat": line_contact(in_proportion("*, a/R = 0.15, Hertz", fem_narrow_disc)),
    "contact-pair": line_contact(
        in_proportion("*, different materials, a/R = 0.1, Hertz", fem_narrow_unlike)
    ),
    "contact-ring": line_contact(
        Rerun(cause=Cause.GEOMETRY, what="wall thickness × 4", rows=AT_LOAD, inputs=thick)
    ),
    "contact-slip": Statement(finer=72),
    "contact-sphere": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="load × 1/1000, hence contact width × 1/10",
                  inputs=light_point),
        ),
        without=(Without(Cause.PLANE, "none: the bodies are bodies of revolution"),),
        finer=12,
    ),
    "contact-press-fit": Statement(finer=6),
    "contact-roller": Statement(reruns=(LONG,), left=SLICED, without=HALF_SPACE, finer=40),
    "contact-roller-tilted": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="length × 4, equal load per length",
                  inputs=straight),
        ),
        left=SLICED, without=HALF_SPACE, finer=40,
    ),
    "contact-roller-flat": Statement(reruns=(LONG,), left=SLICED, without=HALF_SPACE, finer=40),
    "contact-roller-crowns": Statement(reruns=(LONG,), without=HALF_SPACE, finer=40),
    "contact-roller-end": Statement(
        reruns=(
            Rerun(cause=Cause.GEOMETRY, what="length of the races beyond the roller × 4",
                  rows=("*: model with end faces", "*without end faces"), inputs=long_races,
                  levels=(2,)),
        ),
        left=(
            Left(("*model with end faces", "*without end faces"), "only the length of the races "
                 "beyond the roller was varied; the effect of the free end face, which a "
                 "half-space does not have, remains"),
        ),
        without=(Without(Cause.PLANE, "none: the bodies are bodies of revolution"),),
    ),
}  # fmt: skip

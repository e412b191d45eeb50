"""Ranges of the inputs in which a formula is within each limit, from the stored studies."""

from collections.abc import Sequence

import numpy as np

from verify.core.figures import Array
from verify.core.verdicts import Side, VerdictRange
from verify.studies.sweep.outcome import Course
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.region import lines, regions
from verify.studies.validity.messages import constant, over
from verify.studies.validity.regions import box_words
from verify.verdicts.design import side
from verify.verdicts.evidence import Study, joined
from verify.verdicts.rule import CLASSES

LIMITS = CLASSES[1:]  # 2, 5 and 10 %
DIGITS = 1  # significant, of an estimate


def ranges(studies: Sequence[Study]) -> tuple[VerdictRange, ...]:
    """Ranges in which all compared rows are within each limit, for each study."""
    return tuple(
        VerdictRange(
            case=plan.case.id, limit=one.limit, words=box_words(one, star=plan.star),
            over=over(plan), is_star=plan.star, inside=one.inside, points=one.points,
            box=tuple(side(plan.case.id, of.axis, of.low, of.high) for of in one.box),
            studied=tuple(
                side(plan.case.id, axis, axis.values[0], axis.values[-1]) for axis in plan.axes
            ),
            held=tuple(
                Side(name=one.name, symbol=one.symbol or one.name, unit=one.unit,
                     low=float(one.value), high=float(one.value))
                for one in constant(plan)
            ),
            interpolation=interpolation(plan, course),
        )
        for plan, course in joined(studies)
        for one in regions(plan, course, LIMITS)
    )  # fmt: skip


def interpolation(plan: Plan, course: Course) -> float | None:
    """Largest deviation of the error at a point from interpolation between its neighbours.

    At the points of a study, this overestimates the error of interpolation between the points, by a
    factor of about four where the error is smooth. The result is None if no point has two solved
    neighbours.
    """
    largest = [
        float(np.max(off))
        for row in _rows(plan)
        for line in lines(plan, row)
        if (off := _off(line.x, course.error[line.points], log=line.axis.spacing == "log")).size
    ]
    return float(f"{max(largest):.{DIGITS}g}") if largest else None


def _rows(plan: Plan) -> Sequence[int]:
    """Row numbers of points whose lines are evaluated: centre of a star, all points of a grid."""
    return range(1) if plan.star else range(len(plan.points))


def _off(x: Array, error: Array, *, log: bool) -> Array:
    known = np.isfinite(error)
    x, error = np.log(x[known]) if log else x[known], error[known]
    if x.size <= 2:
        return np.zeros(0)
    share = (x[1:-1] - x[:-2]) / (x[2:] - x[:-2])
    straight = (1 - share) * error[:-2] + share * error[2:]
    return np.asarray(np.abs(error[1:-1] - straight))

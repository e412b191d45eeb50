"""Regions in which the error of one formula is within the limits, and the errors for the figure."""

from collections import Counter
from collections.abc import Sequence

import numpy as np

from verify.core.results import ValidityAxis, ValidityLimit, ValidityRegion
from verify.studies.sweep.axes import Axis
from verify.studies.sweep.outcome import Course
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.region import Range, Region, lines, regions
from verify.studies.validity import messages as words
from verify.studies.validity.breaks import breaks

MIDDLE = 1  # of LIMITS: the one whose bound is reported
MOST_DRAWN = 2  # axes
COMMAND = ", check it without --fem"  # advice on that point


def region(plan: Plan, course: Course) -> ValidityRegion:
    """Results of a formula over one plan, with the errors that the figure shows."""
    found = regions(plan, course)
    reasons = Counter(reason.removesuffix(COMMAND) for reason in course.problems if reason)
    drawn, rows = _drawn(plan, course)
    return ValidityRegion(
        over=words.over(plan), points=len(plan.points), unsolved=found[0].unsolved,
        problems=tuple(
            f"at {count} point{'s' * (count > 1)}: {reason}"
            for reason, count in reasons.most_common()
        ),
        limits=tuple(_limit(one, star=plan.star) for one in found), breaks=breaks(found[MIDDLE]),
        axes=drawn, error=tuple(course.error[rows].tolist()),
        U=tuple(course.U_error[rows].tolist()),
    )  # fmt: skip


def _limit(found: Region, *, star: bool) -> ValidityLimit:
    return ValidityLimit(
        limit=found.limit, inside=found.inside, outside=found.outside, undecided=found.undecided,
        words=box_words(found, star=star),
        box=tuple((one.axis.name, one.axis.in_unit(one.low), one.axis.in_unit(one.high))
                  for one in found.box),
    )  # fmt: skip


def box_words(found: Region, *, star: bool) -> str:
    """Text of the largest box, a range for each axis; for a star, of each range with its input.

    If all points or no points are inside, the text states this.
    """
    if found.everywhere:
        return "the whole measured range"
    if not found.box:
        return "no measured point"
    return _alone(found.box) if star else ", ".join(_range(one) for one in found.box)


def _range(one: Range) -> str:
    return f"all {one.axis.symbol}" if one.whole else words.span(one.axis, one.low, one.high)


def _alone(ranges: Sequence[Range]) -> str:
    """Text of the ranges of single inputs; inputs without a restriction come last."""
    texts = [words.alone(one.axis, one.low, one.high) for one in ranges if not one.whole]
    whole = " or ".join(one.axis.symbol for one in ranges if one.whole)
    return "; ".join(
        [*texts, f"{whole} over the whole range (other inputs constant)"] if whole else texts
    )


def _drawn(plan: Plan, course: Course) -> tuple[tuple[ValidityAxis, ...], list[int]]:
    """Axes of the figure, and the row numbers of its points in the plan.

    For a grid, the figure contains the complete grid, or nothing if the grid has too many axes. For
    a star, it contains the line on which the error varies most.
    """
    if not plan.star:
        if len(plan.axes) > MOST_DRAWN:
            return (), []
        return tuple(_axis(a, a.values) for a in plan.axes), list(range(len(plan.points)))
    every = [line for line in lines(plan, 0) if len(line.x) > 1]
    best = max(every, key=lambda line: _spread(course.error[line.points]))
    return (_axis(best.axis, tuple(best.x.tolist())),), best.points.tolist()


def _spread(error: np.ndarray[tuple[int], np.dtype[np.float64]]) -> float:
    known = error[np.isfinite(error)]
    return float(np.ptp(known)) if known.size else -1.0


def _axis(axis: Axis, values: tuple[float, ...]) -> ValidityAxis:
    return ValidityAxis(
        name=axis.name, symbol=axis.symbol, unit=axis.unit,
        values=tuple(axis.in_unit(v) for v in values),
        nominal=None if axis.nominal is None else axis.in_unit(axis.nominal),
        log=axis.spacing == "log",
    )  # fmt: skip

"""Where the error of one formula stays within the limits, and what takes it out of them first."""

from collections import Counter

import numpy as np

from verify.results import ValidityAxis, ValidityLimit, ValidityRegion
from verify.sweep.axes import Axis
from verify.sweep.outcome import Course
from verify.sweep.plan import Plan
from verify.sweep.region import (
    NAMES,
    OUTSIDE,
    UNDECIDED,
    Break,
    Range,
    Region,
    lines,
    regions,
)
from verify.validity import words

MIDDLE = 1  # of LIMITS: the one whose loss is told
MOST_DRAWN = 2  # axes


def region(plan: Plan, course: Course) -> ValidityRegion:
    """All that is told of a formula over one plan, with the errors that are drawn."""
    found = regions(plan, course)
    reasons = Counter(reason for reason in course.problems if reason)
    drawn, rows = _drawn(plan, course)
    return ValidityRegion(
        over=words.over(plan), points=len(plan.points), unsolved=found[0].unsolved,
        problems=tuple(f"{count} × {reason}" for reason, count in reasons.most_common()),
        limits=tuple(_limit(one) for one in found), breaks=breaks(found[MIDDLE]),
        axes=drawn, error=tuple(course.error[rows].tolist()),
        U=tuple(course.U_error[rows].tolist()),
    )  # fmt: skip


def _limit(found: Region) -> ValidityLimit:
    return ValidityLimit(
        limit=found.limit, inside=found.inside, outside=found.outside, undecided=found.undecided,
        words=box_words(found),
        box=tuple((one.axis.name, one.axis.shown(one.low), one.axis.shown(one.high))
                  for one in found.box),
    )  # fmt: skip


def box_words(found: Region) -> str:
    """The largest box: a range for each axis; "all", "none" where that is what it is."""
    if found.everywhere:
        return "all that was measured"
    if not found.box:
        return "none of what was measured"
    return ", ".join(_range(one) for one in found.box)


def _range(one: Range) -> str:
    return f"all {one.axis.symbol}" if one.whole else words.span(one.axis, one.low, one.high)


def breaks(found: Region) -> str:
    """What takes the formula out of the limit first, and from where, in words."""
    limit = f"{found.limit:.0%}".replace("%", " %")
    if found.base is None:
        nowhere = "" if found.inside else f", and no point is within {limit}"
        return f"{_at_nominal(found)}{nowhere}"
    start = "" if found.nominal else f"{_at_nominal(found)}; from the middle of the region, "
    step = found.breaks
    if step is None:
        kept = "nothing in what was measured" if found.everywhere else "no input alone"
        more = "" if found.everywhere else ", several together do"
        return f"{start}{kept} takes it beyond {limit}{more}"
    towards = f"{'larger' if step.up else 'smaller'} {step.axis.symbol}"
    last = words.quantity(step.axis, step.last)
    return f"{start}{towards}: within {limit} to {last}, {_next(step)}"


def _next(step: Break) -> str:
    first = words.quantity(step.axis, step.first)
    if step.verdict == OUTSIDE:
        near = "" if step.at is None else f", the limit near {words.quantity(step.axis, step.at)}"
        return f"beyond it at {first}{near}"
    if step.verdict == UNDECIDED:
        return f"undecided at {first}: the error bar reaches across"
    return f"not solved at {first} ({step.why})" if step.why else f"not solved at {first}"


def _at_nominal(found: Region) -> str:
    if found.at_nominal is None:
        return "the case's own inputs are not among what was measured"
    return f"{NAMES[found.at_nominal]} at the case's own inputs already"


def _drawn(plan: Plan, course: Course) -> tuple[tuple[ValidityAxis, ...], list[int]]:
    """The axes of a figure and the points in it: a grid, or the line that the error varies most on.

    Nothing of a grid of more axes than can be drawn.
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
        values=tuple(axis.shown(v) for v in values),
        nominal=None if axis.nominal is None else axis.shown(axis.nominal),
        log=axis.spacing == "log",
    )  # fmt: skip

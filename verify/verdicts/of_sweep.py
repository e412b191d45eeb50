"""Verdict on a formula over the points of a user's sweep, by the general rule."""

import math
from typing import Any

import numpy as np

from verify.core.verdicts import Safe
from verify.studies.sweep.outcome import Course
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.region import nominal_point
from verify.verdicts.declared import safe_sides
from verify.verdicts.rule import Point, above, accuracy, below, judged
from verify.verdicts.words import SIDE, percent, sides

SAME = 1e-9  # relative: values that differ by less are equal
SAFE = {"too high": Safe.ABOVE, "too low": Safe.BELOW}


def safe_side(plan: Plan, course: Course) -> Safe:
    """Safe side of a compared quantity, as declared for the formula or stated by the case."""
    declared = safe_sides().get(f"{plan.case.id}/{course.pair.name}")
    if declared is not None:
        return declared
    quantities: Any = getattr(plan.case.inputs, "quantities", tuple)
    stated = {q.name: q.safe for q in quantities()}
    return SAFE.get(stated.get(course.pair.analytic, ""), Safe.NEITHER)


def verdict_in_words(plan: Plan, course: Course) -> str:
    """Text with the verdict, the largest errors and the safe side; empty if nothing is compared."""
    known = np.isfinite(course.error + course.U_error)
    if not known.any():
        return ""
    nominal = _nominal(plan)
    points = [
        Point(float(course.error[k]), float(course.U_error[k]), is_paper=k == nominal)
        for k in np.flatnonzero(known)
    ]
    safe = safe_side(plan, course)
    verdict = judged(points, safe, has_range=bool(known.all()))
    limit = accuracy(points)
    if limit is not None:
        return f"{verdict}: within {percent(limit)}"
    return f"{verdict}: {sides(above(points), below(points))}; {SIDE[safe]}"


def _nominal(plan: Plan) -> int | None:
    """Index of the point with the nominal inputs; None if the sweep does not contain them."""
    found = nominal_point(plan)
    if found is None:
        return None
    values = [axis.nominal for axis in plan.axes]
    at = plan.points[found]
    same = all(v is not None and math.isclose(v, x, rel_tol=SAME)
               for v, x in zip(values, at, strict=True))  # fmt: skip
    return found if same else None

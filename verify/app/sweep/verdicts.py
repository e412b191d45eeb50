"""Result of a sweep for one formula, in one or two sentences."""

import math
from collections.abc import Sequence

import numpy as np

from reports.measured import all_within
from verify.studies.sweep.axes import Axis, Tolerance
from verify.studies.sweep.indices import LOOSE, NOISY, Indices, Scatter
from verify.studies.sweep.messages import box_in_words, break_in_words, error_with_bar
from verify.studies.sweep.outcome import Course
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.region import Region
from verify.studies.sweep.tables import largest


def grid_in_words(plan: Plan, course: Course, found: Sequence[Region]) -> str:
    """Sentences about the range in which the formula is accurate, and about its largest error."""
    if (n := largest(course)) is None:
        return "Nothing could be compared."
    sentences = []
    whole = next((r for r in found if r.inside == r.points - r.unsolved), None)
    tighter = found[: found.index(whole)] if whole else found
    if whole:
        solved = "that are solved " * bool(whole.unsolved)
        sentences.append(
            f"The error is within {limit_named(whole)} at all {whole.inside:,} points "
            f"{solved}".rstrip()
        )
    part = next((r for r in reversed(tighter) if r.inside), None)
    if part and not whole:  # the middle limit is reported if it holds at any point
        part = next(r for r in (*found[1:], found[0]) if r.inside)
    if part:
        sentences.append(f"within {limit_named(part)} for {box_in_words(plan, part)}")
        if why := break_in_words(plan, part):
            sentences.append(why)
    elif not whole:
        sentences.append(_nowhere(found[-1]))
    text = "; ".join(sentences)
    small = all_within(course.error, course.U_error)
    most = f"; {small}" if small else f". The largest error is {_at(plan, course, n)}"
    return f"{text[0].upper()}{text[1:]}{most}{_side(course)}."


def _nowhere(r: Region) -> str:
    """Text which states that at no point the error is certainly within a limit."""
    solved = r.points - r.unsolved
    if r.outside < solved:
        return f"At no point is the error certainly within {limit_named(r)}"
    every = {1: "the only solved point", 2: "both solved points"}
    return f"Outside {limit_named(r)} at {every.get(solved, f'all {solved:,} solved points')}"


def _side(course: Course) -> str:
    """Text which states that the formula is always too large or too small; empty if neither."""
    known = np.isfinite(course.error + course.U_error)
    error, U = course.error[known], course.U_error[known]
    what = course.pair.by or "finite elements"
    if (error > U).all():
        return f"; the value by the formula is always larger than by {what}"
    if (error < -U).all():
        return f"; the value by the formula is always smaller than by {what}"
    return ""


def sample_in_words(about: Indices) -> str:
    """Sentences about the error if inputs vary within their tolerances, and the main inputs."""
    error = about.error
    if not error.n:
        return "Nothing could be compared."
    solved = "solved " * any(one.unsolved for one in about.within)
    text = (
        f"The error is {_moments_of(error)} (mean and standard deviation), from "
        f"{100 * error.low:+.3g} to {100 * error.high:+.3g} % in 95 % of the {solved}points. "
    )
    shares = [f"{share(one.inside, error.n)} within {100 * one.limit:g} %" for one in about.within]
    text += f"Of the {solved}points {', '.join(shares)}."
    if error.why:
        text += f" Sensitivity indices of the error are not available: {error.why}."
    else:
        first = error.ranked[0]
        text += (
            f" The error depends most on {first.tolerance.symbol} (total index "
            f"{first.total.value:.2f}{_noisy(error.noise)})."
        )
    return f"{text} {small_sample(about)}".rstrip()


def small_sample(about: Indices) -> str:
    """Text which states that indices are too uncertain to rank inputs; empty if they are not."""
    if not (widest := max(s.widest for s in (about.formula, about.fe, about.error))) > LOOSE:
        return ""
    rows = about.rows + about.dropped
    return (
        f"The sample is small: intervals of indices are up to ±{widest / 2:.2f} wide. Four times "
        f"as many base points (sobol:{4 * rows}) would about halve them."
    )


def _moments_of(error: Scatter) -> str:
    """Mean and standard deviation in per cent, with two digits of the standard deviation."""
    mean, sd = 100 * error.mean, 100 * error.sd
    digits = max(0, 1 - math.floor(math.log10(sd))) if sd > 0 else 3
    return f"{mean:+.{min(digits, 9)}f} ± {sd:.2g} %"


def _noisy(noise: float) -> str:
    return f", up to {100 * noise:.0f} % of its variance may be numerical" if noise > NOISY else ""


def _at(plan: Plan, course: Course, n: int) -> str:
    return f"{error_with_bar(course, n)} at {place(plan, n)}"


def place(plan: Plan, n: int) -> str:
    varied: Sequence[Axis | Tolerance] = plan.axes or plan.tolerances
    return ", ".join(_value(v, x) for v, x in zip(varied, plan.points[n], strict=True))


def _value(v: Axis | Tolerance, x: float) -> str:
    return f"{v.symbol} = {v.in_unit(x):.4g}{unit_after(v.unit)}"


def unit_after(unit: str) -> str:
    return "" if unit == "1" else f" {unit}"


def limit_named(r: Region) -> str:
    return f"{100 * r.limit:g} %"


def share(part: int, whole: int) -> str:
    """Text of `part` as a percentage of `whole`, the number of solved points, without decimals.

    It is "100 %" only for all points and "0 %" only for no point.
    """
    if not whole:
        return "–"
    share = 100 * part / whole
    return f"{share if part in (0, whole) else min(max(share, 1), 99):.0f} %"

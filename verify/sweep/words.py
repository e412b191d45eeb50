"""Regions, breaks, errors and indices of a sweep in words."""

import math
import re
from collections.abc import Iterable, Sequence

from verify.sweep.axes import Axis, Tolerance
from verify.sweep.indices import Estimate, Scatter
from verify.sweep.outcome import Course
from verify.sweep.plan import Plan
from verify.sweep.region import UNDECIDED, UNSOLVED, Break, Region
from verify.sweep.tables import REFUSED


def box_in_words(plan: Plan, one: Region) -> str:
    """Where the formula stays within the limit."""
    if one.everywhere:
        return f"all {one.points:,} points"
    if not one.inside:
        between = f", {one.undecided:,} undecided" if one.undecided else ""
        return f"nowhere{between}" if one.unsolved < one.points else "nothing is solved"
    solved = one.points - one.unsolved
    ranges = ", ".join(
        f"{r.axis.symbol} {_ends(r.axis, r.low, r.high)}{' (all)' if r.whole else ''}"
        for r in one.box
    )
    alone = ", one input at a time" if plan.star else ""
    if one.inside == solved:
        return f"all {solved:,} points that are solved; {ranges}{alone}"
    return f"{ranges}{alone}; {one.inside:,} of {solved:,} points"


def break_in_words(plan: Plan, one: Region) -> str:
    """What takes the formula out of the limit first; "" where nothing does, or it never is in."""
    if one.base is None:
        return ""
    start = "" if one.nominal else f"from {place(plan.axes, one.base)}, "
    if not one.nominal and one.at_nominal is not None:
        start = f"not at the inputs' own values; {start}"
    if (by := one.breaks) is None:
        return f"{start}nothing breaks it along one axis" if not one.everywhere else ""
    return f"{start}first broken by {_broken(by)}"


def _broken(by: Break) -> str:
    axis = by.axis
    way = f"{axis.symbol} {'above' if by.up else 'below'}"
    if by.verdict == UNSOLVED:
        what = "refused" if by.why.startswith(REFUSED) else "not solved"
        return (
            f"{way} {_valued(axis, by.last)}: {_valued(axis, by.first)} is {what} ({bare(by.why)})"
        )
    doubt = ", where the error bar reaches beyond" if by.verdict == UNDECIDED else ""
    if by.at is None:
        return f"{way} {_valued(axis, by.last)}{doubt}"
    low, high = sorted((by.last, by.first))
    between = f"between {axis.shown(low):.4g} and {_valued(axis, high)}"
    return f"{way} {_valued(axis, by.at)} ({between}){doubt}"


def bare(why: str) -> str:
    """A reason without saying again that inputs are refused."""
    return re.sub(rf"^({REFUSED}: )?(inputs(: |\.))?", "", why)


def error_with_bar(course: Course, n: int) -> str:
    """The error of a point in percent with its expanded uncertainty, to the latter's digits."""
    error, bar = 100 * float(course.error[n]), 100 * float(course.U_error[n])
    if not bar > 0:
        return f"{error:+.3g} %"
    digits = min(max(0, 1 - math.floor(math.log10(bar))), 6)
    if bar < 0.5 * 10**-digits:
        return f"{error:+.3g} % ± {bar:.1g} %"
    return f"{error:+.{digits}f} ± {bar:.{digits}f} %"


def ranked(scatter: Scatter) -> list[tuple[str, str, str]]:
    """The inputs by what they cause alone (S1) and in all (ST), with 95 % intervals, as cells."""
    return [
        (index.tolerance.symbol, f"S1 {_index(index.first)}", f"ST {_index(index.total)}")
        for index in scatter.ranked
    ]


def _index(of: Estimate) -> str:
    return f"{of.value:.2f} ({of.low:.2f} to {of.high:.2f})"


def place(varied: Sequence[Axis | Tolerance], values: Iterable[float]) -> str:
    """The values [SI] of the inputs that vary, with their symbols and units."""
    return ", ".join(f"{a.symbol} {_valued(a, v)}" for a, v in zip(varied, values, strict=True))


def _valued(one: Axis | Tolerance, value: float) -> str:
    unit = "" if one.unit == "1" else f" {one.unit}"
    return f"{one.shown(value):.4g}{unit}"


def _ends(axis: Axis, low: float, high: float) -> str:
    unit = "" if axis.unit == "1" else f" {axis.unit}"
    if low == high:
        return _valued(axis, low)
    return f"{axis.shown(low):.4g}..{axis.shown(high):.4g}{unit}"

"""Texts for the regions, errors and indices of a sweep."""

import math
import re
from collections.abc import Iterable, Sequence

from verify.studies.sweep.axes import Axis, Tolerance
from verify.studies.sweep.indices import Estimate, Scatter
from verify.studies.sweep.outcome import Course
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.region import UNDECIDED, UNSOLVED, Break, Region
from verify.studies.sweep.tables import REFUSED

SMALL = 1e-4  # per cent: a smaller bar is not printed


def box_in_words(plan: Plan, one: Region) -> str:
    """Text for the range in which the formula is within the limit."""
    if not one.inside:
        between = f", {one.undecided:,} undecided" if one.undecided else ""
        return f"nowhere{between}" if one.unsolved < one.points else "no point is solved"
    solved = one.points - one.unsolved
    ranges = (
        ", ".join(
            f"{r.axis.symbol} {ends(r.axis, r.low, r.high)}"
            f"{' (all)' if r.whole and not one.everywhere else ''}"
            for r in one.box
        )
        + ", one input at a time" * plan.star
    )
    held = f"{'ranges' if plan.star else 'a box'} of {one.held:,} points, "
    box = ranges if one.held == one.inside else f"{held}{ranges}"
    if one.inside == solved:
        return f"all {solved:,} points{' that are solved' if one.unsolved else ''}: {box}"
    of = f"{one.inside:,} of {solved:,} points"
    return f"{box}; {of}{'' if one.held == one.inside else ' in all'}"


def break_in_words(plan: Plan, one: Region) -> str:
    """Text for the first limit violation along one input; empty if there is none."""
    if one.base is None:
        return ""
    start = "" if one.nominal else f"from {place(plan.axes, one.base)}, "
    if not one.nominal and one.at_nominal is not None:
        start = f"not met at the file values; {start}"
    if (by := one.breaks) is None:
        together = ", only several inputs together do" if one.outside else ""
        return "" if one.everywhere else f"{start}no single input exceeds the limit{together}"
    return f"{start}{_broken(by)}"


def _broken(by: Break) -> str:
    axis = by.axis
    if by.verdict == UNSOLVED:  # no statement about the formula
        what = "refused" if by.why.startswith(REFUSED) else "not solved"
        return (
            f"no result beyond {axis.symbol} = {valued(axis, by.last)}: "
            f"{valued(axis, by.first)} is {what} ({bare(by.why)})"
        )
    side = f"first exceeded for {axis.symbol} {'above' if by.up else 'below'}"
    doubt = ", where the error bar crosses the limit" if by.verdict == UNDECIDED else ""
    if by.at is None:
        return f"{side} {valued(axis, by.last)}{doubt}"
    low, high = sorted((by.last, by.first))
    between = f"between {axis.in_unit(low):.4g} and {valued(axis, high)}"
    return f"{side} {valued(axis, by.at)} ({between}){doubt}"


def bare(why: str) -> str:
    """Reason `why` without the prefix which states that the inputs are refused."""
    return re.sub(rf"^({REFUSED}: )?(inputs(: |\.))?", "", why)


def error_with_bar(course: Course, n: int) -> str:
    """Error of point `n` in percent with its expanded uncertainty, as text.

    The uncertainty has two digits and sets the digits of the error. An uncertainty below a
    thousandth of the error, or below SMALL, is printed as an upper bound.
    """
    error, bar = 100 * float(course.error[n]), 100 * float(course.U_error[n])
    if not bar > 0:
        return f"{error:+.3g} %"
    power = math.floor(math.log10(max(abs(error) / 1000, SMALL)))
    if bar >= 10**power:
        digits = max(0, 1 - math.floor(math.log10(bar)))
        return f"{error:+.{digits}f} ± {bar:.{digits}f} %"
    digits = max(0, -power)
    least = f"< {10**power:.{digits}f} %"
    return f"{error:+.{digits}f} ± {least}" if abs(error) + bar >= 10**power else least


def ranked(scatter: Scatter) -> list[tuple[str, str, str]]:
    """Cells with the inputs and their indices (S1, ST) with 95 % intervals, largest ST first."""
    return [
        (index.tolerance.symbol, f"S1 {_index(index.first)}", f"ST {_index(index.total)}")
        for index in scatter.ranked
    ]


def _index(of: Estimate) -> str:
    return f"{of.value:.2f} ({of.low:.2f} to {of.high:.2f})"


def place(varied: Sequence[Axis | Tolerance], values: Iterable[float]) -> str:
    """Values [SI] of the varied inputs as text, with their symbols and units."""
    return ", ".join(f"{a.symbol} {valued(a, v)}" for a, v in zip(varied, values, strict=True))


def valued(one: Axis | Tolerance, value: float) -> str:
    """`value` [SI] as text in the unit of the input."""
    unit = "" if one.unit == "1" else f" {one.unit}"
    return f"{one.in_unit(value):.4g}{unit}"


def ends(axis: Axis, low: float, high: float) -> str:
    """A range of values [SI] as text in the unit of the axis: "2..6 mm"."""
    unit = "" if axis.unit == "1" else f" {axis.unit}"
    if low == high:
        return valued(axis, low)
    return f"{axis.in_unit(low):.4g}..{axis.in_unit(high):.4g}{unit}"

"""Output of `freewheel sweep`: solved points; place and causes of the errors of each formula."""

import math
import re
import textwrap
from collections import Counter
from collections.abc import Callable, Iterator, Sequence

from verify.core import units
from verify.core.console import aligned, raised
from verify.studies.sweep.axes import Axis, Tolerance
from verify.studies.sweep.console_table import MOST_ROWS, WIDE, counted, table, worst
from verify.studies.sweep.indices import LOOSE, NOISY, Scatter, indices
from verify.studies.sweep.messages import (
    bare,
    box_in_words,
    break_in_words,
    ends,
    place,
    ranked,
    valued,
)
from verify.studies.sweep.outcome import Course, Outcome
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.region import regions
from verify.studies.sweep.tables import SOLVED, largest, quantities, reasons, statuses

Verdict = Callable[[Plan, Course], str]
LINES = 30  # from which on no further row is printed in full
MOST_REASONS = 3
MOST_INPUTS = 6
MOST_DIGITS = 6  # after the point
_NUMBER = re.compile(r"\d[\d.,]*(?:e[-+]?\d+)?")
INDICES = (
    "S1 is the share of the variance that an input causes alone, ST its share including "
    "interactions with other inputs; brackets contain 95 % intervals; ± is the standard deviation"
)


def print_outcome(found: Outcome, verdict: Verdict = lambda *_: "") -> None:
    """Print the states of the points, the rows with the largest errors, and regions or indices.

    `verdict` returns a text with the verdict on a compared row; it is only used for grids.
    """
    for line in lines_of(found, verdict):
        print(line)


def lines_of(found: Outcome, verdict: Verdict = lambda *_: "") -> list[str]:
    """Lines of `print_outcome`, at most WIDE characters wide.

    Rows are described in full until there are LINES lines.
    """
    lines_of_table, placed = table(found)
    plan, detailed = found.solved.plan, 0
    first = (*_points(found), *_own_values(plan), *lines_of_table)
    lines = [part for line in first for part in _wrapped(line)]
    explained = [part for line in _explained(found) for part in _wrapped(line)]
    for course in worst(found):
        at = "" if placed else _furthest(plan, course)
        of = (
            _of_sample(plan, course, at) if plan.base
            else _of_grid(plan, course, at, verdict(plan, course))
        )  # fmt: skip
        more = [part for line in of for part in _wrapped(line)]
        if detailed and len(lines) + len(more) + len(explained) >= LINES:
            break
        lines += more
        detailed += 1
    lines += explained
    if left := len(found.courses) - detailed:
        where = "sensitivity.csv" if plan.base else "validity.csv"
        lines.append(f"({counted(left, 'more row')} in {where})")
    return lines


def _own_values(plan: Plan) -> Iterator[str]:
    """Lines about axes whose range does not contain the value in the file."""
    for one in plan.axes:
        low, high = one.values[0], one.values[-1]
        room = 1e-9 * (high - low)
        if one.nominal is not None and not low - room <= one.nominal <= high + room:
            given = f"{one.symbol} {valued(one, one.nominal)}"
            yield f"{given} of the file is outside {ends(one, low, high)}"


def _explained(found: Outcome) -> Iterator[str]:
    """Lines that explain the indices and warn of a small sample; none for a grid."""
    plan = found.solved.plan
    if not plan.base:
        return
    shown = [indices(plan, course) for course in worst(found)[:MOST_ROWS]]
    scatters = [s for one in shown for s in (one.fe, one.error)]
    if any(s.indices for s in scatters):
        yield INDICES
    if (widest := max(s.widest for s in scatters)) > LOOSE:
        yield (
            f"the sample is small: intervals are up to ±{widest / 2:.2f}; "
            f"sobol:{4 * plan.base} would halve them"
        )


def _points(found: Outcome) -> Iterator[str]:
    counts = Counter(statuses(found))
    whole = len(found.solved.plan.points)
    others = [f"{n:,} {name}" for name, n in counts.most_common() if name != SOLVED]
    if partly := sum(map(bool, reasons(found))) - whole + counts[SOLVED]:
        others.append(f"{partly:,} solved points lack some rows")
    yield f"{counts[SOLVED]:,} of {whole:,} points solved" + "".join(f", {o}" for o in others)
    groups: dict[str, list[str]] = {}
    for reason in filter(None, reasons(found)):
        groups.setdefault(_NUMBER.sub("#", reason), []).append(bare(reason))
    why = sorted(groups.values(), key=len, reverse=True)
    for some in why[:MOST_REASONS]:
        such = "such as: " if len(set(some)) > 1 else ""
        yield f"  {counted(len(some), 'point')}: {such}{some[0]}"
    if len(why) > MOST_REASONS:
        yield f"  and {counted(len(why) - MOST_REASONS, 'more reason')} in points.csv"


def _furthest(plan: Plan, course: Course) -> str:
    n = largest(course)
    varied: Sequence[Axis | Tolerance] = plan.axes or plan.tolerances
    return "" if n is None else f", largest error at {place(varied, plan.points[n])}"


def _of_grid(plan: Plan, course: Course, at: str, verdict: str) -> Iterator[str]:
    """Lines for one compared row over a grid: verdict, and regions within each limit."""
    yield f"{course.pair.name}{at}"
    if verdict:
        yield f"  verdict over this sweep: {verdict}"
    equal: dict[tuple[str, str], list[str]] = {}
    for one in regions(plan, course):
        words = box_in_words(plan, one), break_in_words(plan, one)
        equal.setdefault(words, []).append(f"{100 * one.limit:g}")
    for (box, breaks), limits in equal.items():
        yield f"  within {_listed(limits)} %: {box}"
        if breaks:
            yield f"    {breaks}"


def _of_sample(plan: Plan, course: Course, at: str) -> Iterator[str]:
    """Lines for one compared row over a sample: scatter of reference and error, with causes."""
    one = indices(plan, course)
    lost = f" ({counted(one.dropped, 'row')} of the sample left out: not solved)"
    yield f"{course.pair.name}{at}{lost if one.dropped else ''}"
    for what, scatter, unit in quantities(one)[1:]:
        if scatter.n:
            of = " of the solved points" * (scatter.n < 2 * plan.base)
            yield f"  {what}{of} {_moments(scatter, unit)}"
        if scatter.why:
            yield f"    no indices: {scatter.why}"
        else:
            yield from (f"    {line}" for line in aligned(ranked(scatter)[:MOST_INPUTS]))
            if (more := len(scatter.indices) - MOST_INPUTS) > 0:
                yield f"    ({more} more in sensitivity.csv)"
        if not scatter.why and scatter.noise > NOISY:
            yield (
                f"    doubtful: {100 * scatter.noise:.0f} % of the variance may be the "
                "uncertainty of the finite elements"
            )


def _moments(scatter: Scatter, unit: str) -> str:
    """Mean, standard deviation and quantiles as text, to the second digit of the deviation."""
    size = units.factor(unit)
    mean, sd, low, median, high = (
        v / size for v in (scatter.mean, scatter.sd, scatter.low, scatter.median, scatter.high)
    )
    digits = 1 - math.floor(math.log10(sd)) if sd > 0 else 99
    form = f".{max(digits, 0)}f" if digits <= MOST_DIGITS else ".5g"
    after = "" if unit == "1" else f" {unit}"
    return (
        f"{mean:{form}} ± {sd:.2g}{after}; 2.5 % {low:{form}}, 50 % {median:{form}}, "
        f"97.5 % {high:{form}}"
    )


def _listed(words: Sequence[str]) -> str:
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1])))


def _wrapped(line: str) -> list[str]:
    """`line` split into lines of at most WIDE characters; continuation lines are indented."""
    line = raised(line)
    if len(line) <= WIDE:
        return [line]
    inset = " " * (len(line) - len(line.lstrip()) + 4)
    return textwrap.wrap(line, WIDE, subsequent_indent=inset, break_on_hyphens=False)

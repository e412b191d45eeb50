"""What `freewheel sweep` prints: what was solved, how wrong each formula is, and where or why."""

import math
import re
import textwrap
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence, Set
from itertools import groupby

from verify import units
from verify.sweep.axes import Axis, Tolerance
from verify.sweep.indices import LOOSE, NOISY, Scatter, Within, indices
from verify.sweep.outcome import Course, Outcome
from verify.sweep.plan import Plan
from verify.sweep.region import Region, regions
from verify.sweep.tables import SOLVED, largest, quantities, reasons, statuses
from verify.sweep.words import (
    bare,
    box_in_words,
    break_in_words,
    ends,
    error_with_bar,
    place,
    ranked,
    valued,
)
from verify.told import aligned, raised

WIDE = 80
NAME = 28  # characters of a row's name that there is always room for
MOST_ROWS = 10  # the worst ones
LINES = 30  # from which on no further row is told in full
MOST_REASONS = 3
MOST_INPUTS = 6
MOST_DIGITS = 6  # after the point
_NUMBER = re.compile(r"\d[\d.,]*(?:e[-+]?\d+)?")
INDICES = (
    "S1 is the share of the variance that an input causes alone, ST with its interactions, in "
    "brackets the intervals of 95 %; ± is the standard deviation there"
)


def print_outcome(found: Outcome) -> None:
    """Points and what became of them, the rows that are furthest off, regions or indices."""
    for line in told(found):
        print(line)


def told(found: Outcome) -> list[str]:
    """The lines of `print_outcome`, no wider than WIDE; rows in full until there are LINES."""
    table, placed = _table(found)
    plan, detailed = found.solved.plan, 0
    first = (*_points(found), *_own_values(plan), *table)
    lines = [part for line in first for part in _wrapped(line)]
    explained = [part for line in _explained(found) for part in _wrapped(line)]
    for course in worst(found):
        at = "" if placed else _furthest(plan, course)
        of = _of_sample(plan, course, at) if plan.base else _of_grid(plan, course, at)
        more = [part for line in of for part in _wrapped(line)]
        if detailed and len(lines) + len(more) + len(explained) >= LINES:
            break
        lines += more
        detailed += 1
    lines += explained
    if left := len(found.courses) - detailed:
        where = "sensitivity.csv" if plan.base else "validity.csv"
        lines.append(f"({_count(left, 'more row')} in {where})")
    return lines


def _own_values(plan: Plan) -> Iterator[str]:
    """The axes that leave out what the file itself has."""
    for one in plan.axes:
        low, high = one.values[0], one.values[-1]
        room = 1e-9 * (high - low)
        if one.nominal is not None and not low - room <= one.nominal <= high + room:
            own = f"{one.symbol} {valued(one, one.nominal)}"
            yield f"the file's own {own} lies outside of {ends(one, low, high)}"


def _explained(found: Outcome) -> Iterator[str]:
    """What indices are, and whether the sample is too small for them; nothing of a grid."""
    plan = found.solved.plan
    if not plan.base:
        return
    shown = [indices(plan, course) for course in worst(found)[:MOST_ROWS]]
    scatters = [s for one in shown for s in (one.fe, one.error)]
    if any(s.indices for s in scatters):
        yield INDICES
    if (widest := max(s.widest for s in scatters)) > LOOSE:
        yield (
            f"the sample is small: intervals are up to ±{widest / 2:.2f} wide; "
            f"sobol:{4 * plan.base} would halve them"
        )


def worst(found: Outcome) -> list[Course]:
    """The courses, the one with the largest error first, those without any last."""
    sizes = {id(c): -1.0 if (n := largest(c)) is None else abs(float(c.error[n]))
             for c in found.courses}  # fmt: skip
    return sorted(found.courses, key=lambda c: -sizes[id(c)])


def _points(found: Outcome) -> Iterator[str]:
    counts = Counter(statuses(found))
    whole = len(found.solved.plan.points)
    others = [f"{n:,} {name}" for name, n in counts.most_common() if name != SOLVED]
    yield f"{counts[SOLVED]:,} of {whole:,} points solved" + "".join(f", {o}" for o in others)
    alike: dict[str, list[str]] = {}
    for reason in filter(None, reasons(found)):
        alike.setdefault(_NUMBER.sub("#", reason), []).append(bare(reason))
    why = sorted(alike.values(), key=len, reverse=True)
    for some in why[:MOST_REASONS]:
        such = "such as: " if len(set(some)) > 1 else ""
        yield f"  {_count(len(some), 'point')}: {such}{some[0]}"
    if len(why) > MOST_REASONS:
        yield f"  and {_count(len(why) - MOST_REASONS, 'more reason')} in points.csv"


def _table(found: Outcome) -> tuple[list[str], bool]:
    """A line a row: largest error, shares inside the limits, and where if there is room for it."""
    shown, plan = worst(found)[:MOST_ROWS], found.solved.plan
    inside = [_inside(plan, course) for course in shown]
    varied: Sequence[Axis | Tolerance] = plan.axes or plan.tolerances
    where = ", ".join(f"{o.symbol}{f'/{o.unit}' if o.unit != '1' else ''}" for o in varied)
    limits = [f"≤{100 * limit:g} %" for limit, _ in inside[0]]
    lines = [("", "largest error", *limits, f"at {where}")]
    for course, shares in zip(shown, inside, strict=True):
        n = largest(course)
        error = "none" if n is None else error_with_bar(course, n)
        values = () if n is None else zip(varied, plan.points[n], strict=True)
        cells = (_percent(share) for _, share in shares)
        at = ", ".join(f"{one.shown(v):.4g}" for one, v in values)
        lines.append(("", error, *cells, at))
    names = [course.pair.name for course in shown]
    # names that can be told apart go before the place, which is with the row then
    short = shortened(names, max(NAME, _room(lines)))
    placed = _room(lines) >= max(map(len, short)) and len({*short}) == len({*names})
    if not placed:
        lines = [line[:-1] for line in lines]
        short = shortened(names, max(NAME, _room(lines)))
    heads = ("", *short)
    told_of = aligned([(head, *line[1:]) for head, line in zip(heads, lines, strict=True)])
    if more := worst(found)[len(shown) :]:
        errors = [largest(course) is not None for course in more]
        what = "smaller errors" + " or none" * (not all(errors)) if any(errors) else "no error"
        told_of.append(f"({_count(len(more), 'more row')} with {what} in points.csv)")
    return told_of, placed


def _room(lines: Sequence[tuple[str, ...]]) -> int:
    """Characters of a line that the columns but the first leave."""
    return WIDE - max(map(len, aligned([("", *line[1:]) for line in lines])))


def shortened(names: Sequence[str], room: int) -> list[str]:
    """Names of at most `room` characters: longer ones lose words, those first that most have."""
    common = Counter(word for name in names for word in set(name.split()))
    return [name if len(name) <= room else _cut(name, common, room) for name in names]


def _cut(name: str, common: Mapping[str, int], room: int) -> str:
    """The name without words that most others have too, those in its middle first."""
    words = name.split()
    middle = (len(words) - 1) / 2
    order = sorted(range(len(words)), key=lambda k: (-common[words[k]], abs(k - middle)))
    kept = set(range(len(words)))
    for k in order:
        if len(_gapped(words, kept)) <= room:
            break
        kept.remove(k)
    for k in reversed(order):  # a gap is as long as a short word
        if len(_gapped(words, kept | {k})) <= room:
            kept.add(k)
    return _gapped(words, kept) if kept else f"{name[: room - 1]}…"


def _gapped(words: Sequence[str], kept: Set[int]) -> str:
    """The words that are kept, "…" where some are not."""
    shown = (word if k in kept else "…" for k, word in enumerate(words))
    return " ".join(word for word, _ in groupby(shown))


def _furthest(plan: Plan, course: Course) -> str:
    n = largest(course)
    varied: Sequence[Axis | Tolerance] = plan.axes or plan.tolerances
    return "" if n is None else f", furthest off at {place(varied, plan.points[n])}"


def _inside(plan: Plan, course: Course) -> Sequence[tuple[float, float]]:
    """Shares of the solved points inside each limit, NaN where none is."""
    of: Sequence[Within | Region]
    of = indices(plan, course).within if plan.base else regions(plan, course)
    return [
        (one.limit, one.inside / solved if solved else math.nan)
        for one in of for solved in [one.inside + one.outside + one.undecided]
    ]  # fmt: skip


def _of_grid(plan: Plan, course: Course, at: str) -> Iterator[str]:
    """The regions in words, limits alike together."""
    yield f"{course.pair.name}{at}"
    alike: dict[tuple[str, str], list[str]] = {}
    for one in regions(plan, course):
        words = box_in_words(plan, one), break_in_words(plan, one)
        alike.setdefault(words, []).append(f"{100 * one.limit:g}")
    for (box, breaks), limits in alike.items():
        yield f"  within {_listed(limits)} %: {box}"
        if breaks:
            yield f"    {breaks}"


def _of_sample(plan: Plan, course: Course, at: str) -> Iterator[str]:
    """Finite elements and the error, how they scatter and through what."""
    one = indices(plan, course)
    lost = f" ({_count(one.dropped, 'row')} of the sample left out: not solved)"
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
                f"    doubtful: {100 * scatter.noise:.0f} % of the variance may be the finite "
                "elements' own uncertainty"
            )


def _moments(scatter: Scatter, unit: str) -> str:
    """Mean and standard deviation to two digits of the latter, and quantiles."""
    size = units.factor(unit)
    mean, sd, low, median, high = (
        v / size for v in (scatter.mean, scatter.sd, scatter.low, scatter.median, scatter.high)
    )
    digits = 1 - math.floor(math.log10(sd)) if sd > 0 else 99
    shown = f".{max(digits, 0)}f" if digits <= MOST_DIGITS else ".5g"
    told_unit = "" if unit == "1" else f" {unit}"
    return (
        f"{mean:{shown}} ± {sd:.2g}{told_unit}; 2.5 % {low:{shown}}, 50 % {median:{shown}}, "
        f"97.5 % {high:{shown}}"
    )


def _percent(share: float) -> str:
    """Whole percent, 100 only for all, nothing where none is known."""
    if math.isnan(share):
        return ""
    return f"{min(100 * share, 99) if share < 1 else 100:.0f} %"


def _count(number: int, what: str) -> str:
    return f"{number:,} {what}{'s' if number > 1 else ''}"


def _listed(words: Sequence[str]) -> str:
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1])))


def _wrapped(line: str) -> list[str]:
    """At most WIDE characters, what goes on set in further than its beginning."""
    line = raised(line)
    if len(line) <= WIDE:
        return [line]
    inset = " " * (len(line) - len(line.lstrip()) + 4)
    return textwrap.wrap(line, WIDE, subsequent_indent=inset, break_on_hyphens=False)

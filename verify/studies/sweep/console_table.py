"""Table that `freewheel sweep` prints: compared rows with the largest errors."""

import math
from collections import Counter
from collections.abc import Mapping, Sequence, Set
from itertools import groupby

from verify.core.console import aligned
from verify.studies.sweep.axes import Axis, Tolerance
from verify.studies.sweep.indices import Within, indices
from verify.studies.sweep.messages import error_with_bar
from verify.studies.sweep.outcome import Course, Outcome
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.region import Region, regions
from verify.studies.sweep.tables import largest

WIDE = 80
NAME = 28  # characters of a row's name that there is always room for
MOST_ROWS = 10  # the worst ones


def table(found: Outcome) -> tuple[list[str], bool]:
    """Lines of the table, and whether they state the place of the largest error.

    A line contains the name of the row, its largest error, and the shares of points within the
    limits. The place is omitted if it leaves too little space for distinguishable names.
    """
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
        at = ", ".join(f"{one.in_unit(v):.4g}" for one, v in values)
        lines.append(("", error, *cells, at))
    names = [course.pair.name for course in shown]
    # distinguishable names have priority over the place, which is then printed with the row
    short = shortened(names, max(NAME, _room(lines)))
    placed = _room(lines) >= max(map(len, short)) and len({*short}) == len({*names})
    if not placed:
        lines = [line[:-1] for line in lines]
        short = shortened(names, max(NAME, _room(lines)))
    heads = ("", *short)
    printed = aligned([(head, *line[1:]) for head, line in zip(heads, lines, strict=True)])
    if more := worst(found)[len(shown) :]:
        errors = [largest(course) is not None for course in more]
        what = "smaller errors" + " or none" * (not all(errors)) if any(errors) else "no error"
        printed.append(f"({counted(len(more), 'more row')} with {what} in points.csv)")
    return printed, placed


def _room(lines: Sequence[tuple[str, ...]]) -> int:
    """Number of characters that remain for the first column of the table."""
    return WIDE - max(map(len, aligned([("", *line[1:]) for line in lines])))


def shortened(names: Sequence[str], room: int) -> list[str]:
    """Names of at most `room` characters: longer names lose their most common words."""
    common = Counter(word for name in names for word in set(name.split()))
    return [name if len(name) <= room else _cut(name, common, room) for name in names]


def _cut(name: str, common: Mapping[str, int], room: int) -> str:
    """`name` without its most common words, middle words first, in at most `room` characters."""
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
    """The remaining words as text, with "…" for omitted words."""
    shown = (word if k in kept else "…" for k, word in enumerate(words))
    return " ".join(word for word, _ in groupby(shown))


def _inside(plan: Plan, course: Course) -> Sequence[tuple[float, float]]:
    """Each limit with the share of the solved points within it; NaN if no point is solved."""
    of: Sequence[Within | Region]
    of = indices(plan, course).within if plan.base else regions(plan, course)
    return [
        (one.limit, one.inside / solved if solved else math.nan)
        for one in of for solved in [one.inside + one.outside + one.undecided]
    ]  # fmt: skip


def worst(found: Outcome) -> list[Course]:
    """Results of all rows in descending order of the largest error; rows without a value last."""
    sizes = {id(c): -1.0 if (n := largest(c)) is None else abs(float(c.error[n]))
             for c in found.courses}  # fmt: skip
    return sorted(found.courses, key=lambda c: -sizes[id(c)])


def _percent(share: float) -> str:
    """`share` in whole percent as text; "100 %" only for exactly 1, empty for NaN."""
    if math.isnan(share):
        return ""
    return f"{min(100 * share, 99) if share < 1 else 100:.0f} %"


def counted(number: int, what: str) -> str:
    """A number with its noun: "1 point", "2,000 points"."""
    return f"{number:,} {what}{'s' if number > 1 else ''}"

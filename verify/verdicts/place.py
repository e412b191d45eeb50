"""Position of a user's inputs relative to the ranges that a verdict compared."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import StrEnum

from verify.core.inputs import Inputs
from verify.core.verdicts import FormulaVerdict, Side, Verdict, VerdictRange
from verify.verdicts.words import percent, side_in_words

SAME = 1e-9  # relative: inputs that differ by less are equal
MOST_NAMED = 3  # inputs that a line names
WITHOUT_RANGE = (Verdict.DEFINITION, Verdict.UNVERIFIABLE, Verdict.WRONG, Verdict.NONE)


class Where(StrEnum):
    """Whether a formula was compared at such inputs, and is within a limit there."""

    INSIDE = "inside"
    OUTSIDE = "outside"
    NOT_COMPARED = "not compared"
    NONE = ""


@dataclass(frozen=True)
class Place:
    """Position of the inputs, and a sentence that states it."""

    where: Where
    words: str


def place(found: FormulaVerdict, case: str, inputs: Inputs) -> Place:
    """Position of a case's inputs relative to the ranges of a verdict."""
    if found.verdict in WITHOUT_RANGE:
        return Place(Where.NONE, "")
    if case not in found.cases:
        return Place(Where.NOT_COMPARED, f"compared in {', '.join(found.cases)}")
    mine, paper = _values(inputs), _values(type(inputs)())
    changed = [name for name in mine if not _equal(mine[name], paper.get(name))]
    if not changed:
        return Place(Where.INSIDE, "these are the default inputs of the case")
    ranges = sorted((r for r in found.ranges if r.case == case), key=lambda r: r.limit)
    symbols = {one.name: one.symbol for one in inputs.display()}
    for limit in dict.fromkeys(r.limit for r in ranges):
        of_limit = [r for r in ranges if r.limit == limit and _compares(r, mine, changed)]
        if of_limit and all(_holds(r, mine, changed) for r in of_limit):
            return Place(Where.INSIDE, f"inside the range with errors within {percent(limit)}")
    studied = {n: [s for r in ranges for s in r.studied if s.name == n] for n in changed}
    if other := [symbols[name] for name in changed if not studied[name]]:
        return Place(Where.NOT_COMPARED, f"not compared with another {_named(other)}")
    for name, sides in studied.items():
        if not any(_inside(side, mine[name]) for side in sides):
            return Place(Where.NOT_COMPARED, f"beyond what was compared: {_spans(sides)}")
    if len(changed) > 1 and all(r.is_star for r in ranges):
        both = _named([symbols[name] for name in changed])
        return Place(Where.NOT_COMPARED, f"not compared with {both} changed at once")
    return Place(Where.OUTSIDE, f"outside the range with errors within {percent(_last(ranges))}")


def _values(inputs: Inputs) -> Mapping[str, object]:
    return {one.name: one.value for one in inputs.display()}


def _equal(one: object, other: object) -> bool:
    if isinstance(one, int | float) and isinstance(other, int | float):
        return math.isclose(one, other, rel_tol=SAME)
    return one == other


def _compares(found: VerdictRange, mine: Mapping[str, object], changed: list[str]) -> bool:
    """Whether a study has such inputs between its ends."""
    if found.is_star and len(changed) > 1:
        return False
    sides = {side.name: side for side in found.studied}
    return all(n in sides and _inside(sides[n], mine[n]) for n in changed)


def _holds(found: VerdictRange, mine: Mapping[str, object], changed: list[str]) -> bool:
    """Whether a range was compared with these inputs changed, and holds their values."""
    sides = {side.name: side for side in found.box}
    if found.is_star and len(changed) > 1:
        return False
    return bool(sides) and all(n in sides and _inside(sides[n], mine[n]) for n in changed)


def _inside(side: Side, value: object) -> bool:
    if not isinstance(value, int | float):
        return False
    room = SAME * max(abs(side.low), abs(side.high))
    return side.low - room <= value <= side.high + room


def _named(symbols: list[str]) -> str:
    more = len(symbols) - MOST_NAMED
    return ", ".join(symbols[:MOST_NAMED]) + (f" and {more} more" if more > 0 else "")


def _spans(sides: list[Side]) -> str:
    """The range of one input over all studies: "T 6.5 to 52 N m"."""
    low, high = min(side.low for side in sides), max(side.high for side in sides)
    return side_in_words(replace(sides[0], low=low, high=high, ratio=""))


def _last(ranges: list[VerdictRange]) -> float | None:
    return ranges[-1].limit if ranges else None

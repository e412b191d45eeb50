"""Position of a user's inputs relative to the compared ranges of a verdict."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum

from verify.core.inputs import Inputs
from verify.core.verdicts import FormulaVerdict, Side, Verdict, VerdictRange
from verify.verdicts.independent import independent
from verify.verdicts.part import Part
from verify.verdicts.rule import CLASSES
from verify.verdicts.words import constant, percent, side_in_words

MOST_NAMED = 3  # inputs that a line names
DEFAULT = "these are the default inputs of the case"
DEFAULT_ERROR = "all inputs that change an error are the default inputs of the case"
WITHOUT_RANGE = (Verdict.DEFINITION, Verdict.UNVERIFIABLE, Verdict.WRONG, Verdict.NONE)


class Where(StrEnum):
    """Position of inputs: error within a limit, error beyond it, or inputs not compared."""

    INSIDE = "inside"
    OUTSIDE = "outside"
    NOT_COMPARED = "not compared"
    NONE = ""


@dataclass(frozen=True)
class Place:
    """Position of the inputs, and a text that states it."""

    where: Where
    words: str


def place(found: FormulaVerdict, case: str, inputs: Inputs) -> Place:
    """Position of the inputs of a case relative to the compared ranges of a verdict."""
    if found.verdict in WITHOUT_RANGE:
        return Place(Where.NONE, "")
    if case not in found.cases:
        return Place(Where.NOT_COMPARED, f"compared only in {', '.join(found.cases)}")
    free = independent(found, case)
    part = Part.of(inputs, free)
    if not part.changed():
        is_default = not Part.of(inputs, frozenset()).changed()
        return Place(_at_default(found, case), DEFAULT if is_default else DEFAULT_ERROR)
    ranges = sorted((_without(r, free) for r in found.ranges if r.case == case), key=_limit)
    apply = [r for r in ranges if part.is_varied(r)]
    if not apply:
        symbols = {one.name: one.symbol for one in inputs.display()}
        return Place(Where.NOT_COMPARED, _together(part, ranges, symbols))
    compared = [r for r in apply if part.is_within(r, r.studied)]
    if not compared:
        return Place(Where.NOT_COMPARED, f"outside the compared range: {_beyond(apply, part)}")
    for limit in dict.fromkeys(r.limit for r in compared):
        of_limit = [r for r in compared if r.limit == limit]
        if all(part.is_within(r, r.box) for r in of_limit):
            return Place(Where.INSIDE, f"inside the range with errors within {percent(limit)}")
    return Place(Where.OUTSIDE, _outside(of_limit, part))


def _without(found: VerdictRange, free: frozenset[str]) -> VerdictRange:
    """A range without the inputs in `free`, which change no error."""
    box, studied, held = (
        tuple(side for side in sides if side.name not in free)
        for sides in (found.box, found.studied, found.held)
    )
    return replace(found, box=box, studied=studied, held=held)


def _limit(one: VerdictRange) -> float:
    return one.limit


def _at_default(found: FormulaVerdict, case: str) -> Where:
    """OUTSIDE if the error at the default inputs of this case exceeds the widest accuracy class.

    The position is otherwise INSIDE. Only the case with the largest error can be OUTSIDE.
    """
    size = abs(found.error or 0.0) + (found.U or 0.0)
    is_here = found.worst_row.partition("/")[0] == case
    return Where.OUTSIDE if is_here and size > CLASSES[-1] else Where.INSIDE


def _together(part: Part, ranges: Sequence[VerdictRange], symbols: Mapping[str, str]) -> str:
    """Text of the changed inputs that no study contains; if there are none, of all changed ones."""
    changed = part.changed()
    known = {side.name for r in ranges for side in r.studied}
    known |= {side.name for r in ranges for side in r.held if part.is_inside(side)}
    if other := [symbols[name] for name in changed if name not in known]:
        return f"not compared with other values of {_named(other)}"
    both = _named([symbols[name] for name in changed])
    return (
        f"not compared with {both} "
        f"{'changed at once' if len(changed) > 1 else 'as the only changed input'}"
    )


def _beyond(ranges: Sequence[VerdictRange], part: Part) -> str:
    """Text with the compared range of the first input that is outside, and the constant inputs."""
    sides = [side for r in ranges for side in r.studied]
    for name in dict.fromkeys(side.name for side in sides):
        of_name = [side for side in sides if side.name == name]
        if not any(map(part.is_inside, of_name)):
            return _spans(of_name) + _at(ranges)
    return "; ".join(dict.fromkeys(r.over for r in ranges))


def _outside(ranges: Sequence[VerdictRange], part: Part) -> str:
    """Text with the ranges within the largest limit that do not contain the inputs.

    The range of a study is the largest range in which all errors are within the limit. Errors
    outside this range can be within the limit, too; this is certain if the range of another study
    contains the inputs.
    """
    limit = percent(ranges[0].limit)
    sides = [
        side for r in ranges for side in r.box
        if side.name in part.placed(r) and not part.is_inside(side)
    ]  # fmt: skip
    words = ", ".join(dict.fromkeys(side_in_words(replace(side, ratio="")) for side in sides))
    if any(part.is_within(r, r.box) for r in ranges):
        return (
            f"inside a range with errors within {limit}, outside such a range of another study: "
            f"{words}"
        )
    if not sides:
        return f"no compared error is within {limit}"
    return f"outside the range with all errors within {limit}: {words}"


def _named(symbols: list[str]) -> str:
    more = len(symbols) - MOST_NAMED
    return ", ".join(symbols[:MOST_NAMED]) + (f" and {more} more" if more > 0 else "")


def _at(ranges: Sequence[VerdictRange]) -> str:
    """Text of the constant inputs, " at z = 8", if all studies have the same; otherwise empty."""
    found = {constant(r) for r in ranges}
    return f" at {found.pop()}" if len(found) == 1 and "" not in found else ""


def _spans(sides: list[Side]) -> str:
    """Text of the range of one input over all studies: "T 6.5 to 52 N m"."""
    low, high = min(side.low for side in sides), max(side.high for side in sides)
    return side_in_words(replace(sides[0], low=low, high=high, ratio=""))

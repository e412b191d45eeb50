"""What takes a formula out of a limit first, in words."""

from verify.studies.sweep.region import OUTSIDE, UNDECIDED, UNSOLVED, Break, Region
from verify.studies.validity import messages as words

ALREADY = {
    OUTSIDE: "beyond {} at the case's own inputs already",
    UNDECIDED: "undecided at the case's own inputs already: the error bar reaches across {}",
    UNSOLVED: "no answer at the case's own inputs",
}


def breaks(found: Region) -> str:
    """What takes the formula out of the limit first, and from where, in words."""
    limit = f"{found.limit:.0%}".replace("%", " %")
    if found.base is None:
        nowhere = "" if found.inside else f", and no point is within {limit}"
        return f"{_at_nominal(found, limit)}{nowhere}"
    start = _start(found, limit)
    step = found.breaks
    if found.everywhere:
        return f"{start}nothing in what was measured takes it beyond {limit}"
    if found.inside + found.unsolved == found.points:
        # inputs that a rule refuses, or a run that ends, don't break a formula
        missing = "" if step is None else f"; {_unsolved(step)}"
        return f"{start}nothing that was solved takes it beyond {limit}{missing}"
    if step is None:
        return f"{start}no input alone takes it beyond {limit}, several together do"
    more = ""
    if step.verdict == UNSOLVED:
        # the step that comes first must not hide what breaks the formula elsewhere
        count = found.outside + found.undecided
        more = f"; elsewhere {count} point{'s are' if count > 1 else ' is'} not within it"
    return start + _broken(step, limit) + more


def _start(found: Region, limit: str) -> str:
    """From where the first break is looked for, unless that is as one expects."""
    if not found.nominal:
        return f"{_at_nominal(found, limit)}; from the middle of the box, "
    nominal = [(one, one.axis.nominal) for one in found.box]
    inside = all(v is None or one.low <= v <= one.high for one, v in nominal)
    return "" if inside else "from the case's own inputs, which are not in that box, "


def _broken(step: Break, limit: str) -> str:
    axis, towards = step.axis, f"{'larger' if step.up else 'smaller'} {step.axis.symbol}"
    if step.verdict == OUTSIDE:
        ends = words.between(axis, step.last, step.first)
        near = "" if step.at is None else words.near(axis, step.last, step.first, step.at)
        return f"{towards} takes it beyond {limit} between {ends}{near}"
    last, first = (words.quantity(axis, v) for v in (step.last, step.first))
    doubt = f"undecided at {first}: the error bar reaches across"
    then = doubt if step.verdict == UNDECIDED else _unsolved(step)
    return f"{towards}: within {limit} to {last}, {then}"


def _unsolved(step: Break) -> str:
    return f"no answer at {words.span(step.axis, step.first, step.first)}"


def _at_nominal(found: Region, limit: str) -> str:
    if found.at_nominal is None:
        return "the case's own inputs are not among what was measured"
    return ALREADY[found.at_nominal].format(limit)

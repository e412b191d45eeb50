"""Texts that state at which value of an input a formula first exceeds a limit."""

from verify.studies.sweep.region import OUTSIDE, UNDECIDED, UNSOLVED, Break, Region
from verify.studies.validity import messages as words

ALREADY = {
    OUTSIDE: "at the default inputs, the error exceeds {}",
    UNDECIDED: "at the default inputs, it is undecided whether the error is within {}, because the "
    "error bar crosses this limit",
    UNSOLVED: "there is no result at the default inputs",
}


def breaks(found: Region) -> str:
    """Text that states at which value of which input the formula first exceeds the limit."""
    limit = f"{100 * found.limit:.0f} %"
    if found.base is None:
        nowhere = "" if found.inside else f", and no point is within {limit}"
        return f"{_at_nominal(found, limit)}{nowhere}"
    start = _start(found, limit)
    step = found.breaks
    if found.everywhere:
        return f"{start}the error exceeds {limit} at no measured point"
    if found.inside + found.unsolved == found.points:
        # inputs that a rule rejects, or a run that ends, are no failure of a formula
        missing = "" if step is None else f"; {_unsolved(step)}"
        return f"{start}the error exceeds {limit} at no point that has a result{missing}"
    if step is None:
        return f"{start}the error exceeds {limit} only if several inputs are changed"
    more = ""
    if step.verdict == UNSOLVED:
        # the first step must not hide points beyond the limit on other axes
        count = found.outside + found.undecided
        more = f"; {count} other point{'s are' if count > 1 else ' is'} not within the limit"
    return start + _broken(step, limit) + more


def _start(found: Region, limit: str) -> str:
    """Start of the text if the search did not start at the default inputs; otherwise empty."""
    if not found.nominal:
        return (
            f"{_at_nominal(found, limit)}; therefore, the inputs are changed from the middle of "
            f"the range in which the error is within {limit}: "
        )
    nominal = [(one, one.axis.nominal) for one in found.box]
    inside = all(v is None or one.low <= v <= one.high for one, v in nominal)
    if inside:
        return ""
    return (
        f"the inputs are changed from the default inputs, where the error is within {limit}, "
        "although the default inputs are outside the stated range: "
    )


def _broken(step: Break, limit: str) -> str:
    axis, towards = step.axis, f"if {step.axis.symbol} is {'increased' if step.up else 'reduced'}"
    if step.verdict == OUTSIDE:
        ends = words.between(axis, step.last, step.first)
        near = "" if step.at is None else words.near(axis, step.last, step.first, step.at)
        return f"{towards}, the error first exceeds {limit} between {axis.symbol} = {ends}{near}"
    last, first = (words.quantity(axis, v) for v in (step.last, step.first))
    doubt = f"at {first}, the error bar crosses the limit (undecided)"
    then = doubt if step.verdict == UNDECIDED else _unsolved(step)
    return f"{towards}, the error is within {limit} as far as {axis.symbol} = {last}; {then}"


def _unsolved(step: Break) -> str:
    return f"there is no result at {words.span(step.axis, step.first, step.first)}"


def _at_nominal(found: Region, limit: str) -> str:
    if found.at_nominal is None:
        return "the default inputs are not among the measured points"
    return ALREADY[found.at_nominal].format(limit)

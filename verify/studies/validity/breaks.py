"""Texts that state at which value of an input a formula first exceeds a limit."""

from verify.studies.sweep.region import OUTSIDE, UNDECIDED, UNSOLVED, Break, Region
from verify.studies.validity import messages as words

ALREADY = {
    OUTSIDE: "the error exceeds {} already at the default inputs",
    UNDECIDED: "at the default inputs, it is undecided whether the error is within {}, because the "
    "error bar crosses this limit",
    UNSOLVED: "not solved at the default inputs",
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
        return f"{start}no measured point is beyond {limit}"
    if found.inside + found.unsolved == found.points:
        # inputs that a rule rejects, or a run that ends, are no failure of a formula
        missing = "" if step is None else f"; {_unsolved(step)}"
        return f"{start}no solved point is beyond {limit}{missing}"
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
            f"{_at_nominal(found, limit)}; in the middle of the stated range, the error is within "
            f"{limit}; from there, "
        )
    nominal = [(one, one.axis.nominal) for one in found.box]
    inside = all(v is None or one.low <= v <= one.high for one, v in nominal)
    if inside:
        return ""
    return (
        f"the error is within {limit} at the default inputs, although they are outside the stated "
        "range; from there, "
    )


def _broken(step: Break, limit: str) -> str:
    axis, towards = (
        step.axis,
        f"with {'increasing' if step.up else 'decreasing'} {step.axis.symbol}",
    )
    if step.verdict == OUTSIDE:
        ends = words.between(axis, step.last, step.first)
        near = "" if step.at is None else words.near(axis, step.last, step.first, step.at)
        return f"{towards}, the error first exceeds {limit} between {ends}{near}"
    last, first = (words.quantity(axis, v) for v in (step.last, step.first))
    doubt = f"it is undecided at {first}, because the error bar crosses the limit"
    then = doubt if step.verdict == UNDECIDED else _unsolved(step)
    return f"{towards}, the error is within {limit} as far as {last}; {then}"


def _unsolved(step: Break) -> str:
    return f"not solved at {words.span(step.axis, step.first, step.first)}"


def _at_nominal(found: Region, limit: str) -> str:
    if found.at_nominal is None:
        return "the default inputs are not among the measured points"
    return ALREADY[found.at_nominal].format(limit)

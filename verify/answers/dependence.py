"""Influence of the assumed inputs on the margin of a part."""

import math
from collections.abc import Sequence
from functools import partial

from verify.answers.assumed.influence import Influence, influence
from verify.answers.assumed.rules import Assumed
from verify.answers.registry import answer
from verify.core.case import Case, Values
from verify.core.inputs import Inputs

NOTABLE = 0.01  # relative change of the margin
MOST = 4  # inputs that are named


def margin_notes(case: Case, inputs: Inputs, assumed: Sequence[Assumed]) -> tuple[str, ...]:
    """Sentences that state how the smallest margin depends on the assumed inputs.

    The result is empty if no input is assumed, if there is no margin, or if the part fails for a
    reason other than a criterion.
    """
    if not assumed:
        return ()
    names = frozenset(one.name for one in assumed)
    middle = _margin(case, names, inputs, case.analytic(inputs))
    if not middle:  # no margin, or it fails for another reason
        return ()
    found = influence(case, inputs, assumed, partial(_margin, case, names))
    notable = [one for one in found if one.largest > NOTABLE]
    if not notable:
        return (f"no assumed input changes the margin by more than {100 * NOTABLE:.0f} %",)
    named = "; ".join(_sentence(one, middle) for one in notable[:MOST])
    more = f"; and {len(notable) - MOST} more" if len(notable) > MOST else ""
    return (f"of the assumed inputs the margin depends most on {named}{more}",)


def _margin(case: Case, assumed: frozenset[str], inputs: Inputs, values: Values) -> float | None:
    """Smallest margin; 0 if the part fails for a reason other than a criterion.

    None without criteria.
    """
    found = answer(case, inputs, values, assumed=assumed, with_design=False)
    if found.failures:
        return 0.0
    return None if found.limiting is None else found.limiting.margin


def _sentence(one: Influence, margin: float) -> str:
    unit = "" if one.assumed.unit == "1" else f" {one.assumed.unit}"
    ends = f"{one.assumed.symbol or one.assumed.name} = {one.low:.6g} to {one.high:.6g}{unit}"
    if one.at_low is None or one.at_high is None:
        return f"{ends}: {one.note}"
    low, high = (_changed(change, margin) for change in (one.at_low, one.at_high))
    return f"{ends}: {low} to {high}"


def _changed(change: float, margin: float) -> str:
    """Text of a relative change of the margin, with "(fails)" if it makes the part fail."""
    text = f"{100 * change:+.0f} %" if math.isfinite(change) else "no bound"
    return f"{text} (fails)" if margin >= 1 > (1 + change) * margin else text

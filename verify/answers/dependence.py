"""Which assumed inputs the margin of a part depends on."""

from collections.abc import Sequence
from functools import partial

from verify.answers.registry import answer
from verify.assumed.influence import Influence, influence
from verify.assumed.rules import Assumed
from verify.case import Case, Values
from verify.inputs import Inputs

NOTABLE = 0.01  # relative change of the margin
MOST = 4  # inputs that are named


def margin_notes(case: Case, inputs: Inputs, assumed: Sequence[Assumed]) -> tuple[str, ...]:
    """How far the smallest margin follows the assumed inputs; nothing where none is assumed."""
    if not assumed:
        return ()
    try:
        found = influence(case, inputs, assumed, partial(_margin, case))
    except ValueError:  # no margin with these inputs
        return ()
    notable = [one for one in found if one.largest > NOTABLE]
    if not notable:
        return (f"no assumed input changes the margin by more than {NOTABLE:.0%}",)
    named = "; ".join(map(_sentence, notable[:MOST]))
    more = f"; and {len(notable) - MOST} more" if len(notable) > MOST else ""
    return (f"of the assumed inputs the margin depends most on {named}{more}",)


def _margin(case: Case, inputs: Inputs, values: Values) -> float | None:
    worst = answer(case, inputs, values, with_design=False).limiting
    return None if worst is None else worst.margin


def _sentence(one: Influence) -> str:
    unit = "" if one.assumed.unit == "1" else f" {one.assumed.unit}"
    ends = f"{one.assumed.symbol or one.assumed.name} = {one.low:.4g} to {one.high:.4g}{unit}"
    if one.at_low is None or one.at_high is None:
        return f"{ends}: {one.note}"
    return f"{ends}: {one.at_low:+.0%} to {one.at_high:+.0%}"

"""Check that an expected error is independent of the formula that it judges.

The check also changes intermediate and shared values that both the formula and the expected error
read: a mistake in such a value would change both.
"""

from contextlib import suppress
from math import isfinite

from verify.form.case import Case
from verify.form.comparisons import Comparison, Computed, Expected
from verify.form.quantity import CHANGE, Quantity, changed, read_by

SHARE = 0.1  # over a change of the formula: an interval may depend weakly on the formula
LEAST = 0.25 * CHANGE  # least change of a formula by a quantity that it reads


def check(case: Case, one: Comparison) -> None:
    """Raise CaseError if a change of the formula also changes its expected error."""
    if one.quantity and (read := follows(case, one)):
        both = "this formula" if read == one.quantity.name else f"{read}, as this formula does"
        rule = f"its expected error reads {both}: a mistake in this value would make no row fail"
        raise one.quantity.broken(rule)


def follows(case: Case, one: Comparison) -> str:
    """Name of a value on which a formula and its expected error depend; empty if there is none.

    The value is the formula itself, or another formula or value that the formula reads.
    """
    if one.quantity is None or (before := _interval(one)) is None:
        return ""
    formula = _value(case, one)
    for source, name in read_by(lambda: _value(case, one)).items():
        if isinstance(source, Quantity) and source.role == "geometry":
            continue
        with changed(source), suppress(ArithmeticError, ValueError):
            other = next((o for o in case.stated() if o.name == one.name), one)
            moved = _value(case, other) / formula - 1
            if not isfinite(moved) or abs(moved) < LEAST:
                continue
            after = _interval(other) or before
            along = (a - b if moved > 0 else b - a for a, b in zip(after, before, strict=True))
            if max(along) > SHARE * abs(moved):
                return name
    return ""


def _value(case: Case, one: Comparison) -> float:
    """Value of the quantity that a comparison judges."""
    own = one.state.case if one.state and one.state.case else case
    return float(getattr(own, one.quantity.name)) if one.quantity else 0.0


def _interval(one: Comparison) -> tuple[float, float] | None:
    if isinstance(one.expected, Computed):
        return one.expected.interval()
    return one.expected[:2] if isinstance(one.expected, Expected) else None

"""Whether an expected error stands by itself: it may not follow the formula that it judges."""

from verify.form.case import Case
from verify.form.comparisons import Comparison, Computed, Expected
from verify.form.quantity import CHANGE, changed

SHARE = 0.1  # of a change of the formula: an interval may depend on its size, as of a mesh over it


def check(case: Case, one: Comparison) -> None:
    """CaseError where a change of the formula moves its expected error along."""
    if one.quantity and follows(case, one):
        rule = "its expected error reads this formula, so that a mistake in it fails no row"
        raise one.quantity.broken(rule)


def follows(case: Case, one: Comparison) -> bool:
    """Whether the expected error of a comparison moves with a small change of its formula."""
    if one.quantity is None or (before := _interval(one)) is None:
        return False
    with changed(one.quantity):
        other = next((o for o in case.stated() if o.name == one.name), one)
        after = _interval(other) or before
    return max(a - b for a, b in zip(after, before, strict=True)) > SHARE * CHANGE


def _interval(one: Comparison) -> tuple[float, float] | None:
    if isinstance(one.expected, Computed):
        return one.expected.interval()
    return one.expected[:2] if isinstance(one.expected, Expected) else None

"""Whether an expected error stands by itself: it may not follow the formula that it judges."""

from collections.abc import Iterator

from verify.form.case import Case
from verify.form.comparisons import Comparison, Computed, Expected
from verify.form.quantity import CHANGE, changed

SHARE = 0.1  # of a change of the formula: an interval may depend on its size, as of a mesh over it


def check(case: Case) -> None:
    """CaseError for the first expected error that a change of the formula moves along.

    An interval that is `Computed` is left out: it takes long.
    """
    for one in followers(case):
        assert one.quantity is not None
        raise one.quantity.broken(
            "its expected error reads this formula, so that a mistake in it fails no row"
        )


def followers(case: Case, *, computed: bool = False) -> Iterator[Comparison]:
    """The comparisons whose expected error follows the formula, also those that are `computed`."""
    for one in case.stated():
        if one.quantity is None or (before := _interval(one, computed=computed)) is None:
            continue
        with changed(one.quantity):
            other = next((o for o in case.stated() if o.name == one.name), one)
            after = _interval(other, computed=computed) or before
        if max(a - b for a, b in zip(after, before, strict=True)) > SHARE * CHANGE:
            yield one


def _interval(one: Comparison, *, computed: bool) -> tuple[float, float] | None:
    if isinstance(one.expected, Expected):
        return one.expected[:2]
    return one.expected.interval() if computed and isinstance(one.expected, Computed) else None

"""Change of a value by a misprint alone, without the error of the formula."""

import math
from collections.abc import Iterable

from verify.core.results import Row

SAME = 1e-9  # relative: references that differ by less are one


def misprint(printed: Iterable[Row], corrected: Iterable[Row]) -> float | None:
    """Largest relative change from corrected to printed value, for rows with the same reference.

    The result is None if no row of the corrected form has the reference of a row of the printed
    form.
    """
    corrected = tuple(corrected)
    changes = [
        row.analytic / other.analytic - 1
        for row in printed
        for other in corrected
        if row.analytic is not None and other.analytic and _same_reference(row, other)
    ]
    return max(changes, key=abs, default=None)


def _same_reference(one: Row, other: Row) -> bool:
    a, b = one.reference, other.reference
    if (one.case, one.unit) != (other.case, other.unit) or a is None or b is None:
        return False
    return math.isclose(a, b, rel_tol=SAME)

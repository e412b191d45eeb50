"""Rows judged again from their stored data."""

import math

from verify.judging.explain.grid import regrid
from verify.judging.explain.steps import derive


def agrees(again, kept, digits):
    if again is None or kept is None:
        return again is None and kept is None
    return again == kept or math.isclose(again, kept, rel_tol=1e-5, abs_tol=digits)


def assert_the_same(row):
    """Equal but for the round-off of values that were converted to the row's unit."""
    found = derive(row)
    digits = 1e-14 * max([abs(v) for _, v in row.levels] + [row.scale or 0.0])
    assert found.verdict.status is row.status, row.id
    assert agrees(found.verdict.difference, row.difference, digits), row.id
    assert agrees(found.verdict.tolerance, row.tolerance, digits), row.id
    assert agrees(found.verdict.detects, row.detects, 1e-14), row.id
    if found.u_num is not None:
        assert agrees(found.u_num, row.u_num, digits), row.id
    if row.grid:
        again, _ = regrid(row.grid)
        digits = max(digits, 1e-14 * max(abs(v) for _, v in row.grid.levels))
        assert again.behaviour == row.grid.behaviour
        assert agrees(again.gci, row.grid.gci, digits)
        assert agrees(again.order, row.grid.order, 1e-4)
        assert agrees(again.used, row.grid.used, 1e-4)
        assert again.factor == row.grid.factor

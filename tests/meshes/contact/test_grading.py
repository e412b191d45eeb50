"""Graded cells start with their size, grow by no more than asked, and level off."""

import numpy as np
import pytest

from meshes.contact.grading import beta, cells_along, last_cell

CASES = [(1.0, 0.1, 1.6), (1.0, 1e-4, 1.6), (500.0, 1.0, 1.2), (3.0, 2.5, 2.0)]
cases = pytest.mark.parametrize(("length", "first", "growth"), CASES)


def places(length, n, b):
    """Roberts' stretching in closed form, at n + 1 even parameters."""
    ratio = ((b + 1) / (b - 1)) ** (1 - np.arange(n + 1) / n)
    return length * ((b + 1) - (b - 1) * ratio) / (ratio + 1)


@cases
def test_cells_grow_by_no_more_than_asked_and_start_with_their_size(length, first, growth):
    n = cells_along(length=length, first=first, growth=growth)
    b = beta(length=length, first=first, cells=n)
    sizes = np.diff(places(length, n, b))
    assert (sizes[1:] / sizes[:-1]).max(initial=1) < growth * (1 + 1e-9)
    # the size at the very start, where a map of many more cells has it
    many = np.diff(places(length, 10_000 * n, b))
    assert many[0] * 10_000 == pytest.approx(first, rel=1e-3)
    assert last_cell(length=length, cells=n, beta=b) == pytest.approx(sizes[-1], rel=1e-9)

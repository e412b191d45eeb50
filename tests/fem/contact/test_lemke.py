"""Lemke's method on a problem whose number of pivots is known."""

import numpy as np
import pytest

from fem.contact.lemke import lemke


@pytest.mark.parametrize(("rows", "is_solved"), [(4, True), (5, False)])
def test_pivots_end_at_four_a_row(rows, is_solved):
    """Murty's problem: 2^N - 1 pivots for N rows and covering vectors 2^-k; 15 of 16, 31 of 20."""
    M = np.eye(rows) + np.tril(2 * np.ones((rows, rows)), -1)
    z = lemke(M, -np.ones(rows), 0.5 ** np.arange(rows))
    if is_solved:
        assert z == pytest.approx(np.eye(rows)[0])  # w = M z + q = (0, 1, 1, 1)
    else:
        assert z is None

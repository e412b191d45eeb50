"""Which slices carry, against non-negative least squares and where blocks run in circles."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import nnls

from analytic.contact import slice_pivoting


@settings(deadline=None, max_examples=60)
@given(seed=st.integers(0, 2**32 - 1), n=st.integers(1, 30), softness=st.floats(1e-3, 1e3))
def test_the_carrying_slices_are_those_of_non_negative_least_squares(seed, n, softness):
    """Any positive definite S, not contacts alone: there the block exchange may run in circles."""
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(n, n))
    S = root @ root.T + softness * np.eye(n)
    f = rng.uniform(0, 1, n) ** 3 * (rng.uniform(size=n) < 0.8)
    start = rng.uniform(size=(1, n)) < 0.5
    q, _ = slice_pivoting.carried(S[None], f[None], f[None], start)
    factor = np.linalg.cholesky(S)
    expected, _ = nnls(factor.T, np.linalg.solve(factor, f))
    np.testing.assert_allclose(q[0], expected, atol=1e-9 * max(expected.max(), 1e-300))


def test_where_blocks_run_in_circles_single_exchanges_find_the_way(monkeypatch):
    """Found by search: all leaving and coming back at once never ends for this S and f."""
    root = np.array([[-3.0, 0.0], [-3.0, 1.0], [-1.0, 3.0], [2.0, 2.0]])
    S, f = root @ root.T + 0.05 * np.eye(4), np.array([0.0, 3.0, 4.0, 5.0])
    q, _ = slice_pivoting.carried(S[None], f[None], f[None], np.ones((1, 4), dtype=bool))
    after = S @ q[0] - f
    assert np.all(q >= 0)
    assert np.all(after >= -1e-12)
    np.testing.assert_allclose(after * q[0], 0, atol=1e-12)
    monkeypatch.setattr(slice_pivoting, "PATIENCE", 10**9)
    with pytest.raises(ArithmeticError, match="the carrying slices were not found"):
        slice_pivoting.carried(S[None], f[None], f[None], np.ones((1, 4), dtype=bool))

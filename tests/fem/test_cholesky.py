"""Factors of symmetric matrices: solutions, the last block, new values, and refusals."""

import numpy as np
import pytest
from scipy.sparse import (
    csc_array,
    csr_array,
    diags_array,
    eye_array,
    kron,
    random_array,
    tril,
)
from threadpoolctl import threadpool_limits

from fem.cholesky import Cholesky

EXACT = {"rtol": 0.0, "atol": 1e-12}


def matrix(n, seed=0):
    """A sparse one whose diagonal outweighs the rest."""
    A = random_array((n, n), density=min(1.0, 4 / n), rng=np.random.default_rng(seed))
    return csc_array(A + A.T + diags_array(np.full(n, 20.0)))


TWO_BODIES = csc_array(kron(matrix(12), np.diag([1.0, 2.0])))  # unknowns in turn


@pytest.mark.parametrize("kind", [csc_array, csr_array])
@pytest.mark.parametrize("ordered", [True, False])
@pytest.mark.parametrize("n", [0, 1, 7, 200])
def test_solutions_satisfy_their_equations(n, ordered, kind):
    A = matrix(n) if n else csc_array((0, 0))
    b = np.random.default_rng(1).random((n, 3))
    factor = Cholesky(kind(A), ordered=ordered)
    x = factor.solve(b)
    assert x.shape == b.shape
    np.testing.assert_allclose(A @ x, b, **EXACT)
    np.testing.assert_array_equal(factor.solve(b[:, 1]), x[:, 1])
    assert factor.solve(b[:, :0]).shape == (n, 0)


@pytest.mark.parametrize("A", [matrix(1), matrix(60), TWO_BODIES], ids=["1", "60", "two bodies"])
def test_the_last_blocks_are_those_of_the_dense_factor(A):
    n = A.shape[0]
    factor, L = Cholesky(A), np.linalg.cholesky(A.toarray())
    for count in range(n + 1):
        first = n - count
        np.testing.assert_allclose(factor.last_block(count), L[first:, first:], **EXACT)
    assert np.count_nonzero(L) <= factor.entries <= n * n


def test_the_lower_triangle_is_enough_and_a_column_s_order_makes_no_difference():
    A, b = matrix(40), np.arange(40.0)
    x = Cholesky(A).solve(b)
    np.testing.assert_array_equal(Cholesky(csc_array(tril(A))).solve(b), x)
    backwards = csc_array(A[::-1])
    backwards.indices = 39 - backwards.indices  # the same matrix, rows of each column descending
    backwards.has_sorted_indices = False
    np.testing.assert_array_equal(Cholesky(backwards).solve(b), x)


def test_updated_factors_equal_new_ones():
    A, b = matrix(80), np.ones(80)
    other = A.copy()
    other.data = other.data * np.where(other.data > 1, 1.3, 0.7)
    factor = Cholesky(A)
    before = factor.last_block(9)
    factor.renew(other)
    np.testing.assert_array_equal(factor.solve(b), Cholesky(other).solve(b))
    np.testing.assert_array_equal(factor.last_block(9), Cholesky(other).last_block(9))
    assert not np.array_equal(before, factor.last_block(9))
    factor.renew(A)
    np.testing.assert_array_equal(before, factor.last_block(9))


@pytest.mark.parametrize("last", [-1.0, 0.0])
def test_what_is_not_positive_definite_is_refused(last):
    A = csc_array(np.diag([1.0, 2.0, 3.0]))
    factor = Cholesky(A)
    A.data[2] = last
    with pytest.raises(ArithmeticError, match=r"not positive definite.* pivot 2 of 3"):
        Cholesky(A)
    with pytest.raises(ArithmeticError, match="not positive definite"):
        factor.renew(A)


def test_digits_do_not_depend_on_the_number_of_threads():
    n = 120
    line, one = diags_array([4.0, -1.0, -1.0], offsets=[0, 1, -1], shape=(n, n)), eye_array(n)
    A, b, found = csc_array(kron(line, one) + kron(one, line)), np.sin(np.arange(n * n)), []
    for count in (1, 2):
        with threadpool_limits(count):
            found.append(Cholesky(A, ordered=False).solve(b))
    np.testing.assert_array_equal(*found)

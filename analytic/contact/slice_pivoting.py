r"""Unilateral contact of coupled slices: set of loaded slices and their forces, for many cases.

With the matrix S of compliances and the required deflections f (to the power 10/9), the forces
satisfy

.. math:: q \ge 0, \qquad S q - f \ge 0, \qquad q^T (S q - f) = 0.

As S is positive definite, there is one solution. Slices with tension are unloaded, and slices that
interpenetrate are loaded again: all at once as long as their number decreases, otherwise one at a
time, the last one first. This terminates for any positive definite S (block principal pivoting with
Murty's rule).

References
----------
.. [1] J. J. Júdice, F. M. Pires, A block principal pivoting algorithm for large-scale strictly
   monotone linear complementarity problems, Computers & Operations Research 21 (1994) 587-596.
"""

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array

PATIENCE = 3  # allowed number of block steps without progress
PIVOTS = 1000
ROUND_OFF = 1e-13  # relative to the largest f: smaller tensions and overlaps count as zero


def carried(S: Array, f: Array, rate: Array, carries: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Forces q with S q = f on the loaded slices, and their derivatives if f changes at `rate`.

    The shape of S is (cases, n, n), that of f and `rate` (cases, n). `carries` is the initial set
    of loaded slices; it is changed in place to the final set. Raises ArithmeticError if the search
    does not terminate.
    """
    q, growth = np.zeros_like(f), np.zeros_like(f)
    best = np.full(len(f), f.shape[1] + 1)
    patience = np.full(len(f), PATIENCE)
    left = np.arange(len(f))
    for _ in range(PIVOTS):
        some, on = S[left], carries[left]
        solved = _solve(some, np.stack([f[left], rate[left]], axis=-1), on)
        q[left], growth[left] = solved[..., 0], solved[..., 1]
        wrong = _wrong(some, q[left], f[left], on)
        count = wrong.sum(axis=1)
        fewer = count < best[left]
        patience[left] = np.where(fewer, PATIENCE, patience[left] - 1)
        best[left] = np.minimum(best[left], count)
        one_only = patience[left] < 0
        wrong[one_only] = _last(wrong[one_only])
        carries[left] = on ^ wrong
        left = left[count > 0]
        if not len(left):
            return np.maximum(q, 0.0), growth
    raise ArithmeticError(f"the set of loaded slices was not found in {PIVOTS} pivot steps")


def _solve(S: Array, right: Array, on: NDArray[np.bool_]) -> Array:
    """Solution on the loaded slices; 0 on the others."""
    both = on[:, :, None] & on[:, None, :]
    matrix = np.where(both, S, 0.0)
    diagonal = np.arange(S.shape[1])
    matrix[:, diagonal, diagonal] += ~on
    return np.asarray(np.linalg.solve(matrix, np.where(on[:, :, None], right, 0.0)))


def _wrong(S: Array, q: Array, f: Array, on: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Loaded slices with tension, and unloaded slices that interpenetrate."""
    largest = ROUND_OFF * f.max(axis=1, keepdims=True)
    overlap = f - np.einsum("cij,cj->ci", S, q)
    return np.asarray(np.where(on, q * S[:, :1, 0] < -largest, overlap > largest))


def _last(wrong: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Mask of the last wrong slice of each case."""
    after = np.cumsum(wrong[:, ::-1], axis=1)[:, ::-1]
    return np.asarray(wrong & (after == 1))

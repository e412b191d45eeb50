"""Lemke's method for linear complementarity problems: w = q + M z, w >= 0, z >= 0, w'z = 0.

An artificial variable z_0 with a positive covering vector d makes q + d z_0 non-negative. Pivots
exchange complementary variables until z_0 leaves the basis (a solution) or no variable limits the
entering variable (a ray). A ray alone does not prove that no solution exists. Source: Cottle, Pang
and Stone, The Linear Complementarity Problem (1992), algorithm 4.4.5.
"""

import numpy as np
from scipy.linalg.blas import dger

from fem.plane.discretisation import Array, Indices

PIVOT_TOLERANCE = 1e-9  # relative to the largest entry of its column: a smaller pivot is round-off
TIE_TOLERANCE = 1e-13  # relative to the largest value: rows this close to zero block together
ARTIFICIAL_TOLERANCE = 1e-12  # relative to its first value: below, z_0 has left the basis
PIVOTS_PER_ROW = 4


def lemke(M: Array, q: Array, d: Array) -> Array | None:
    """Solution z (N,) for `M` (N, N), `q` (N,); None after a ray or too many pivots.

    `d` (N,) is the positive covering vector. z contains the round-off of all pivots. The caller
    must therefore solve the linear system of the final basis again.
    """
    N, size = q.size, float(np.abs(q).max(initial=0.0))
    if np.all(q >= 0):
        return np.zeros(N)
    tableau = np.asfortranarray(np.column_stack([M, d, q / size]))
    basic, nonbasic = np.arange(N), np.append(N + np.arange(N), 2 * N)  # w, then z, then z_0
    places = np.concatenate([basic, basic, [N]])  # of each variable, in a row or a column
    row, column = int(np.argmin(q / d)), N
    artificial, first = row, -tableau[row, -1] / d[row]
    for _ in range(PIVOTS_PER_ROW * N):
        _exchange(tableau, row, column)
        entered, left = nonbasic[column], basic[row]
        basic[row], nonbasic[column] = entered, left
        places[entered], places[left] = row, column
        if left == 2 * N or tableau[artificial, -1] <= ARTIFICIAL_TOLERANCE * first:
            return size * _solution(basic, tableau[:, -1])
        column = int(places[left + N if left < N else left - N])
        row = _blocking(tableau[:, column], tableau[:, -1], artificial)
        if row < 0:
            return None
    return None


def _exchange(tableau: Array, row: int, column: int) -> None:
    """Exchange the basic variable of `row` with the nonbasic variable of `column`, in place."""
    pivot, entries = tableau[row, column], tableau[row] / tableau[row, column]
    rates = tableau[:, column].copy()
    rates[row] = 0.0
    entries[column] = 0.0
    dger(-1.0, rates, entries, a=tableau, overwrite_a=True)
    tableau[:, column] = rates / pivot
    tableau[row] = -entries
    tableau[row, column] = 1 / pivot


def _blocking(rates: Array, values: Array, artificial: int) -> int:
    """Row whose basic variable first reaches zero as the entering variable grows; -1 for a ray.

    Among variables that reach zero together, the row of z_0 (`artificial`) is chosen; without z_0,
    the row with the largest pivot.
    """
    falling = (rates < -PIVOT_TOLERANCE * max(rates.max(), -rates.min())).nonzero()[0]
    if not falling.size:
        return -1
    rates, values = rates[falling], np.maximum(values[falling], 0.0)
    step = (values / -rates).min()
    if not np.isfinite(step):
        return -1
    tied = values + step * rates <= TIE_TOLERANCE * max(1.0, values.max())
    if tied[falling == artificial].any():
        return artificial
    return int(falling[tied][rates[tied].argmin()])


def _solution(basic: Indices, values: Array) -> Array:
    z, N = np.zeros(basic.size), basic.size
    chosen = (basic >= N) & (basic < 2 * N)
    z[basic[chosen] - N] = np.maximum(values[chosen], 0.0)
    return z

"""All roots of a Hermitian dynamic stiffness, without omission.

At a root, x* D'(w) x = -(w x*M x + x*K x/w) < 0 for all gyroscopic terms. Therefore, each
eigenvalue of D crosses zero once, downwards: the k-th lowest eigenvalue is positive below the k-th
root and negative above it, and the number of negative eigenvalues is the number of lower roots
(Wittrick and Williams, 1971). Clamped roots do not have to be added, as the pieces of `Bending`
have none.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import elementwise

Array = NDArray[np.float64]
Matrices = NDArray[np.float64] | NDArray[np.complex128]
Stiffness = Callable[[Array, NDArray[np.int64]], Matrices]
TOLERANCE = 1e-13


def count_below(D: Matrices) -> NDArray[np.int64]:
    """Number of roots below each frequency at which a matrix D (m, n, n) was evaluated."""
    found: NDArray[np.int64] = (np.linalg.eigvalsh(D) < 0).sum(axis=-1)
    return found


def roots_below(stiffness: Stiffness, highest: Array, wanted: NDArray[np.int64]) -> Array:
    """Roots [rad/s] with the indices `wanted` (from 0) of every item, shape (items, count).

    `stiffness(w, item)` takes arrays (q,) and returns D (q, n, n); it must not have poles up to
    `highest` (items,). A root above `highest` is returned as NaN.
    """
    item = np.repeat(np.arange(highest.size), wanted.size).astype(np.int64)
    k = np.tile(wanted, highest.size)
    top = np.linalg.eigvalsh(stiffness(highest, np.arange(highest.size)))
    there = top[item, k] < 0
    found = np.full(item.size, np.nan)
    if not there.any():
        return found.reshape(highest.size, -1)

    def eigenvalue(w: Array, at: Array, number: Array) -> Array:
        values = np.linalg.eigvalsh(stiffness(w, at.astype(np.int64)))
        return np.asarray(values[np.arange(w.size), number.astype(np.int64)])

    args = (item[there].astype(np.float64), k[there].astype(np.float64))
    bracket = (np.zeros(there.sum()), highest[item[there]])
    tolerances = {"xatol": 0.0, "xrtol": TOLERANCE, "fatol": 0.0, "frtol": 0.0}
    result = elementwise.find_root(eigenvalue, bracket, args=args, tolerances=tolerances)
    found[there] = result.x
    return found.reshape(highest.size, -1)

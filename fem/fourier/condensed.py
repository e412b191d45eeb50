"""Harmonics of one body under loads on few unknowns, which are eliminated last.

From n = 2 on all harmonics have the same free unknowns, so that one selection and one pattern serve
them all.
"""

from dataclasses import dataclass
from typing import Self

import numpy as np
from scipy.linalg import solve_triangular
from scipy.sparse import csc_array, csr_array
from scipy.sparse.linalg import SuperLU

from fem.plane.discretisation import Array, Indices


@dataclass(frozen=True)
class Selected:
    """Parts `data` (3, entries) of T' (K_0 + n K_1 + n^2 K_2) T on one pattern, T a selection."""

    T: csr_array
    data: Array
    indices: Indices
    indptr: Indices

    @classmethod
    def of(cls, parts: tuple[csr_array, csr_array, csr_array], T: csr_array) -> Self:
        """Of three matrices with one pattern, such as the parts of a stiffness; T holds ones."""
        first = parts[0]
        number = np.arange(1.0, first.nnz + 1)
        chosen = (T.T @ csr_array((number, first.indices, first.indptr), first.shape) @ T).tocsc()
        chosen.sort_indices()
        data = np.array([part.data for part in parts])[:, chosen.data.astype(int) - 1]
        return cls(T, data, chosen.indices, chosen.indptr)

    def stiffness(self, n: int) -> csc_array:
        """The matrix of harmonic `n`, for a turn of one radian, without zero entries."""
        K_0, K_1, K_2 = self.data
        K = csc_array(
            (K_0 + n * K_1 + n**2 * K_2, self.indices.copy(), self.indptr.copy()),
            (self.T.shape[1], self.T.shape[1]),
        )
        K.eliminate_zeros()
        return K


def flexibility(factor: SuperLU, T: csr_array, f: Array) -> Array:
    """The work f_i . u_j (k, k) of loads `f` (unknowns, k) on u_j = T q, by the factors of K.

    With K = L R only the rows of L and R from the first force on take part.
    """
    assert np.array_equal(factor.perm_r, factor.perm_c)  # pivots on the diagonal
    load = np.empty((factor.shape[0], f.shape[1]))
    load[factor.perm_r] = T.T @ f
    first = int(np.argmax(np.any(load, axis=1)))
    L, R = (part[first:, first:].toarray() for part in (factor.L, factor.U))
    q = solve_triangular(R, solve_triangular(L, load[first:], lower=True, unit_diagonal=True))
    work = load[first:].T @ q
    return np.asarray((work + work.T) / 2)

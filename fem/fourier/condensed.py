"""Flexibility of a body in many harmonics, under loads on a few unknowns that are eliminated last.

All harmonics n >= 2 have the same free unknowns, and therefore share one matrix T, which selects
these unknowns, and one sparsity pattern.
"""

from dataclasses import dataclass
from typing import Self

import numpy as np
from scipy.linalg import solve_triangular
from scipy.sparse import csc_array, csr_array, tril

from fem.cholesky import Cholesky
from fem.plane.discretisation import Array, Indices


@dataclass(frozen=True)
class Selected:
    """Lower triangle of T' (K_0 + n K_1 + n^2 K_2) T, where T selects the free unknowns.

    The rows of `data` (3, entries) belong to K_0, K_1 and K_2. Zero entries are stored, so that all
    harmonics have the same pattern.
    """

    T: csr_array
    data: Array
    indices: Indices
    indptr: Indices

    @classmethod
    def of(cls, parts: tuple[csr_array, csr_array, csr_array], T: csr_array) -> Self:
        """Lower triangles of T' K T for the three matrices K in `parts`, which have one pattern."""
        first = parts[0]
        number = np.arange(1.0, first.nnz + 1)
        chosen = tril(T.T @ csr_array((number, first.indices, first.indptr), first.shape) @ T)
        chosen = chosen.tocsc()
        chosen.sort_indices()
        data = np.array([part.data for part in parts])[:, chosen.data.astype(int) - 1]
        return cls(T, data, chosen.indices, chosen.indptr)

    def stiffness(self, n: int) -> csc_array:
        """Lower triangle of the stiffness of harmonic `n`, for one radian."""
        K_0, K_1, K_2 = self.data
        return csc_array(
            (K_0 + n * K_1 + n**2 * K_2, self.indices, self.indptr),
            (self.T.shape[1], self.T.shape[1]),
        )


def flexibility(factor: Cholesky, T: csr_array, f: Array) -> Array:
    """Work f_i . u_j (k, k) of each load f_i on the displacements u_j that the load f_j causes.

    The loads are the columns of `f` (unknowns, k). u = T q is computed with the factors of K. With
    K = L L', only the last rows of L, from the first loaded unknown, are used.
    """
    load = T.T @ f
    first = int(np.argmax(np.any(load, axis=1)))
    half = solve_triangular(factor.last_block(factor.n - first), load[first:], lower=True)
    return np.asarray(half.T @ half)

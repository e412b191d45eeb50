"""Factors of symmetric, positive definite matrices, the last few kept by the matrix's content."""

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import SuperLU, splu

from fem.plane.geometry import Array
from fem.plane.recent import Recent

# The matrix is symmetric, positive definite and handed over in its order of elimination. Panels
# and relaxed supernodes of 10 are 1.3 times as fast as the defaults; SuperLU counts them in a
# table of 13 entries or more by version, beyond which larger ones would write.
SUPERLU = {
    "permc_spec": "NATURAL", "diag_pivot_thresh": 0.0, "relax": 10, "panel_size": 10,
    "options": {"SymmetricMode": True},
}  # fmt: skip
# Bodies that differ by the size or the unit of E alone have one matrix, to this many bits of its
# moduli: corrections that it steers leave 1e-12 of what they correct.
BITS = 40
FACTORS: Recent[SuperLU] = Recent(most=8, room=8e6)  # entries of the factors, 100 MB


def factorised(A: csc_array) -> SuperLU:
    """Factors of `A`, kept where they are small."""
    key = (A.shape[0], A.data, A.indices, A.indptr)
    return FACTORS.get(key, lambda: splu(A, **SUPERLU), lambda factors: factors.nnz)


def short(x: Array) -> Array:
    """`x` rounded to `BITS` bits."""
    digits, power = np.frexp(x)
    return np.ldexp(np.round(np.ldexp(digits, BITS)), power - BITS)

"""Cache of the last few factors of symmetric, positive definite matrices."""

import numpy as np
from scipy.sparse import csc_array

from fem.cholesky import Cholesky
from fem.plane.geometry import Array
from fem.plane.recent import Recent

# Bodies that differ by the size or the unit of E alone have one matrix, to this many bits of its
# moduli: corrections that it steers leave 1e-12 of what they correct.
BITS = 40
FACTORS: Recent[Cholesky] = Recent(most=8, room=8e6)  # entries of the factors, 64 MB


def factorised(A: csc_array) -> Cholesky:
    """Cholesky factors of `A`; small factors are stored for further calls with an equal matrix."""
    key = (A.shape[0], A.data, A.indices, A.indptr)
    return FACTORS.get(key, lambda: Cholesky(A, ordered=False), lambda factors: factors.entries)


def short(x: Array) -> Array:
    """Numbers `x`, rounded to `BITS` bits."""
    digits, power = np.frexp(x)
    return np.ldexp(np.round(np.ldexp(digits, BITS)), power - BITS)

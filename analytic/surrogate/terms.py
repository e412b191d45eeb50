"""Terms of kriging: monomials of the trend and correlation of the process."""

import numpy as np
from scipy.spatial.distance import cdist

from analytic.contact.checks import Array

NUGGET = 1e-10  # relative to the variance: prevents a singular C for a close pair of designs


def trend_terms(u: Array) -> Array:
    """Monomials (n, 1 + d + d(d+1)/2) of degree 0, 1 and 2 at u (n, d).

    >>> trend_terms(np.array([[2.0, 3.0]])).tolist()
    [[1.0, 2.0, 3.0, 4.0, 6.0, 9.0]]
    """
    first, second = np.triu_indices(u.shape[1])
    return np.column_stack([np.ones(len(u)), u, u[:, first] * u[:, second]])


def matern(u: Array, v: Array, length_scales: Array) -> Array:
    """Matérn 5/2 correlations (n, m) of points u (n, d) and v (m, d)."""
    r = np.sqrt(5) * cdist(u / length_scales, v / length_scales)
    return np.asarray((1 + r * (1 + r / 3)) * np.exp(-r))

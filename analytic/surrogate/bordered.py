"""Universal kriging by its bordered system: trend and process follow from one set of equations.

The best linear unbiased prediction at x has weights w of the given values, which satisfy

    [C  F ] [w]   [c(x)]
    [F' 0 ] [l] = [f(x)].

Its variance is s² (1 - w'c - l'f). For given length scales, this system contains all steps of
`analytic.surrogate.kriging`: trend by generalised least squares, Gaussian process on the residual,
left-out values in closed form.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from analytic.contact.checks import Array

NUGGET = 1e-10  # relative to the variance, on the diagonal of C


@dataclass(frozen=True, eq=False)
class Bordered:
    """Kriging of the `values` (n,) at `x` (n, d); the length `scales` (d,) have the units of x."""

    x: Array
    values: Array
    scales: Array

    @cached_property
    def system(self) -> Array:
        """Bordered matrix (n + t, n + t)."""
        F = quadratic(self.x)
        n, t = F.shape
        whole = np.zeros((n + t, n + t))
        whole[:n, :n] = self._correlation(self.x) + NUGGET * np.eye(n)
        whole[:n, n:], whole[n:, :n] = F, F.T
        return whole

    @property
    def condition(self) -> float:
        """Condition number of the system after division of each row by its largest entry."""
        return float(np.linalg.cond(self.system / np.abs(self.system).max(axis=1)[:, None]))

    def predicted(self, at: Array) -> Array:
        """Predictions (m,) at `at` (m, d)."""
        return np.asarray(self._weights(at)[: len(self.x)].T @ self.values)

    def deviation(self, at: Array) -> Array:
        """Kriging standard deviations (m,) at `at` (m, d)."""
        right = self._right(at)
        share = 1 - np.einsum("ij,ij->j", self._weights(at), right)
        return np.asarray(np.sqrt(self._variance * np.maximum(share, 0)))

    def left_out(self, k: int) -> float:
        """Value with the index `k`, minus its prediction from all other values."""
        others = np.arange(len(self.x)) != k
        rest = Bordered(self.x[others], self.values[others], self.scales)
        return float(self.values[k] - rest.predicted(self.x[[k]])[0])

    @property
    def _variance(self) -> float:
        """Variance of the process: y'w over the degrees of freedom, with the dual weights w."""
        n, t = len(self.x), quadratic(self.x).shape[1]
        weights = np.linalg.solve(self.system, np.r_[self.values, np.zeros(t)])[:n]
        return float(self.values @ weights / (n - t))

    def _right(self, at: Array) -> Array:
        return np.vstack([self._correlation(at), quadratic(at).T])

    def _weights(self, at: Array) -> Array:
        return np.asarray(np.linalg.solve(self.system, self._right(at)))

    def _correlation(self, at: Array) -> Array:
        """Matérn correlations (n, m) of order 5/2 between the given points and the points `at`."""
        apart = (self.x[:, None, :] - at[None, :, :]) / self.scales
        r = np.sqrt(5 * np.sum(apart**2, axis=-1))
        return np.asarray((1 + r + r**2 / 3) * np.exp(-r))


def quadratic(x: Array) -> Array:
    """Quadratic trend terms 1, x_i and x_i x_j, (n, t).

    >>> quadratic(np.array([[2.0, 3.0]])).tolist()
    [[1.0, 2.0, 3.0, 4.0, 6.0, 9.0]]
    """
    d = x.shape[1]
    products = [x[:, i] * x[:, j] for i in range(d) for j in range(i, d)]
    return np.column_stack([np.ones(len(x)), *x.T, *products])

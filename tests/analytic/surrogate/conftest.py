"""Universal kriging a second way: the bordered system, and Matérn's correlation by Bessel's K."""

from dataclasses import dataclass

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.special import gamma, kv

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Bordered:
    """[[C, F], [F', 0]] [w, m] = [c, f] solved as it stands, all in the unit cube."""

    u: Array
    y: Array
    length_scales: Array

    def terms(self, u: Array) -> Array:
        d = u.shape[1]
        pairs = [u[:, i] * u[:, j] for i in range(d) for j in range(i, d)]
        return np.column_stack([np.ones(len(u)), *u.T, *pairs])

    def correlation(self, u: Array, v: Array) -> Array:
        r = np.sqrt(5 * np.sum(((u[:, None] - v) / self.length_scales) ** 2, axis=2))
        at = np.where(r > 0, r, 1)  # the general Matérn correlation, order 5/2
        return np.where(r > 0, 2 ** (1 - 2.5) / gamma(2.5) * at**2.5 * kv(2.5, at), 1.0)

    @property
    def system(self) -> Array:
        C = self.correlation(self.u, self.u) + 1e-10 * np.eye(len(self.u))
        F = self.terms(self.u)
        return np.block([[C, F], [F.T, np.zeros((F.shape[1], F.shape[1]))]])

    def predict(self, u: Array) -> tuple[Array, Array]:
        """Prediction, and its variance in those of the process."""
        c, f = self.correlation(self.u, u), self.terms(u).T
        weights = np.linalg.solve(self.system, np.vstack([c, f]))
        w, m = np.split(weights, [len(self.u)])
        return w.T @ self.y, 1 - np.sum(w * c, axis=0) - np.sum(m * f, axis=0)

    @property
    def variance(self) -> float:
        """y'Py/(n - t), P the leading block of the inverse."""
        n, t = len(self.u), len(self.system) - len(self.u)
        return float(self.y @ np.linalg.inv(self.system)[:n, :n] @ self.y) / (n - t)

    def likelihood(self) -> float:
        """Logarithm of the largest likelihood over trend and variance, less a constant."""
        n = len(self.u)
        C, F = self.system[:n, :n], self.terms(self.u)
        weighted = np.linalg.solve(C, F)
        r = self.y - F @ np.linalg.solve(F.T @ weighted, weighted.T @ self.y)
        spread = r @ np.linalg.solve(C, r) / n
        return float(-n / 2 * np.log(spread) - np.linalg.slogdet(C)[1] / 2)


@pytest.fixture(scope="session")
def bordered() -> type[Bordered]:
    return Bordered

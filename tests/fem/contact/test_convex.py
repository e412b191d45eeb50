"""The least of a piecewise quadratic function, which Nitsche's method looks for."""

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.sparse import csr_array

from fem.contact.convex import Piecewise

RNG = np.random.default_rng(4)


def piecewise(free):
    """Twelve unknowns, eight rows; `A` lets `free` of them go."""
    n, rows = 12, 8
    A = np.diag(np.arange(n) >= free).astype(float) * 2
    Z = RNG.standard_normal((rows, n))
    low = np.where(np.arange(rows) < 5, 0.0, -0.3)
    high = np.where(np.arange(rows) < 5, np.inf, 0.3)
    return Piecewise(
        A=csr_array(A), f=3 * RNG.standard_normal(n), Z=csr_array(Z),
        z=RNG.standard_normal(rows), weight=RNG.uniform(0.5, 2, rows), low=low, high=high,
        stiffness=2 + (Z**2).sum(axis=0),
    )  # fmt: skip


def value(J, v):
    x, t = J.z + J.Z @ v, J.cut(v)
    return v @ (J.A @ v) / 2 - J.f @ v + J.weight @ (t * x - t**2 / 2)


@pytest.mark.parametrize("free", [0, 2])
def test_the_least_value_is_found(free):
    J = piecewise(free)
    if free:  # loads that the rows can carry
        pulled = RNG.standard_normal(12)
        J = Piecewise(**{**vars(J), "f": J.A @ pulled + J.Z.T @ (J.weight * J.cut(pulled))})
    found, _ = J.least(np.zeros(12))
    general = minimize(lambda v: value(J, v), np.zeros(12), method="BFGS", options={"gtol": 1e-9})
    assert value(J, found) == pytest.approx(general.fun, rel=1e-9, abs=1e-9)
    near = found + 1e-3 * RNG.standard_normal((20, 12))
    assert min(value(J, v) for v in near) > value(J, found)

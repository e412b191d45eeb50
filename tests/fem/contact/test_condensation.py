"""The surface's stiffness is that of the whole; the least of a piecewise quadratic function."""

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.sparse import csr_array

from fem.contact.condensation import condense
from fem.contact.convex import Piecewise
from fem.plane.cells import Cells
from fem.plane.discretisation import vector_basis
from fem.plane.ordering import nested_dissection
from meshes.contact.block import block
from meshes.join import join


def floating():
    """K of two bodies that nothing holds, the surface's unknowns last, and their number."""
    mesh = join({"a": block(x=(0, 2), y=(0, 1), nx=7, ny=5, cells="tri"),
                 "b": block(x=(0, 2), y=(1, 2), nx=6, ny=4, cells="tri")})  # fmt: skip
    names = ["a.top", "a.bottom", "b.bottom"]
    basis = vector_basis(mesh)
    K = Cells.of(basis, np.full(mesh.nelements, 1.3), np.full(mesh.nelements, 0.8)).stiffness()
    surface = np.unique(np.concatenate([basis.get_dofs(name).all() for name in names]))
    place = nested_dissection(basis)
    place[surface] += basis.N
    order = np.argsort(place)
    return csr_array(K[order][:, order]), surface.size


def test_the_surface_s_stiffness_and_loads_are_those_of_the_whole_and_the_inside_follows():
    K, count = floating()
    n = K.shape[0] - count
    A = K.toarray()
    inner, coupling, outer = A[:n, :n], A[:n, n:], A[n:, n:]
    found = condense(K, count)
    schur = outer - coupling.T @ np.linalg.solve(inner, coupling)
    assert np.abs(found.S - schur).max() < 1e-12 * np.abs(schur).max()
    random = np.random.default_rng(1)
    f, moved = random.normal(size=n + count), random.normal(size=count)
    expected = f[n:] - coupling.T @ np.linalg.solve(inner, f[:n])
    assert found.load(f) == pytest.approx(expected, rel=1e-10, abs=1e-10)
    u = found.inside(f, found.load(f), moved)
    assert u[n:] == pytest.approx(moved, rel=1e-9, abs=1e-9)
    assert (K @ u - f)[:n] == pytest.approx(np.zeros(n), abs=1e-9)


RNG = np.random.default_rng(4)


def piecewise(*, free=0, f=None):
    """Twelve unknowns, eight rows; `A` lets `free` of them go."""
    n, rows = 12, 8
    A = np.diag(np.arange(n) >= free).astype(float) * 2
    Z = RNG.standard_normal((rows, n))
    low = np.where(np.arange(rows) < 5, 0.0, -0.3)
    high = np.where(np.arange(rows) < 5, np.inf, 0.3)
    return Piecewise(
        A=csr_array(A), f=3 * RNG.standard_normal(n) if f is None else f, Z=csr_array(Z),
        z=RNG.standard_normal(rows), weight=RNG.uniform(0.5, 2, rows), low=low, high=high,
        stiffness=2 + (Z**2).sum(axis=0),
    )  # fmt: skip


def value(J, v):
    x, t = J.z + J.Z @ v, J.cut(v)
    return v @ (J.A @ v) / 2 - J.f @ v + J.weight @ (t * x - t**2 / 2)


@pytest.mark.parametrize("free", [0, 2])
def test_the_least_value_is_found(free):
    J = piecewise(free=free)
    if free:  # loads that the rows can carry
        pulled = RNG.standard_normal(12)
        J = Piecewise(**{**vars(J), "f": J.A @ pulled + J.Z.T @ (J.weight * J.cut(pulled))})
    found, _ = J.least(np.zeros(12))
    general = minimize(lambda v: value(J, v), np.zeros(12), method="BFGS", options={"gtol": 1e-9})
    assert value(J, found) == pytest.approx(general.fun, rel=1e-9, abs=1e-9)
    near = found + 1e-3 * RNG.standard_normal((20, 12))
    assert min(value(J, v) for v in near) > value(J, found)


def test_a_function_that_is_not_convex_is_an_error():
    J = piecewise()
    with pytest.raises(ArithmeticError, match="not positive definite"):
        Piecewise(**{**vars(J), "A": -J.A}).least(np.zeros(12))


def test_a_function_that_falls_for_ever_is_an_error():
    f = np.eye(12)[0]
    J = Piecewise(**{**vars(piecewise(free=1, f=f)), "low": np.zeros(8), "high": np.zeros(8)})
    with pytest.raises(ArithmeticError, match="neither supports nor contact hold"):
        J.least(np.zeros(12))

"""The surface's stiffness and forces are those of the whole, whatever lies behind the surface."""

import numpy as np
import pytest
from scipy.sparse import csr_array

from fem.contact.condensation import condense
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

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


@pytest.fixture(scope="module", params=["one body", "two bodies"])
def floating(request):
    """K of bodies that nothing holds, the surface's unknowns last, and their number."""
    mesh = block(x=(0, 2), y=(0, 1), nx=7, ny=5, cells="tri")
    names = ["top", "bottom"]
    if request.param == "two bodies":
        mesh = join({"a": mesh, "b": block(x=(0, 2), y=(1, 2), nx=6, ny=4, cells="tri")})
        names = ["a.top", "a.bottom", "b.bottom"]
    basis = vector_basis(mesh)
    K = Cells.of(basis, np.full(mesh.nelements, 1.3), np.full(mesh.nelements, 0.8)).stiffness()
    surface = np.unique(np.concatenate([basis.get_dofs(name).all() for name in names]))
    place = nested_dissection(basis)
    place[surface] += basis.N
    order = np.argsort(place)
    return csr_array(K[order][:, order]), surface.size


def split(K, count):
    n = K.shape[0] - count
    A = K.toarray()
    return A[:n, :n], A[:n, n:], A[n:, n:]


def test_the_stiffness_is_the_schur_complement(floating):
    K, count = floating
    inner, coupling, outer = split(K, count)
    S = outer - coupling.T @ np.linalg.solve(inner, coupling)
    assert np.abs(condense(K, count).S - S).max() < 1e-12 * np.abs(S).max()


def test_loads_inside_act_on_the_surface_as_they_would_through_the_body(floating):
    K, count = floating
    inner, coupling, _ = split(K, count)
    f = np.random.default_rng(1).normal(size=K.shape[0])
    expected = f[-count:] - coupling.T @ np.linalg.solve(inner, f[:-count])
    assert condense(K, count).load(f) == pytest.approx(expected, rel=1e-10, abs=1e-10)


def test_the_inside_follows_a_surface_that_is_moved(floating):
    K, count = floating
    found = condense(K, count)
    random = np.random.default_rng(2)
    f, moved = random.normal(size=K.shape[0]), random.normal(size=count)
    u = found.inside(f, found.load(f), moved)
    assert u[-count:] == pytest.approx(moved, rel=1e-9, abs=1e-9)
    assert (K @ u - f)[:-count] == pytest.approx(np.zeros(K.shape[0] - count), abs=1e-9)

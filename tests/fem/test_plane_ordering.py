"""Nested dissection: a permutation that repeats, and that keeps factors small."""

import numpy as np
import pytest
from scipy.sparse.linalg import splu
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.cells import Cells
from fem.plane.discretisation import vector_basis
from fem.plane.ordering import nested_dissection

MESHES = {
    "tri6": MeshTri2.from_mesh(MeshTri1.init_tensor(*[np.linspace(0, 1, 41)] * 2)),
    "quad9": MeshQuad2.from_mesh(MeshQuad1.init_tensor(*[np.linspace(0, 1, 41)] * 2)),
}
every_mesh = pytest.mark.parametrize("kind", MESHES)


@every_mesh
def test_every_unknown_has_one_place(kind):
    basis = vector_basis(MESHES[kind])
    np.testing.assert_array_equal(np.sort(nested_dissection(basis)), np.arange(basis.N))


@every_mesh
def test_both_unknowns_of_a_node_follow_each_other(kind):
    basis = vector_basis(MESHES[kind])
    x, y = nested_dissection(basis)[basis.nodal_dofs]
    np.testing.assert_array_equal(abs(x - y), 1)


@pytest.mark.parametrize("cells", [1, 2, 3])
def test_meshes_of_few_cells_have_an_order_too(cells):
    mesh = MeshQuad1.init_tensor(np.linspace(0, 1, cells + 1), np.linspace(0, 1, 2))
    basis = vector_basis(mesh)
    np.testing.assert_array_equal(np.sort(nested_dissection(basis)), np.arange(basis.N))


@every_mesh
def test_factors_are_as_small_as_by_minimum_degree(kind):
    basis = vector_basis(MESHES[kind])
    one = np.ones(MESHES[kind].nelements)
    free = np.setdiff1d(np.arange(basis.N), basis.get_dofs(basis.mesh.boundary_facets()).all())
    order = free[np.argsort(nested_dissection(basis)[free])]
    K = Cells.of(basis, one, one).stiffness()

    def entries(dofs, permc_spec):
        A = K[dofs][:, dofs].tocsc()
        symmetric = {"SymmetricMode": True}
        return splu(A, permc_spec=permc_spec, diag_pivot_thresh=0.0, options=symmetric).nnz

    # 1.04 times here; 0.83 times at 10^5 unknowns
    assert entries(order, "NATURAL") < 1.1 * entries(free, "MMD_AT_PLUS_A")

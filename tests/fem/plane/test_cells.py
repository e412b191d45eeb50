"""Cells: weak forms that they stand for, an order of small factors, and folds that are refused."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.sparse.linalg import splu
from skfem import MeshQuad2, MeshTri1, MeshTri2

from fem.plane.cells import Cells
from fem.plane.discretisation import vector_basis
from fem.plane.material import Elastic
from fem.plane.ordering import nested_dissection
from fem.plane.solve import solve_plane
from tests.fem.plane.models import every_element, mapped

HALVES = np.linspace(0, 1, 3)


@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_nested_dissection_numbers_every_unknown_and_keeps_factors_small(kind):
    mesh = mapped(kind, np.linspace(0, 1, 41), np.linspace(0, 1, 41))
    basis = vector_basis(mesh)
    place = nested_dissection(basis)
    np.testing.assert_array_equal(np.sort(place), np.arange(basis.N))
    x, y = place[basis.nodal_dofs]
    np.testing.assert_array_equal(abs(x - y), 1)  # unknowns of a node follow each other
    one = np.ones(mesh.nelements)
    free = np.setdiff1d(np.arange(basis.N), basis.get_dofs(mesh.boundary_facets()).all())
    K = Cells.of(basis, one, one).stiffness()

    def entries(dofs, permc_spec):
        A = K[dofs][:, dofs].tocsc()
        symmetric = {"SymmetricMode": True}
        return splu(A, permc_spec=permc_spec, diag_pivot_thresh=0.0, options=symmetric).nnz

    # 1.04 times here; 0.83 times at 10^5 unknowns
    order = free[np.argsort(place[free])]
    assert entries(order, "NATURAL") < 1.1 * entries(free, "MMD_AT_PLUS_A")


def square(kind, old=None, new=None):
    """Two by two on the unit square, the node at `old` put to `new`."""
    mesh = mapped(kind, HALVES, HALVES)
    x = mesh.doflocs.copy()
    if old is not None:
        x[:, np.hypot(*(x - np.reshape(old, (2, 1)))) < 1e-9] = np.reshape(new, (2, 1))
    return replace(mesh, doflocs=x)


def pulled(mesh, own=None):
    return solve_plane(
        mesh, materials=Elastic(E=1.0, nu=0.3), assumption="plane strain", degree=own,
        supports={"left": "xy"}, tractions={"right": (1.0, 0.0)},
    )  # fmt: skip


@pytest.mark.parametrize(
    ("kind", "old", "new"),
    [
        pytest.param("tri6", (0.25, 0.0), (0.55, 0.0), id="middle beyond its corner"),
        pytest.param("quad9", (0.25, 0.0), (0.25, 0.49), id="middle through the opposite side"),
        pytest.param("quad4", (0.5, 0.5), (0.25, 0.25), id="corner of 180 degrees"),
        pytest.param("quad4", (0.5, 0.5), (1.2, 0.5), id="node dragged out of its cells"),
        pytest.param("quad4", (0.5, 0.5), (np.nan, 0.5), id="no number"),
    ],
)
def test_cells_that_fold_or_flatten_are_refused(kind, old, new):
    with pytest.raises(ValueError, match=r"cell \d of \d, about .* is folded"):
        vector_basis(square(kind, old, new), 1)


def test_a_fold_between_the_nodes_is_seen_at_a_quadrature_point():
    # found at random among quadratic cells: from -3.9 to -0.05 at its nodes, 0.2 at a Gauss point
    nodes = np.array([
        (0, 0), (0, 1), (1, 1), (1, 0),
        (-0.072, 0.782), (0.203, 0.738), (0.973, 0.447), (0.72, -0.11), (0.698, 0.447),
    ])  # fmt: skip
    cell = MeshQuad2(nodes.T, np.arange(4)[:, None])
    x = nodes.copy()
    x[cell.dofs.element_dofs[:, 0]] = nodes  # scikit-fem numbers the edges its own way
    with pytest.raises(ValueError, match=r"cell 0 of 1, .* to 0\.2"):
        vector_basis(replace(cell, doflocs=x.T))


@every_element
def test_cells_that_run_clockwise_or_are_thin_are_as_good(kind):
    mesh = square(kind)
    mirrored = replace(mesh, doflocs=mesh.doflocs * [[1], [-1]])  # every determinant negative
    energy = pulled(mesh).strain_energy
    assert pulled(mirrored).strain_energy == pytest.approx(energy, rel=1e-12)
    x, y = mesh.doflocs
    vector_basis(replace(mesh, doflocs=np.array([x, 1e-4 * y * (1 - 0.999 * x)])))


def test_a_cell_that_is_inverted_between_its_neighbours_is_refused():
    # each map of its own keeps its sign: only the neighbours tell
    mesh = MeshTri1.init_tensor(HALVES, HALVES)
    x = mesh.doflocs.copy()
    x[:, np.argmin(np.hypot(*(x - 0.5)))] += (0.6, 0.02)
    mesh = replace(mesh, doflocs=x)
    for one in (mesh, MeshTri2.from_mesh(mesh)):
        with pytest.raises(ValueError, match=r"same side of their common edge about .* inverted"):
            vector_basis(one)

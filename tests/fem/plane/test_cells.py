"""Cells: an ordering with small factors, refusal of folded cells, and stored factors."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.sparse.linalg import splu
from skfem import MeshQuad2, MeshTri1, MeshTri2

from fem.plane import discretisation, factors
from fem.plane.cells import Cells
from fem.plane.discretisation import vector_basis
from fem.plane.factors import FACTORS
from fem.plane.material import Elastic
from fem.plane.ordering import nested_dissection
from fem.plane.recent import Recent
from fem.plane.solve import solve_plane
from tests.fem.plane.models import mapped

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


def test_a_fold_between_the_nodes_is_detected_at_a_quadrature_point():
    # a random quadratic cell with determinants of -3.9 to -0.05 at its nodes, 0.2 at a Gauss point
    nodes = np.array([
        (0, 0), (0, 1), (1, 1), (1, 0),
        (-0.072, 0.782), (0.203, 0.738), (0.973, 0.447), (0.72, -0.11), (0.698, 0.447),
    ])  # fmt: skip
    cell = MeshQuad2(nodes.T, np.arange(4)[:, None])
    x = nodes.copy()
    x[cell.dofs.element_dofs[:, 0]] = nodes  # scikit-fem numbers the edges in another order
    with pytest.raises(ValueError, match=r"cell 0 of 1, .* to 0\.2"):
        vector_basis(replace(cell, doflocs=x.T))


def test_a_cell_that_is_inverted_between_its_neighbours_is_refused():
    # each map by itself has the right sign: only the neighbours reveal the fold
    mesh = MeshTri1.init_tensor(HALVES, HALVES)
    x = mesh.doflocs.copy()
    x[:, np.argmin(np.hypot(*(x - 0.5)))] += (0.6, 0.02)
    mesh = replace(mesh, doflocs=x)
    for one in (mesh, MeshTri2.from_mesh(mesh)):
        with pytest.raises(ValueError, match=r"same side of their common edge about .* inverted"):
            vector_basis(one)


STEEL = Elastic(E=210e9, nu=0.3)


@pytest.fixture(autouse=True)
def forgotten():
    """Nothing stored by other tests."""
    FACTORS.clear()
    discretisation.NUMBERS.clear()


@pytest.fixture
def factorisations(monkeypatch):
    """The matrices that are factorised."""
    seen = []
    own = factors.Cholesky

    def counting(A, **options):
        seen.append(A)
        return own(A, **options)

    monkeypatch.setattr(factors, "Cholesky", counting)
    return seen


def plate(bend=0.0, n=6):
    """A plate on curved cells, wavy by `bend`."""
    return mapped("quad9", np.linspace(0, 2, n), np.linspace(0, 1, 4), lambda x, y: (
        x + bend * y**2, y + bend * np.sin(2 * x)
    ))  # fmt: skip


def pressed(mesh, material=STEEL, p=1e6, **more):
    given = {"assumption": "plane stress", "supports": {"bottom": "xy"}, "pressures": {"top": p}}
    return solve_plane(mesh, materials=material, **given | more)


def same(one, other):
    return np.array_equal(one.u, other.u) and np.array_equal(one.internal, other.internal)


@pytest.mark.parametrize(
    ("other", "count"),
    [
        (lambda: pressed(plate(), p=2.5e6), 1),
        (lambda: pressed(plate(), Elastic(E=123.4e9, nu=0.3), thickness=3.0), 1),
        (lambda: pressed(plate(), Elastic(E=210e9, nu=0.3 + 1e-9)), 2),
        (lambda: pressed(plate(1e-9)), 2),
        (lambda: pressed(plate(n=7)), 2),
        (lambda: pressed(plate(), supports={"bottom": "y"}, anchors={(0.0, 0.0): "x"}), 2),
    ],
    ids=["load", "modulus, thickness", "nu", "a node that moved", "more cells", "supports"],
)
def test_only_another_matrix_is_factorised_again(other, count, factorisations):
    pressed(plate())
    after = other()
    assert len(factorisations) == count
    FACTORS.clear()
    assert same(after, other())
    assert len(factorisations) == count + 1
    assert after.residual < 1e-20


def test_what_takes_too_much_room_is_not_stored_and_displaces_nothing():
    recent = Recent(most=9, room=10)
    for k, size in ((1, 4), (2, 5), (3, 11), (4, 3)):
        recent.get((k,), lambda k=k: k, lambda _, size=size: size)
    assert [entry[1] for entry in recent.kept] == [4, 2]

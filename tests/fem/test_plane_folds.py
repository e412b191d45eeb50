"""Cells that fold over or flatten are refused by number and place; clockwise ones are not."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.discretisation import vector_basis
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

KINDS = {
    "tri3": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad4": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}
AXIS = np.linspace(0, 1, 3)
both_degrees = pytest.mark.parametrize("degree", [1, 2])


def square(kind, move=lambda x: x):
    """Two by two on the unit square, coordinates (2, n) changed by `move`."""
    straight, shape = KINDS[kind]
    grid = straight.init_tensor(AXIS, AXIS)
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({"left": lambda x: x[0] == 0, "right": lambda x: x[0] == 1})
    return replace(mesh, doflocs=move(mesh.doflocs.copy()))


def moved(old, new):
    """The node at `old` put to `new`."""

    def move(x):
        x[:, np.hypot(*(x - np.reshape(old, (2, 1)))) < 1e-9] = np.reshape(new, (2, 1))
        return x

    return move


def pulled(mesh, degree=None):
    return solve_plane(
        mesh, materials=Elastic(E=1.0, nu=0.3), assumption="plane strain", degree=degree,
        supports={"left": "xy"}, tractions={"right": (1.0, 0.0)},
    )  # fmt: skip


@both_degrees
@pytest.mark.parametrize("away", [0.0, 1e6])
def test_a_node_dragged_out_of_its_cells_folds_the_first_of_them(degree, away):
    mesh = square("quad4", moved((0.5, 0.5), (1.2, 0.5)))
    mesh = replace(mesh, doflocs=mesh.doflocs + away)
    place = rf"\({away + 0.925:.10g}, {away + 0.25:.10g}\)"  # mean corner of the lower right one
    with pytest.raises(ValueError, match=f"cell 2 of 4, about {place}, is folded"):
        pulled(mesh, degree)


@both_degrees
@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_a_middle_node_beyond_its_corner_folds_the_cell(kind, degree):
    mesh = square(kind, moved((0.25, 0.0), (0.55, 0.0)))
    with pytest.raises(ValueError, match=r"cell \d of \d, about .* is folded"):
        pulled(mesh, degree)


@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_a_fold_between_corners_and_quadrature_points_is_seen_at_a_middle_node(kind):
    # the edge's middle dragged in through the opposite side
    inwards = moved((0.25, 0.0), (0.25, 0.49))
    with pytest.raises(ValueError, match="is folded"):
        vector_basis(square(kind, inwards), 1)


def test_a_fold_between_the_nodes_is_seen_at_a_quadrature_point():
    # found at random among quadratic cells: from -3.9 to -0.05 at its nodes, 0.2 at a Gauss point
    nodes = np.array([
        (0, 0), (0, 1), (1, 1), (1, 0),
        (-0.072, 0.782), (0.203, 0.738), (0.973, 0.447), (0.72, -0.11), (0.698, 0.447),
    ])  # fmt: skip
    cell = MeshQuad2(nodes.T, np.arange(4)[:, None])
    x = nodes.copy()
    x[cell.dofs.element_dofs[:, 0]] = nodes  # scikit-fem numbers the edges its own way
    cell = replace(cell, doflocs=x.T)
    with pytest.raises(ValueError, match=r"cell 0 of 1, .* to 0\.2"):
        vector_basis(cell)


@pytest.mark.parametrize("kind", KINDS)
def test_a_cell_without_area_is_flat(kind):
    with pytest.raises(ValueError, match=r"is folded or flat: .* from 0 to 0"):
        vector_basis(square(kind, lambda x: x * np.array([[1.0], [0.0]])))


def test_a_corner_of_180_degrees_is_flat():
    with pytest.raises(ValueError, match="is folded or flat"):
        vector_basis(square("quad4", moved((0.5, 0.5), (0.25, 0.25))))


def test_a_node_that_is_no_number_is_refused():
    with pytest.raises(ValueError, match="is folded or flat"):
        vector_basis(square("quad4", moved((0.5, 0.5), (np.nan, 0.5))))


@pytest.mark.parametrize("kind", KINDS)
def test_cells_that_run_clockwise_are_as_good(kind):
    # mirrored: every determinant negative
    there, back = (pulled(square(kind, lambda x, s=s: s * x)) for s in ([[1], [1]], [[1], [-1]]))
    assert back.strain_energy == pytest.approx(there.strain_energy, rel=1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_thin_and_tapered_cells_are_no_folds(kind):
    def thin(x):
        return np.array([x[0], 1e-4 * x[1] * (1 - 0.999 * x[0])])

    vector_basis(square(kind, thin))


@pytest.mark.parametrize("kind", ["tri3", "tri6"])
def test_a_cell_that_is_inverted_between_its_neighbours_is_refused(kind):
    # each map of its own keeps its sign: only the neighbours tell
    def move(x):
        middle = np.argmin(np.hypot(*(x - 0.5)))
        x[:, middle] += (0.6, 0.02)
        return x

    straight, shape = KINDS[kind]
    mesh = replace(straight.init_tensor(AXIS, AXIS), doflocs=move(square("tri3").doflocs))
    with pytest.raises(ValueError, match=r"same side of their common edge about .* inverted"):
        vector_basis(mesh if shape is straight else shape.from_mesh(mesh))


def test_triangles_of_either_turn_side_by_side_are_not_inverted():
    mesh = square("tri3")
    t = mesh.t.copy()
    t[1:, ::2] = t[:0:-1, ::2]
    vector_basis(MeshTri1(mesh.doflocs, t, sort_t=False))

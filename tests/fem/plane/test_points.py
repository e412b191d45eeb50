"""Displacement and stress at any point: from the cell it lies in, walls and edges included."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshTri1

from fem.plane.discretisation import vector_basis
from fem.plane.locate import locate
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import KINDS, every_element

E, NU = 200.0, 0.25
curved_element = pytest.mark.parametrize("kind", ["tri6", "quad9"])
UNIT = np.linspace(0, 1, 7)
GRAD = np.array([[0.01, 0.004], [-0.02, 0.03]])  # of the linear displacement, about any origin


def block(kind, place, x=UNIT, y=UNIT, hole=0.0):
    """The unit square, every node moved by `place`, with all its outline named."""
    straight, shape, _ = KINDS[kind]
    grid = straight.init_tensor(x, y)
    centre = grid.p[:, grid.t].mean(axis=1)
    grid = grid.remove_elements(np.flatnonzero(np.abs(centre - 0.5).max(axis=0) < hole))
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = replace(mesh, doflocs=place(*mesh.doflocs))
    return mesh.with_boundaries({"outline": mesh.boundary_facets()})


def wavy(x, y):
    """All edges parabolas, where the cells have nodes for them; areas within 0.4 to 1.7."""
    return np.array([x + 0.06 * np.sin(5 * y + x), y + 0.07 * np.cos(6 * x)])


def arc(x, y):
    """Quarter ring of radii 1 and 2."""
    return (1 + x) * np.array([np.cos(np.pi / 2 * y), np.sin(np.pi / 2 * y)])


def linear(mesh, grad=GRAD, about=(0.0, 0.0)):
    """The body under a linear displacement of its outline, which it follows inside."""
    centre = np.reshape(about, (2, 1, 1))
    moved = {"xy"[i]: lambda x, i=i: np.tensordot(grad[i], x - centre[..., 0], 1) for i in (0, 1)}
    return solve_plane(
        mesh, materials=Elastic(E=E, nu=NU), assumption="plane stress",
        supports={"outline": moved},
    )  # fmt: skip


def hooke(grad=GRAD):
    """Plane stress xx, yy, xy, zz of a displacement gradient."""
    e, g = np.diag(grad), grad[0, 1] + grad[1, 0]
    normal = E / (1 - NU**2) * (e + NU * e[::-1])
    return np.array([*normal, E / (2 * (1 + NU)) * g, 0.0])


def anywhere(mesh, count=500, seed=1):
    """Random points of the mesh, by random coordinates in random cells."""
    rng = np.random.default_rng(seed)
    cell, X = rng.integers(mesh.nelements, size=count), rng.random((2, count))
    if isinstance(mesh, MeshTri1):
        X = np.where(X.sum(axis=0) > 1, 1 - X, X)
    return mesh.mapping().F(X[:, :, None], tind=cell)[..., 0]


@every_element
def test_a_linear_field_is_exact_at_any_point_of_curved_cells(kind):
    mesh = block(kind, wavy)
    x = anywhere(mesh)
    found = linear(mesh).at(x)
    np.testing.assert_array_equal(found.x, x)
    np.testing.assert_allclose(found.u, GRAD @ x, atol=1e-14)
    np.testing.assert_allclose(found.stress, np.tile(hooke(), (x.shape[1], 1)).T, atol=1e-11)
    assert found.weight.shape == (x.shape[1],)
    assert found.normal.size == 0
    solution = linear(block(kind, lambda x, y: np.array([x, y])))
    words = r"the point \(1\.001, 0\.25\) lies outside the mesh, 0\.001 from its boundary"
    with pytest.raises(ValueError, match=words):
        solution.at(np.array([[0.5, 1.001, 0.2], [0.5, 0.25, -3.0]]))
    for points in (np.zeros(2), np.zeros((3, 4)), np.array([[0.1, np.nan], [0.1, 0.1]])):
        with pytest.raises(ValueError, match=r"points are finite, of shape \(2, m\)"):
            solution.at(points)


@curved_element
def test_points_of_a_true_circle_lie_on_its_wall_of_parabolas(kind):
    mesh = block(kind, arc, y=np.linspace(0, 1, 13))
    phi = np.linspace(0, np.pi / 2, 101)
    ring = linear(mesh)
    for radius in (1.0, 2.0):
        x = radius * np.array([np.cos(phi), np.sin(phi)])
        np.testing.assert_allclose(ring.at(x).u, GRAD @ x, atol=1e-13)


@pytest.mark.parametrize(("kind", "seed"), [("quad4", 0), ("tri6", 1), ("quad9", 2)])
def test_distorted_cells_hide_no_point(kind, seed):
    # beside some of the quadratic cells a second point maps to x, where Newton's steps may end
    reach = {"tri6": 0.09}.get(kind, 0.12) / (UNIT.size - 1)  # more would fold cells
    mesh, rng = block(kind, lambda x, y: np.array([x, y])), np.random.default_rng(seed)
    movable = slice(mesh.nvertices if kind in ("tri6", "quad9") else 0, None)
    x = mesh.doflocs.copy()
    x[:, movable] += rng.uniform(-reach, reach, x[:, movable].shape)
    mesh = replace(mesh, doflocs=x)
    vector_basis(mesh)  # nothing is folded
    x = anywhere(mesh, 5_000, seed)
    cell, X = locate(mesh, x)
    np.testing.assert_allclose(mesh.mapping().F(X[:, :, None], tind=cell)[..., 0], x, atol=1e-14)


@every_element
def test_each_point_takes_the_material_of_its_own_cell(kind):
    mesh = block(kind, lambda x, y: np.array([x, y]))
    mesh = mesh.with_subdomains({"west": lambda x: x[0] < 0.5, "east": lambda x: x[0] > 0.5})
    # strain 7 west and 1 east of the middle make one uniform stress of 7, without strain along y
    body = solve_plane(
        mesh, materials={"west": Elastic(E=1.0, nu=0.0), "east": Elastic(E=7.0, nu=0.0)},
        assumption="plane stress",
        supports={"outline": {"y": 0.0, "x": lambda x: np.minimum(7 * x[0], x[0] + 3)}},
    )  # fmt: skip
    found = body.at(np.array([[0.05, 0.95, 0.45, 0.55], [0.3, 0.8, 0.3, 0.8]]))
    np.testing.assert_allclose(found.stress.T, np.tile([7.0, 0, 0, 0], (4, 1)), atol=1e-11)

"""Evaluation of a solution: at any point, on boundaries, in bodies, and as plain arrays."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshTri1

from fem.plane.discretisation import vector_basis
from fem.plane.locate import locate
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import every_element, mapped, trapezoid

E, NU = 200.0, 0.25
ROUND_OFF = 1e-12  # relative
SIDES = ("left", "right", "bottom", "top")


def strains(xx, yy, xy, assumption="plane stress"):
    """Hooke's law in space: xx, yy and xy."""
    zz = 0.0 if assumption == "plane stress" else NU * (xx + yy)
    return (xx - NU * (yy + zz)) / E, (yy - NU * (xx + zz)) / E, (1 + NU) / E * xy


def stressed(mesh, xx, yy, xy, assumption="plane stress"):
    """A uniform stress, by displacements of all sides."""
    e_xx, e_yy, e_xy = strains(xx, yy, xy, assumption)
    moved = {
        "x": lambda x: e_xx * x[0] + e_xy * x[1], "y": lambda x: e_xy * x[0] + e_yy * x[1],
    }  # fmt: skip
    return solve_plane(
        mesh, materials=Elastic(E=E, nu=NU), assumption=assumption,
        supports=dict.fromkeys(SIDES, moved),
    )  # fmt: skip


@every_element
def test_weights_normals_and_means_are_those_of_lengths_and_areas(kind):
    s = stressed(trapezoid(kind), 1.0, 0.0, 0.0)
    sides = {"left": (1, (-1, 0)), "bottom": (4, (0, -1)), "right": (3, (1, 0)),
             "top": (np.sqrt(20), (-2, 4) / np.sqrt(20))}  # fmt: skip
    for name, (length, normal) in sides.items():
        side = s.on_boundary(name)
        assert side.weight.sum() == pytest.approx(length, rel=ROUND_OFF)
        np.testing.assert_allclose(side.normal.T, [normal] * side.x.shape[1], atol=ROUND_OFF)
    # (1 + 3) / 2 * 4 = 8 in all, of which (1 + 1.5) / 2 * 1 west of x = 1
    areas = [s.in_body(*name).weight.sum() for name in ((), ("west",), ("east",))]
    assert areas == pytest.approx([8, 1.25, 6.75], rel=ROUND_OFF)
    # centroid of the slope's x is 2, that of the area (56/3) / 8, whatever the sizes of the cells
    top, inside = s.on_boundary("top"), s.in_body()
    assert top.mean(top.x[0]) == pytest.approx(2, rel=ROUND_OFF)
    assert inside.mean(inside.x[0]) == pytest.approx(7 / 3, rel=ROUND_OFF)
    assert inside.normal.size == 0


def test_tractions_and_polar_components_turn_with_normal_and_place():
    s = stressed(trapezoid("quad4"), 3.0, -1.0, 2.0)
    n_x, n_y = -2 / np.sqrt(20), 4 / np.sqrt(20)
    traction = s.on_boundary("top").traction()
    expected = 3 * n_x + 2 * n_y, 2 * n_x - n_y
    np.testing.assert_allclose(traction.T, [expected] * traction.shape[1], atol=1e-11)
    np.testing.assert_allclose(s.cells()["von_mises"], 5, rtol=1e-10)
    held = stressed(trapezoid("quad9"), 3.0, -1.0, 2.0, "plane strain")  # zz = nu (xx + yy) = 0.5
    np.testing.assert_allclose(held.cells()["von_mises"], np.sqrt(24.25), rtol=1e-10)
    # along x: radial xx, hoop yy, shear xy; along y: yy, xx, -xy; at 45 deg: half the sum +- xy
    inside = s.in_body()
    for direction, radial, hoop, shear in (
        ((1, 0), 3, -1, 2),
        ((0, 1), -1, 3, -2),
        ((1, 1), 1 + 2, 1 - 2, -2),
    ):
        x = np.repeat(np.reshape(direction, (2, 1)) * 5.0, inside.x.shape[1], axis=1)
        _, *found = replace(inside, x=x).polar()
        np.testing.assert_allclose(np.array(found).T, [[radial, hoop, shear]] * x.shape[1])


@every_element
def test_displacements_are_read_at_nodes_and_as_means_in_fixed_or_local_directions(kind):
    s = stressed(trapezoid(kind), 1.0, 0.0, 0.0)  # u = (x, -nu y) / E
    assert s.displacement_at((4, 3)) == pytest.approx((4 / E, -3 * NU / E), rel=ROUND_OFF)
    assert s.mean_displacement("right", (1, 0)) == pytest.approx(4 / E, rel=ROUND_OFF)
    assert s.mean_displacement("right", (0, 2)) == pytest.approx(-NU * 3 / E, rel=ROUND_OFF)
    # u . (1, y) = (4 - nu y^2) / E over y from 0 to 3: 4 - 3 nu
    local = s.mean_displacement("right", lambda x: np.array([np.ones_like(x[0]), x[1]]))
    assert local == pytest.approx((4 - 3 * NU) / E, rel=ROUND_OFF)


@every_element
def test_cells_are_plain_arrays_that_fit_each_other(kind):
    mesh = trapezoid(kind)
    cells = stressed(mesh, 1.0, 0.0, 0.0).cells()
    assert cells["points"].shape == (mesh.nvertices, 2) == (12, 2)  # 4 x 3 grid lines
    assert cells["cells"].shape == (mesh.nelements, 3 if "tri" in kind else 4)
    x, y = cells["points"].T
    np.testing.assert_allclose(cells["displacement"], np.array([x, -NU * y]).T / E, atol=ROUND_OFF)
    # the shoelace formula over every cell gives the whole
    a = cells["points"][cells["cells"]]
    b = np.roll(a, -1, axis=1)
    area = np.abs((a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]).sum(axis=1)) / 2
    assert area.sum() == pytest.approx(8, rel=ROUND_OFF)


def test_polar_components_are_taken_about_their_centre():
    # equal strains along x and y: u points away from the origin and is (1 - nu) p / E times r
    s = stressed(trapezoid("tri3"), 4.0, 4.0, 0.0).in_body()
    for centre in ((0.0, 0.0), (1.5, 0.5)):
        away, *_ = s.polar(centre)
        off = s.x - np.reshape(centre, (2, 1))
        expected = (1 - NU) * 4 / E * (s.x * off / np.hypot(*off)).sum(axis=0)
        np.testing.assert_allclose(away, expected, atol=1e-12)


UNIT = np.linspace(0, 1, 7)


def wavy(x, y):
    """All edges parabolas, where the cells have nodes for them; areas within 0.4 to 1.7."""
    return np.array([x + 0.06 * np.sin(5 * y + x), y + 0.07 * np.cos(6 * x)])


def anywhere(mesh, count=500, seed=1):
    """Random points of the mesh, by random coordinates in random cells."""
    rng = np.random.default_rng(seed)
    cell, X = rng.integers(mesh.nelements, size=count), rng.random((2, count))
    if isinstance(mesh, MeshTri1):
        X = np.where(X.sum(axis=0) > 1, 1 - X, X)
    return mesh.mapping().F(X[:, :, None], tind=cell)[..., 0]


@every_element
def test_a_linear_field_is_exact_at_any_point_of_curved_cells(kind):
    mesh = mapped(kind, UNIT, UNIT, wavy)
    x, (e_xx, e_yy, e_xy) = anywhere(mesh), strains(3.0, -1.0, 2.0)
    found = stressed(mesh, 3.0, -1.0, 2.0).at(x)
    np.testing.assert_array_equal(found.x, x)
    np.testing.assert_allclose(found.u, np.array([[e_xx, e_xy], [e_xy, e_yy]]) @ x, atol=1e-14)
    np.testing.assert_allclose(found.stress.T, [(3.0, -1.0, 2.0, 0.0)] * x.shape[1], atol=1e-11)
    assert found.weight.shape == (x.shape[1],)
    assert found.normal.size == 0
    solution = stressed(mapped(kind, UNIT, UNIT), 3.0, -1.0, 2.0)
    words = r"the point \(1\.001, 0\.25\) lies outside the mesh, 0\.001 from its boundary"
    with pytest.raises(ValueError, match=words):
        solution.at(np.array([[0.5, 1.001, 0.2], [0.5, 0.25, -3.0]]))
    for points in (np.zeros(2), np.zeros((3, 4)), np.array([[0.1, np.nan], [0.1, 0.1]])):
        with pytest.raises(ValueError, match=r"points must be finite and of shape \(2, m\)"):
            solution.at(points)


@pytest.mark.parametrize(("kind", "seed"), [("quad4", 0), ("tri6", 1), ("quad9", 2)])
def test_distorted_cells_hide_no_point(kind, seed):
    # beside some of the quadratic cells a second point maps to x, where Newton's steps may end
    reach = {"tri6": 0.09}.get(kind, 0.12) / (UNIT.size - 1)  # more would fold cells
    mesh, rng = mapped(kind, UNIT, UNIT), np.random.default_rng(seed)
    movable = slice(mesh.nvertices if kind in ("tri6", "quad9") else 0, None)
    x = mesh.doflocs.copy()
    x[:, movable] += rng.uniform(-reach, reach, x[:, movable].shape)
    mesh = replace(mesh, doflocs=x)
    vector_basis(mesh)  # nothing is folded
    x = anywhere(mesh, 5_000, seed)
    cell, X = locate(mesh, x)
    np.testing.assert_allclose(mesh.mapping().F(X[:, :, None], tind=cell)[..., 0], x, atol=1e-14)


@every_element
def test_each_point_takes_the_material_of_its_cell(kind):
    mesh = mapped(kind, UNIT, UNIT, split=0.5)
    # strain 7 west and 1 east of the middle make one uniform stress of 7, without strain along y
    moved = {"y": 0.0, "x": lambda x: np.minimum(7 * x[0], x[0] + 3)}
    body = solve_plane(
        mesh, materials={"west": Elastic(E=1.0, nu=0.0), "east": Elastic(E=7.0, nu=0.0)},
        assumption="plane stress",
        supports=dict.fromkeys(SIDES, moved),
    )  # fmt: skip
    found = body.at(np.array([[0.05, 0.95, 0.45, 0.55], [0.3, 0.8, 0.3, 0.8]]))
    np.testing.assert_allclose(found.stress.T, np.tile([7.0, 0, 0, 0], (4, 1)), atol=1e-11)

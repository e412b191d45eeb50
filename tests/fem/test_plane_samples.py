"""What is read off a solution: samples on boundaries and in bodies, means, and plain arrays."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

E, NU = 200.0, 0.25
ROUND_OFF = 1e-12  # relative
KINDS = {
    "tri3": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad4": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}
every_element = pytest.mark.parametrize("kind", KINDS)


def named(kind, x, y):
    straight, shape = KINDS[kind]
    grid = straight.init_tensor(x, y)
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    return mesh.with_boundaries({
        "left": lambda p: p[0] == x[0],
        "right": lambda p: p[0] == x[-1],
        "bottom": lambda p: p[1] == y[0],
        "top": lambda p: p[1] == y[-1],
    }).with_subdomains({"west": lambda p: p[0] < x[1], "east": lambda p: p[0] > x[1]})  # fmt: skip


def trapezoid(kind):
    """Corners (0, 0), (4, 0), (4, 3), (0, 1)."""
    mesh = named(kind, np.array([0, 0.25, 0.6, 1]), np.array([0, 0.3, 1]))
    x, y = mesh.doflocs
    return replace(mesh, doflocs=np.array([4 * x, (1 + 2 * x) * y]))


def stressed(mesh, xx, yy, xy, assumption="plane stress"):
    """A uniform stress, by displacements from Hooke's law on two opposite sides."""
    zz = 0.0 if assumption == "plane stress" else NU * (xx + yy)
    e_xx, e_yy = (xx - NU * (yy + zz)) / E, (yy - NU * (xx + zz)) / E
    e_xy = (1 + NU) / E * xy
    moved = {
        "x": lambda x: e_xx * x[0] + e_xy * x[1],
        "y": lambda x: e_xy * x[0] + e_yy * x[1],
    }  # fmt: skip
    return solve_plane(
        mesh, materials=Elastic(E=E, nu=NU), assumption=assumption,
        supports=dict.fromkeys(("left", "right", "bottom", "top"), moved),
    )  # fmt: skip


@every_element
def test_weights_add_up_to_lengths_and_areas(kind):
    s = stressed(trapezoid(kind), 1.0, 0.0, 0.0)
    lengths = {"left": 1, "bottom": 4, "right": 3, "top": np.hypot(4, 2)}
    for side, length in lengths.items():
        assert s.on_boundary(side).weight.sum() == pytest.approx(length, rel=ROUND_OFF)
    # (1 + 3) / 2 * 4 = 8 in all, of which (1 + 1.5) / 2 * 1 west of x = 1
    assert s.in_body().weight.sum() == pytest.approx(8, rel=ROUND_OFF)
    assert s.in_body("west").weight.sum() == pytest.approx(1.25, rel=ROUND_OFF)
    assert s.in_body("east").weight.sum() == pytest.approx(6.75, rel=ROUND_OFF)


@every_element
def test_normals_have_unit_length_and_point_outwards(kind):
    s = stressed(trapezoid(kind), 1.0, 0.0, 0.0)
    outwards = {"left": (-1, 0), "bottom": (0, -1), "right": (1, 0), "top": (-2, 4) / np.sqrt(20)}
    for side, normal in outwards.items():
        found = s.on_boundary(side).normal
        np.testing.assert_allclose(found.T, [normal] * found.shape[1], atol=ROUND_OFF)
    assert s.in_body().normal.size == 0


@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_normals_and_weights_of_a_curved_outline_obey_the_divergence_theorem(kind):
    mesh = named(kind, np.array([0, 0.25, 0.6, 1]), np.array([0, 0.3, 1]))
    x, y = mesh.doflocs
    mesh = replace(mesh, doflocs=np.array([x + 0.3 * y * y, y + 0.2 * np.sin(3 * x)]))
    s = stressed(mesh, 1.0, 0.0, 0.0)
    sides = [s.on_boundary(side) for side in ("left", "right", "bottom", "top")]
    # int n = 0 and int x . n = 2 A over a closed outline, exact on its parabolas
    closed = sum((side.weight * side.normal).sum(axis=1) for side in sides)
    np.testing.assert_allclose(closed, 0, atol=ROUND_OFF)
    twice = sum(float(side.weight @ (side.x * side.normal).sum(axis=0)) for side in sides)
    assert twice == pytest.approx(2 * s.in_body().weight.sum(), rel=ROUND_OFF)


@every_element
def test_the_traction_on_a_slope_is_stress_times_normal(kind):
    s = stressed(trapezoid(kind), 3.0, -1.0, 2.0)
    n_x, n_y = -2 / np.sqrt(20), 4 / np.sqrt(20)
    found = s.on_boundary("top").traction()
    expected = 3 * n_x + 2 * n_y, 2 * n_x - n_y
    np.testing.assert_allclose(found.T, [expected] * found.shape[1], atol=1e-11)


@every_element
def test_polar_components_turn_with_the_point(kind):
    # along x: radial xx, hoop yy, shear xy; along y: yy, xx, -xy; at 45 deg: half the sum +- xy
    s = stressed(trapezoid(kind), 3.0, -1.0, 2.0).in_body()
    for direction, radial, hoop, shear in (
        ((1, 0), 3, -1, 2),
        ((0, 1), -1, 3, -2),
        ((1, 1), 1 + 2, 1 - 2, -2),
        ((-1, 1), 1 - 2, 1 + 2, 2),
    ):
        at = replace(s, x=np.repeat(np.reshape(direction, (2, 1)) * 5.0, s.x.shape[1], axis=1))
        _, *components = at.polar()
        np.testing.assert_allclose(
            components, np.repeat([[radial], [hoop], [shear]], s.x.shape[1], axis=1), atol=1e-10
        )


@every_element
def test_polar_components_are_taken_about_their_centre(kind):
    # equal strains along x and y: u points away from the origin and is (1 - nu) p / E times r
    s = stressed(trapezoid(kind), 4.0, 4.0, 0.0).in_body()
    away, radial, hoop, shear = s.polar()
    np.testing.assert_allclose(away, (1 - NU) * 4 / E * np.hypot(*s.x), rtol=1e-10)
    centred, *_ = s.polar((1.5, 0.5))
    direction = (s.x - [[1.5], [0.5]]) / np.hypot(*(s.x - [[1.5], [0.5]]))
    np.testing.assert_allclose(
        centred, (1 - NU) * 4 / E * (s.x * direction).sum(axis=0), atol=1e-12
    )
    np.testing.assert_allclose([radial, hoop], 4.0, rtol=1e-10)
    np.testing.assert_allclose(shear, 0.0, atol=1e-10)


@every_element
def test_means_are_taken_over_length_and_area_not_over_points(kind):
    s = stressed(trapezoid(kind), 1.0, 0.0, 0.0)
    # centroid of the slope's x is 2, that of the area (56/3) / 8, whatever the sizes of the cells
    top, inside = s.on_boundary("top"), s.in_body()
    assert top.mean(top.x[0]) == pytest.approx(2, rel=ROUND_OFF)
    assert inside.mean(inside.x[0]) == pytest.approx(7 / 3, rel=ROUND_OFF)


@every_element
def test_the_mean_displacement_follows_a_fixed_or_a_local_direction(kind):
    s = stressed(trapezoid(kind), 1.0, 0.0, 0.0)  # u = (x, -nu y) / E
    assert s.mean_displacement("right", (1, 0)) == pytest.approx(4 / E, rel=ROUND_OFF)
    assert s.mean_displacement("right", (0, 2)) == pytest.approx(-NU * 3 / E, rel=ROUND_OFF)
    # u . (1, y) = (4 - nu y^2) / E over y from 0 to 3: 4 - 3 nu
    local = s.mean_displacement("right", lambda x: np.array([np.ones_like(x[0]), x[1]]))
    assert local == pytest.approx((4 - 3 * NU) / E, rel=ROUND_OFF)


@every_element
def test_displacements_are_read_at_nodes(kind):
    s = stressed(trapezoid(kind), 1.0, 0.0, 0.0)
    assert s.displacement_at((4, 3)) == pytest.approx((4 / E, -3 * NU / E), rel=ROUND_OFF)
    assert s.displacement_at((2.4, 0)) == pytest.approx((2.4 / E, 0), abs=ROUND_OFF)


@pytest.mark.parametrize(
    ("stress", "assumption", "mises"),
    [
        pytest.param((5, 0, 0), "plane stress", 5, id="uniaxial"),
        pytest.param((0, 0, 2), "plane strain", 2 * np.sqrt(3), id="pure shear"),
        pytest.param((-4, -4, 0), "plane stress", 4, id="equal biaxial"),
        pytest.param((-4, -4, 0), "plane strain", 4 * (1 - 2 * NU), id="biaxial, held outwards"),
    ],
)
@every_element
def test_cells_carry_von_mises_stress(kind, stress, assumption, mises):
    cells = stressed(trapezoid(kind), *stress, assumption).cells()
    np.testing.assert_allclose(cells["von_mises"], mises, rtol=1e-10)
    np.testing.assert_allclose(cells["stress"][:, :3], [stress] * len(cells["stress"]), atol=1e-10)


@every_element
def test_cells_are_plain_arrays_that_fit_each_other(kind):
    mesh = trapezoid(kind)
    cells = stressed(mesh, 1.0, 0.0, 0.0).cells()
    corners = 3 if "tri" in kind else 4
    assert cells["points"].shape == (mesh.nvertices, 2) == (12, 2)  # 4 x 3 grid lines
    assert cells["cells"].shape == (mesh.nelements, corners)
    x, y = cells["points"].T
    np.testing.assert_allclose(cells["displacement"], np.array([x, -NU * y]).T / E, atol=ROUND_OFF)
    # the shoelace formula over every cell gives the whole
    a = cells["points"][cells["cells"]]
    b = np.roll(a, -1, axis=1)
    area = np.abs((a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]).sum(axis=1)) / 2
    assert area.sum() == pytest.approx(8, rel=ROUND_OFF)


@pytest.mark.parametrize(
    "pair", [(0.0, -2.0), [0.0, -2.0], np.array([0.0, -2.0])], ids=lambda p: type(p).__name__
)
def test_a_vector_may_be_any_pair(pair):
    s = solve_plane(
        trapezoid("quad9"), materials=Elastic(E=E, nu=NU), assumption="plane stress",
        supports={"left": "xy"}, tractions={"right": pair}, body_forces=pair,
        point_forces={(4, 0): pair},
    )  # fmt: skip
    # 3 on the right side, 8 in the area and 1 at the corner, each times 2
    assert s.reaction("left")[1] == pytest.approx(24, rel=1e-9)

"""What is read off a solution: samples on boundaries and in bodies, means, and plain arrays."""

from dataclasses import replace

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import every_element, trapezoid

E, NU = 200.0, 0.25
ROUND_OFF = 1e-12  # relative


def stressed(mesh, xx, yy, xy, assumption="plane stress"):
    """A uniform stress, by displacements from Hooke's law on all sides."""
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


@pytest.mark.parametrize(
    ("stress", "assumption", "mises"),
    [
        pytest.param((5, 0, 0), "plane stress", 5, id="uniaxial"),
        pytest.param((0, 0, 2), "plane strain", 2 * np.sqrt(3), id="pure shear"),
        pytest.param((-4, -4, 0), "plane strain", 4 * (1 - 2 * NU), id="biaxial, held outwards"),
    ],
)
def test_cells_carry_von_mises_stress(stress, assumption, mises):
    cells = stressed(trapezoid("quad9"), *stress, assumption).cells()
    np.testing.assert_allclose(cells["von_mises"], mises, rtol=1e-10)
    np.testing.assert_allclose(cells["stress"][:, :3], [stress] * len(cells["stress"]), atol=1e-10)


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

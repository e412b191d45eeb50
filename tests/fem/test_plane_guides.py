"""Walls that hold a body along their normal or tangent, whichever way they face."""

from dataclasses import replace
from math import cos, radians, sin

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

MATERIAL = Elastic(E=1000.0, nu=0.3)
KINDS = {
    "tri3": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad4": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}
ROUND_OFF = 1e-12  # relative, condition number times 1e-16
every_element = pytest.mark.parametrize("kind", KINDS)
both_assumptions = pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])


def block(kind, tilt):
    """2 x 1, turned by `tilt` about the origin at its corner."""
    straight, shape = KINDS[kind]
    grid = straight.init_tensor(np.array([0, 0.6, 1.3, 2]), np.array([0, 0.4, 1]))
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "left": lambda x: x[0] == 0,
        "right": lambda x: x[0] == 2,
        "bottom": lambda x: x[1] == 0,
        "top": lambda x: x[1] == 1,
    })  # fmt: skip
    turn = np.array([[cos(tilt), -sin(tilt)], [sin(tilt), cos(tilt)]])
    return replace(mesh, doflocs=turn @ mesh.doflocs)


def in_plane(assumption):
    E, nu = MATERIAL.E, MATERIAL.nu
    return (E, nu) if assumption == "plane stress" else (E / (1 - nu**2), nu / (1 - nu))


@both_assumptions
@pytest.mark.parametrize("tilt", [30, 135, -100], ids=lambda t: f"{t} deg")
@every_element
def test_a_tilted_block_between_two_smooth_walls_is_in_uniaxial_stress(kind, tilt, assumption):
    p, tilt = 3.0, radians(tilt)
    s = solve_plane(
        block(kind, tilt), materials=MATERIAL, assumption=assumption,
        supports={"left": "n", "bottom": "n"}, pressures={"right": p},
    )  # fmt: skip
    c, n = cos(tilt), sin(tilt)
    expected = np.reshape([-p * c * c, -p * n * n, -p * c * n], (3, 1))  # -p along the block
    found = s.in_body().stress[:3]
    np.testing.assert_allclose(found, np.broadcast_to(expected, found.shape), atol=1e-11 * p)
    # the far corner moves by the strains -p / E' and nu' p / E' of lengths 2 and 1
    E, nu = in_plane(assumption)
    along, up = -2 * p / E, nu * p / E
    x, y = s.displacement_at((2 * c - n, 2 * n + c))
    assert (x, y) == pytest.approx((along * c - up * n, along * n + up * c), abs=ROUND_OFF)


@both_assumptions
@every_element
def test_a_wall_that_runs_round_a_corner_holds_both_of_its_sides(kind, assumption):
    p, tilt = 3.0, radians(30)
    mesh = block(kind, tilt)
    round_corner = np.concatenate([mesh.boundaries["left"], mesh.boundaries["bottom"]])
    s = solve_plane(
        mesh.with_boundaries({"left and bottom": round_corner}), materials=MATERIAL,
        assumption=assumption, supports={"left and bottom": "n"}, pressures={"right": p},
    )  # fmt: skip
    c, n = cos(tilt), sin(tilt)
    expected = np.reshape([-p * c * c, -p * n * n, -p * c * n], (3, 1))  # -p along the block
    found = s.in_body().stress[:3]
    np.testing.assert_allclose(found, np.broadcast_to(expected, found.shape), atol=1e-11 * p)
    assert s.reaction("left and bottom")[:2] == pytest.approx((p * c, p * n), abs=1e-9 * p)


@every_element
def test_a_wall_that_moves_along_its_normal_and_tangent_takes_the_block_along(kind):
    tilt = radians(25)
    s = solve_plane(
        block(kind, tilt), materials=MATERIAL, assumption="plane strain",
        supports={"right": {"n": 0.2, "t": 0.1}},
    )  # fmt: skip
    # outward normal of "right" is (cos, sin), its tangent (-sin, cos)
    expected = 0.2 * cos(tilt) - 0.1 * sin(tilt), 0.2 * sin(tilt) + 0.1 * cos(tilt)
    np.testing.assert_allclose(s.in_body().u.T, [expected] * s.in_body().u.shape[1], atol=1e-12)


@every_element
def test_a_wall_may_press_more_at_one_end_than_at_the_other(kind):
    # "right" turns by a small angle about the block's corner at (2, 0): n = -angle * height,
    # "left" the same about its own corner, and "bottom" slides: all of it a rigid rotation
    tilt, angle = radians(40), 0.01
    along, up = np.array([cos(tilt), sin(tilt)]), np.array([-sin(tilt), cos(tilt)])
    s = solve_plane(
        block(kind, tilt), materials=MATERIAL, assumption="plane stress",
        supports={
            "right": {"n": lambda x: -angle * (up @ x)},
            "left": {"n": lambda x: angle * (up @ x)},
            "bottom": {"n": lambda x: -angle * (along @ x)},
        },
    )  # fmt: skip
    x = s.in_body().x
    np.testing.assert_allclose(s.in_body().u, angle * np.array([-x[1], x[0]]), atol=1e-14)
    assert s.strain_energy < 1e-24


@every_element
def test_a_corner_between_two_smooth_walls_cannot_move(kind):
    s = solve_plane(
        block(kind, radians(30)), materials=MATERIAL, assumption="plane strain",
        supports={"left": "n", "bottom": "n"}, pressures={"top": 5.0, "right": 2.0},
    )  # fmt: skip
    assert s.displacement_at((0, 0)) == pytest.approx((0, 0), abs=1e-17)


@both_assumptions
@every_element
def test_a_mirrored_block_whose_cells_run_clockwise_has_its_normals_outwards_too(kind, assumption):
    p, g = 3.0, 2.0
    mesh = block(kind, 0.0)
    s = solve_plane(
        replace(mesh, doflocs=mesh.doflocs * [[-1], [1]]), materials=MATERIAL,
        assumption=assumption, supports={"left": "n", "bottom": "n"}, pressures={"right": p},
        body_forces=(0.0, -g),
    )  # fmt: skip
    np.testing.assert_allclose(s.on_boundary("right").normal[0], -1, rtol=ROUND_OFF)
    mean = s.in_body().mean
    assert mean(s.in_body().stress[0]) == pytest.approx(-p, rel=1e-11)
    assert mean(s.in_body().stress[1]) == pytest.approx(-g / 2, rel=1e-11)  # at mid-height
    assert s.reaction("bottom")[1] == pytest.approx(2 * g, rel=1e-11)

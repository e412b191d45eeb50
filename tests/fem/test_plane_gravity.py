"""Bodies under their own weight."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

HEIGHT, WIDTH, WEIGHT = 3.0, 1.0, 7.0  # weight per volume
MATERIAL = Elastic(E=50.0, nu=0.3)
ROUND_OFF = 1e-12  # relative
KINDS = {
    "tri3": (MeshTri1, MeshTri1, 1),
    "tri6": (MeshTri1, MeshTri2, 2),
    "quad4": (MeshQuad1, MeshQuad1, 1),
    "quad9": (MeshQuad1, MeshQuad2, 2),
}
every_element = pytest.mark.parametrize("kind", KINDS)
quadratic = pytest.mark.parametrize("kind", ["tri6", "quad9"])
both_assumptions = pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])


def column(kind):
    """Cells of unequal size; the body "cap" begins at two thirds of the height."""
    straight, shape, _ = KINDS[kind]
    grid = straight.init_tensor(
        WIDTH * np.array([0, 0.3, 1]), HEIGHT * np.array([0, 1 / 6, 2 / 3, 0.8, 1])
    )
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    return mesh.with_boundaries({
        "ground": lambda x: x[1] == 0,
        "top": lambda x: x[1] == HEIGHT,
        "walls": lambda x: (x[0] == 0) | (x[0] == WIDTH),
    }).with_subdomains({
        "shaft": lambda x: x[1] < 2 / 3 * HEIGHT, "cap": lambda x: x[1] > 2 / 3 * HEIGHT
    })  # fmt: skip


def oedometric(assumption):
    """Modulus of compression without side strain."""
    E, nu = MATERIAL.E, MATERIAL.nu
    if assumption == "plane stress":
        return E / (1 - nu**2)
    return E * (1 - nu) / ((1 + nu) * (1 - 2 * nu))


@both_assumptions
@quadratic
def test_a_column_between_smooth_walls_settles_by_a_parabola_that_the_elements_contain(
    kind, assumption
):
    solution = solve_plane(
        column(kind), materials=MATERIAL, assumption=assumption,
        supports={"ground": "y", "walls": "n"}, body_forces=(0.0, -WEIGHT), thickness=2.0,
    )  # fmt: skip
    M = oedometric(assumption)
    inside = solution.in_body()
    y = inside.x[1]
    np.testing.assert_allclose(inside.u[1], -WEIGHT / M * (HEIGHT * y - y**2 / 2), atol=1e-12)
    np.testing.assert_allclose(inside.stress[1], -WEIGHT * (HEIGHT - y), atol=1e-11 * WEIGHT)
    energy = 2.0 * WIDTH * WEIGHT**2 * HEIGHT**3 / (6 * M)  # int yy^2 / (2 M)
    assert solution.strain_energy == pytest.approx(energy, rel=ROUND_OFF)
    assert solution.potential_energy == pytest.approx(-energy, rel=ROUND_OFF)


@both_assumptions
@every_element
def test_the_ground_carries_the_weight_under_its_centre(kind, assumption):
    solution = solve_plane(
        column(kind), materials=MATERIAL, assumption=assumption,
        supports={"ground": "xy"}, body_forces=(0.0, -WEIGHT), thickness=2.0,
    )  # fmt: skip
    weight = 2.0 * WEIGHT * WIDTH * HEIGHT
    expected = (0, weight, weight * WIDTH / 2)
    assert solution.reaction("ground") == pytest.approx(expected, abs=ROUND_OFF * weight)


@both_assumptions
@pytest.mark.parametrize("kind", ["quad4", "tri6", "quad9"])  # linear triangles load nodes unevenly
def test_a_heavy_cap_presses_a_weightless_shaft_evenly(kind, assumption):
    solution = solve_plane(
        column(kind), materials=MATERIAL, assumption=assumption,
        supports={"ground": "y", "walls": "n"}, body_forces={"cap": (0.0, -WEIGHT)},
    )  # fmt: skip
    shaft = solution.in_body("shaft")
    np.testing.assert_allclose(shaft.stress[1], -WEIGHT * HEIGHT / 3, rtol=1e-11)
    sink = WEIGHT * HEIGHT / 3 * (2 / 3 * HEIGHT) / oedometric(assumption)
    x, y = solution.displacement_at((0, 2 / 3 * HEIGHT))
    assert (x, y) == pytest.approx((0, -sink), abs=ROUND_OFF)


@both_assumptions
def test_weight_and_force_that_varies_by_body_add_up(assumption):
    # the shaft is pulled down by a force that grows as y, the cap pushed up by a constant
    solution = solve_plane(
        column("quad9"), materials=MATERIAL, assumption=assumption,
        supports={"ground": "y", "walls": "n"},
        body_forces={"shaft": lambda x: np.array([0 * x[0], -x[1]]), "cap": (0.0, 2.0)},
    )  # fmt: skip
    pull = 2.0 * HEIGHT / 3 - (2 / 3 * HEIGHT) ** 2 / 2  # by hand
    assert solution.reaction("ground")[1] == pytest.approx(-WIDTH * pull, abs=ROUND_OFF)


@both_assumptions
@quadratic
def test_a_hanging_bar_draws_in_as_the_elasticity_solution_says(kind, assumption):
    # Timoshenko & Goodier, art. 96 in the plane: yy = w y alone, u = -nu' w x y / E',
    # v = w / (2 E') (y^2 - h^2 + nu' x^2) about (0, h); the top carries w h
    E, nu = MATERIAL.E, MATERIAL.nu
    if assumption == "plane strain":
        E, nu = E / (1 - nu**2), nu / (1 - nu)
    mesh = column(kind)
    mesh = replace(mesh, doflocs=mesh.doflocs - np.array([[0.3 * WIDTH], [0.0]]))
    solution = solve_plane(
        mesh, materials=MATERIAL, assumption=assumption, supports={},
        anchors={(0, HEIGHT): "xy", (0, 0): "x"},
        body_forces=(0.0, -WEIGHT), tractions={"top": (0.0, WEIGHT * HEIGHT)},
    )  # fmt: skip
    inside = solution.in_body()
    x, y = inside.x
    np.testing.assert_allclose(inside.u[0], -nu * WEIGHT * x * y / E, atol=1e-11)
    v = WEIGHT / (2 * E) * (y**2 - HEIGHT**2 + nu * x**2)
    np.testing.assert_allclose(inside.u[1], v, atol=1e-11)

"""A rigid motion strains nothing and stores nothing."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

E = 210e9
ROUND_OFF = 1e-12  # relative; a few hundred roundings of 1e-16 and differences over a tenth
SHIFT, TURN = (0.3, -0.2), 0.1  # any motion about as large as the body
KINDS = {
    "tri3": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad4": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}
every_element = pytest.mark.parametrize("kind", KINDS)


def move_x(x):
    return SHIFT[0] - TURN * x[1]


def move_y(x):
    return SHIFT[1] + TURN * x[0]


def quarter_ring(kind):
    """Radii 1 and 2, mapped from (r, phi)."""
    straight, shape = KINDS[kind]
    grid = straight.init_tensor(np.linspace(1, 2, 4), np.linspace(0, np.pi / 2, 7))
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({"bore": lambda x: x[0] == 1.0, "rim": lambda x: x[0] == 2.0})
    r, phi = mesh.doflocs
    return replace(mesh, doflocs=np.array([r * np.cos(phi), r * np.sin(phi)]))


@pytest.mark.parametrize("assumption", ["plane strain", "plane stress"])
@every_element
def test_a_bore_moved_rigidly_takes_the_ring_along(kind, assumption):
    solution = solve_plane(
        quarter_ring(kind), materials=Elastic(E=E, nu=0.3), assumption=assumption,
        supports={"bore": {"x": move_x, "y": move_y}},
    )  # fmt: skip
    inside = solution.in_body()
    np.testing.assert_allclose(inside.u, [move_x(inside.x), move_y(inside.x)], atol=ROUND_OFF)
    np.testing.assert_allclose(inside.stress, 0.0, atol=ROUND_OFF * E)
    assert 0 <= solution.strain_energy < E * ROUND_OFF**2


@every_element
def test_a_ring_turned_by_its_bore_and_rim_alike_needs_no_torque(kind):
    solution = solve_plane(
        quarter_ring(kind), materials=Elastic(E=E, nu=0.3), assumption="plane strain",
        supports={name: {"x": move_x, "y": move_y} for name in ("bore", "rim")},
    )  # fmt: skip
    for name in ("bore", "rim"):
        assert solution.reaction(name) == pytest.approx((0, 0, 0), abs=ROUND_OFF * E)


@every_element
def test_a_load_free_body_stays_where_it_is(kind):
    solution = solve_plane(
        quarter_ring(kind), materials=Elastic(E=E, nu=0.3), assumption="plane stress",
        supports={"bore": "xy"},
    )  # fmt: skip
    assert not solution.u.any()
    assert solution.strain_energy == 0.0
    assert solution.residual == 0.0


@pytest.mark.parametrize("shift", [0.0, 1.0, -300.0], ids=lambda d: f"foot moved by {d:g} depths")
@pytest.mark.parametrize("length", [100, 1000], ids=lambda n: f"{n} depths long")
def test_a_slender_cantilever_that_moves_far_and_strains_little_keeps_its_energy(length, shift):
    # depth 1, edge stress s = 1e-4 E in pure bending, exact in these elements:
    # energy = (2 s / depth)^2 / (2 E) * (depth^3 / 12) * length
    s = 1e-4 * E
    mesh = MeshQuad2.from_mesh(
        MeshQuad1.init_tensor(np.linspace(0, length, length // 20 + 1), np.linspace(-0.5, 0.5, 2))
    ).with_boundaries({"foot": lambda x: x[0] == 0, "head": lambda x: x[0] == length})
    solution = solve_plane(
        mesh, materials=Elastic(E=E, nu=0.3), assumption="plane stress",
        supports={"foot": {"x": shift}}, anchors={(0, 0): {"y": -shift}},
        tractions={"head": lambda x: np.array([2 * s * x[1], 0 * x[0]])},
    )  # fmt: skip
    # the curvature 2e-4 bends the end by up to 100 depths; with the shift that rounds u by 1e-16 of
    # 400, over half a depth 1e-13 of strain against 1e-4
    energy = (2 * s) ** 2 / (2 * E) / 12 * length
    assert solution.strain_energy == pytest.approx(energy, rel=1e-9)
    sink = 1e-4 * length**2
    assert solution.displacement_at((length, 0))[1] == pytest.approx(-shift - sink, rel=1e-9)

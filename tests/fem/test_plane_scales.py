"""Neither the size of a body nor its distance from the origin changes what happens to it."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane

E, NU, P = 210e9, 0.3, 100e6  # plane strain
KINDS = {
    "tri3": (MeshTri1, MeshTri1),
    "tri6": (MeshTri1, MeshTri2),
    "quad4": (MeshQuad1, MeshQuad1),
    "quad9": (MeshQuad1, MeshQuad2),
}
DEGREE = {"tri3": 1, "tri6": 2, "quad4": 1, "quad9": 2}
every_element = pytest.mark.parametrize("kind", KINDS)
sizes = pytest.mark.parametrize("size", [1e-6, 1.0, 1e4], ids=lambda s: f"bore of {s:g} m")
places = pytest.mark.parametrize(
    "away", [(0, 0), (1e3, -2e3), (1e6, 0), (0, -1e6)], ids=lambda a: f"at {a[0]:g}, {a[1]:g} bores"
)


def ring(kind, size, away, through):
    """A quarter with radii `size` and 1.5 `size`, about `away` times its size."""
    straight, shape = KINDS[kind]
    grid = straight.init_tensor(
        np.linspace(1, 1.5, through + 1), np.linspace(0, np.pi / 2, 4 * through + 1)
    )
    mesh = shape.from_mesh(grid) if shape is not straight else grid
    mesh = mesh.with_boundaries({
        "bore": lambda x: x[0] == 1.0,
        "y=0": lambda x: x[1] == 0,
        "x=0": lambda x: x[1] == np.pi / 2,
    })  # fmt: skip
    r, phi = mesh.doflocs
    x = np.array([r * np.cos(phi), r * np.sin(phi)])
    return replace(mesh, doflocs=size * (x + np.reshape(away, (2, 1))))


def bore_movement(size):
    """Lame in plane strain: p r_i / E' ((r_o^2 + r_i^2) / (r_o^2 - r_i^2) + nu')."""
    return P * size * (1 - NU**2) / E * (3.25 / 1.25 + NU / (1 - NU))


def assert_within_mesh_error(quantity, exact, kind):
    """`quantity` of 4 and of 8 cells through the wall: the finer one's GCI covers `exact`."""
    coarse, fine = quantity(4), quantity(8)
    gci = 1.25 * abs(fine - coarse) / (2 ** (2 * DEGREE[kind]) - 1)
    assert fine == pytest.approx(exact, abs=gci)


@places
@sizes
@every_element
def test_lames_ring_is_met_at_every_size_and_place(kind, size, away):
    centre = size * np.array(away)
    s = {
        through: solve_plane(
            ring(kind, size, away, through), materials=Elastic(E=E, nu=NU),
            assumption="plane strain", supports={"x=0": "n", "y=0": "y"}, pressures={"bore": P},
        )
        for through in (4, 8)
    }  # fmt: skip

    def movement(through):
        bore = s[through].on_boundary("bore")
        return bore.mean(bore.polar(tuple(centre))[0])

    assert_within_mesh_error(movement, bore_movement(size), kind)
    energy = P * size * bore_movement(size) * np.pi / 4
    assert_within_mesh_error(lambda through: s[through].strain_energy, energy, kind)
    # a cut carries half a ring's pressure; a distance of 1e6 costs 6 of 16 digits
    assert s[4].reaction("x=0")[:2] == pytest.approx((-P * size, 0), abs=1e-9 * P * size)


@places
@every_element
def test_a_bore_pressed_out_far_away_is_pressed_out_along_its_own_radius(kind, away):
    delta = 1e-3

    def stored(through):
        return solve_plane(
            ring(kind, 1.0, away, through), materials=Elastic(E=E, nu=NU),
            assumption="plane strain", supports={"x=0": "n", "y=0": "n", "bore": {"n": -delta}},
        ).strain_energy  # fmt: skip

    energy = (delta / bore_movement(1.0)) * P * delta * np.pi / 4
    assert_within_mesh_error(stored, energy, kind)


@places
@every_element
def test_anchors_and_forces_find_their_nodes(kind, away):
    foot, head = (tuple(np.add(away, point)) for point in ((1, 0), (1.5, 0)))
    s = solve_plane(
        ring(kind, 1.0, away, 4), materials=Elastic(E=E, nu=NU), assumption="plane stress",
        supports={"x=0": "xy"}, anchors={foot: "x"}, point_forces={head: (0.0, 1.0)},
    )  # fmt: skip
    assert s.displacement_at(foot)[0] == 0.0
    # half the force times its movement; 6 of 16 digits lost to the distance, 2 to the solve
    assert s.strain_energy == pytest.approx(s.displacement_at(head)[1] / 2, rel=1e-8)


@pytest.mark.parametrize("away", [(1e10, 0), (0, -1e10), (1e10, 1e10)], ids=str)
@every_element
def test_a_body_is_not_taken_for_loose_because_it_is_far_away(kind, away):
    # quarters are exact beside 1e10, sums of shape functions are rounded by 1e-6: a uniform pull
    # stretches the unit square by p / E but for a few of those
    straight, shape = KINDS[kind]
    axis = np.array([0, 0.25, 1])
    mesh = shape.from_mesh(straight.init_tensor(axis, axis))
    mesh = mesh.with_boundaries({"left": lambda x: x[0] == 0, "right": lambda x: x[0] == 1})
    s = solve_plane(
        replace(mesh, doflocs=mesh.doflocs + np.reshape(away, (2, 1))),
        materials=Elastic(E=E, nu=NU), assumption="plane stress", supports={"left": "x"},
        anchors={away: "y"}, tractions={"right": (P, 0.0)},
    )  # fmt: skip
    assert s.mean_displacement("right", (1, 0)) == pytest.approx(P / E, rel=1e-5)


@every_element
def test_millimetres_and_megapascals_are_metres_and_pascals(kind):
    def movement(through):
        s = solve_plane(
            ring(kind, 1000.0, (0, 0), through), materials=Elastic(E=E / 1e6, nu=NU),
            assumption="plane strain", supports={"x=0": "x", "y=0": "y"},
            pressures={"bore": P / 1e6},
        )  # fmt: skip
        return s.mean_displacement("bore", lambda x: x / np.hypot(*x))

    assert_within_mesh_error(movement, 1000 * bore_movement(1.0), kind)


@pytest.mark.parametrize("away", [0.0, 1e5, 1e6], ids=lambda a: f"{a:g} lengths away")
@pytest.mark.parametrize("slenderness", [128, 1024])  # exact beside 1e6
@pytest.mark.parametrize("kind", ["tri6", "quad9"])
def test_a_slender_beam_far_away_stores_half_its_loads_work(kind, slenderness, away):
    straight, shape = KINDS[kind]
    grid = straight.init_tensor(np.linspace(0, 1, 65), np.array([0, 1 / slenderness]))
    mesh = shape.from_mesh(grid).with_boundaries({
        "left": lambda x: x[0] == 0, "right": lambda x: x[0] == 1,
    })  # fmt: skip
    mesh = replace(mesh, doflocs=mesh.doflocs + away)
    s = solve_plane(
        mesh, materials=Elastic(E=E, nu=NU), assumption="plane stress",
        supports={"left": "xy"}, tractions={"right": (0.0, 1.0)},
    )  # fmt: skip
    assert 2 * s.strain_energy == pytest.approx(s.f @ s.u, rel=1e-11, abs=0)  # Clapeyron
    body = s.in_body()
    # and so say its stresses: sigma : C^-1 : sigma / 2
    xx, yy, xy, _ = body.stress
    stored = (xx**2 + yy**2 - 2 * NU * xx * yy + 2 * (1 + NU) * xy**2) / (2 * E)
    assert body.weight @ stored == pytest.approx(s.strain_energy, rel=1e-11, abs=0)

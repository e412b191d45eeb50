"""Loads, reactions, energies and stresses belong together; units are the caller's."""

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from meshes.shell.panel import cylinder_panel, rectangle
from tests.fem.shell.grids import over

STEEL = Elastic(E=210e9, nu=0.3)
CLAMP = {"tail": "xyzabc"}
R, WIDTH, T = 0.3, 0.2, 0.004


def panel(count=3):
    return cylinder_panel(radius=R, angle=1.2, width=WIDTH, around=count, across=count)


def solve(mesh, **problem):
    problem = {"thickness": T, "materials": STEEL, "supports": CLAMP} | problem
    return solve_shell(
        mesh.points, mesh.cells, boundaries=mesh.boundaries, bodies=mesh.bodies, **problem
    )


def test_reactions_balance_forces_and_their_moments():
    mesh = panel()
    s = solve(
        mesh, edge_loads={"head": (1e3, 2e3, -3e3)}, pressures=2e4, surface_loads=(0, -5e3, 0),
        loads={mesh.nodes["head"]: (10, 20, 30, 1, 2, 3)},
    )  # fmt: skip
    force = s.f[:, :3].sum(axis=0)
    couple = (s.f[:, 3:] + np.cross(mesh.points, s.f[:, :3])).sum(axis=0)
    held = s.reaction("tail")
    np.testing.assert_allclose(held, -np.concatenate([force, couple]), rtol=1e-7)
    free = np.setdiff1d(np.arange(len(mesh.points)), mesh.boundaries["tail"])
    np.testing.assert_allclose(s.reactions[free], 0, atol=1e-7 * abs(held).max())


def test_loads_add_up_to_their_densities_times_length_and_area():
    mesh = panel()
    angle = 1.2
    line = solve(mesh, edge_loads={"head": (7.0, 0, 0), "middle": (0, 5.0, 0)}).f.sum(axis=0)
    np.testing.assert_allclose(line[:2], (7 * WIDTH, 5 * R * angle), rtol=1e-4)
    area = solve(mesh, surface_loads={"arcs": (0, 0, 11.0)}).f.sum(axis=0)
    assert area[2] == pytest.approx(11 * R * angle * WIDTH, rel=1e-4)
    inwards = solve(mesh, pressures={"arcs": 13.0}).f.sum(axis=0)
    exact = -13 * R * WIDTH * np.array([1 - np.cos(angle), np.sin(angle)])
    np.testing.assert_allclose(inwards[:2], exact, rtol=1e-4)
    mesh = rectangle(length=2.0, width=1.0, along=3, across=2)  # varying from point to point
    f = solve(mesh, edge_loads={"middle": lambda x: np.array([0 * x[0], x[0] ** 2, 0 * x[0]])}).f
    assert f[:, 1].sum() == pytest.approx(8 / 3, rel=1e-12)
    f = solve(mesh, pressures=lambda x: x[0] * x[2]).f  # along -y
    assert f[:, 1].sum() == pytest.approx(-1.0, rel=1e-12)


def test_prescribed_movements_are_answered_by_the_forces_of_the_same_loads():
    mesh = panel()
    loaded = solve(mesh, edge_loads={"head": (0, -1e3, 0)}, ties={"head": "y"})
    moved = loaded.average("head")[1]
    pushed = solve(mesh, supports=CLAMP | {"head": {"y": moved}})
    assert pushed.reaction("head")[1] == pytest.approx(-1e3 * WIDTH, rel=1e-9)
    np.testing.assert_allclose(pushed.u, loaded.u, atol=1e-9 * abs(moved))


def test_bodies_have_their_own_thickness_and_material():
    grid = over(2, 1, lambda u, v: (2 * u, 0 * u, v))
    s = solve_shell(
        grid.points, grid.cells, boundaries=grid.boundaries,
        bodies={"thin": np.array([0]), "soft": np.array([1])},
        thickness={"thin": 0.5, "soft": 1.0},
        materials={"thin": Elastic(E=8.0, nu=0.0), "soft": Elastic(E=2.0, nu=0.0)},
        supports={"u=0": "xyzabc"}, edge_loads={"u=1": (1.0, 0, 0)},
    )  # fmt: skip
    assert s.average("u=1")[0] == pytest.approx(1 / 4 + 1 / 2, rel=1e-12)
    stress = s.membrane_stress[:, :, 0, 0]
    np.testing.assert_allclose(stress, np.array([[2.0], [1.0]]) + 0 * stress, rtol=1e-10)

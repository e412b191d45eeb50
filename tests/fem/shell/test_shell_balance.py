"""Shells: balance of loads and reactions, and strips, branches and a hemisphere by closed forms."""

from math import pi, radians

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from meshes.shell.panel import cylinder_panel, rectangle
from tests.fem.shell.grids import over

SYMMETRY = {"x": "xbc", "y": "yac", "z": "zab"}  # of planes across these axes


def test_the_pinched_hemisphere_yields_as_published():
    """0.0935 (Simo, Fox, Rifai 1989) with a hole of 18 deg; its rigid turns cost nothing."""

    def sphere(u, v):
        phi, lift = pi / 2 * u, radians(72) * v
        return 10 * np.cos(lift) * np.cos(phi), 10 * np.cos(lift) * np.sin(phi), 10 * np.sin(lift)

    grid = over(16, 16, sphere)
    pulled, pushed = int(grid.number[0, 0]), int(grid.number[-1, 0])
    s = solve_shell(
        grid.points, grid.cells, thickness=0.04, materials=Elastic(E=6.825e7, nu=0.3),
        boundaries=grid.boundaries,
        supports={"u=0": SYMMETRY["y"], "u=1": SYMMETRY["x"], pulled: "z"},
        loads={pulled: (1, 0, 0, 0, 0, 0), pushed: (0, -1, 0, 0, 0, 0)},
    )  # fmt: skip
    assert s.u[pulled, 0] == pytest.approx(0.0935, rel=2e-3)
    assert s.u[pushed, 1] == pytest.approx(-s.u[pulled, 0], rel=1e-9)


E, NU = 206e9, 0.3
STEEL = Elastic(E=E, nu=NU)
EDGES_HELD = {"middle": "zab", "edge": "zab"}  # an endless width
WIDE = E / (1 - NU**2)
G = E / (2 * (1 + NU))
SHEAR = 5 / 6
FORCE = 3.0  # per length


def tip(mesh, thickness, load, **more):
    """Average displacement of the head under that force per length; the tail is clamped."""
    s = solve_shell(
        mesh.points, mesh.cells, thickness=thickness, materials=STEEL,
        boundaries=mesh.boundaries, edge_loads={"head": load},
        supports={"tail": "xyzabc"} | more,
    )  # fmt: skip
    return s.average("head")


@pytest.mark.parametrize("t", [0.1, 1e-4])
def test_a_curved_strip_converges_to_castigliano_with_order_four(t):
    # of a quarter clamped at one end under a radial force at the other; at the angle a from there
    # M = R sin a, N = -sin a, V = cos a
    exact = FORCE * pi / 4 * (1 / (WIDE * t**3 / 12) + 1 / (WIDE * t) + 1 / (SHEAR * G * t))
    errors = []
    for around in (4, 8):
        mesh = cylinder_panel(radius=1.0, angle=pi / 2, width=0.3, around=around, across=1)
        errors.append(abs(tip(mesh, t, (0, FORCE, 0), **EDGES_HELD)[1] / exact - 1))
    assert errors[1] < 3e-5
    assert np.log2(errors[0] / errors[1]) == pytest.approx(4, abs=0.2), errors


DEPTH = 0.2


def joined(*grids):
    """One mesh of several, nodes at the same place being one; boundaries "name of the k-th"."""
    points = np.concatenate([g.points for g in grids])
    _, first, row = np.unique(points.round(9), axis=0, return_index=True, return_inverse=True)
    row, offset, cells, boundaries = row.ravel(), 0, [], {}
    for k, g in enumerate(grids):
        cells.append(row[g.cells + offset])
        boundaries |= {f"{name} of {k}": row[e + offset] for name, e in g.boundaries.items()}
        offset += len(g.points)
    return points[first], np.concatenate(cells), boundaries


def leaf(start, end, count=4):
    """From one line along z to another, both through points (x, y)."""
    (a, b), (c, d) = start, end
    return over(count, 1, lambda u, v: (a + (c - a) * u, b + (d - b) * u, DEPTH * v))


def test_a_branch_shares_the_moment_out_between_its_partners():
    """Three leaves meet; two are clamped, the third is bent by a force across its end."""
    t, L = 0.01, 1.0
    EI, GA = WIDE * t**3 / 12, SHEAR * G * t
    points, cells, boundaries = joined(
        leaf((-L, 0), (0, 0)), leaf((0, 0), (L, 0)), leaf((0, 0), (0, L))
    )
    sides = {name: "zab" for name in boundaries if name.startswith("v=")}
    s = solve_shell(
        points, cells, thickness=t, materials=STEEL, boundaries=boundaries,
        supports=sides | dict.fromkeys(("u=0 of 0", "u=1 of 1"), "xyzabc"),
        edge_loads={"u=1 of 2": (1.0, 0, 0)},
    )  # fmt: skip
    # slope-deflection with shear: (4 + phi)/(1 + phi) EI/L of each clamped leaf
    phi = 12 * EI / (GA * L**2)
    turn = -L / (2 * (4 + phi) / (1 + phi) * EI / L)
    node = np.argmin(np.abs(s.points).sum(axis=1))
    assert s.rotation[node, 2] == pytest.approx(turn, rel=1e-9)
    for end in ("u=0 of 0", "u=1 of 1"):
        assert s.reaction(end)[0] == pytest.approx(-DEPTH / 2, rel=1e-9)


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


def test_bodies_have_different_thicknesses_and_materials():
    grid = over(2, 1, lambda u, v: (2 * u, 0 * u, v))
    s = solve_shell(
        grid.points, grid.cells, boundaries=grid.boundaries,
        bodies={"thin": np.array([0]), "soft": np.array([1])},
        thickness={"thin": 0.5, "soft": 1.0},
        materials={"thin": Elastic(E=8.0, nu=0.0), "soft": Elastic(E=2.0, nu=0.0)},
        supports={"u=0": "xyzabc"}, edge_loads={"u=1": (1.0, 0, 0)},
    )  # fmt: skip
    assert s.average("u=1")[0] == pytest.approx(1 / 4 + 1 / 2, rel=1e-12)
    assert s.potential_energy == pytest.approx(-s.strain_energy, rel=1e-12)  # Clapeyron
    stress = s.membrane_stress[:, :, 0, 0]
    np.testing.assert_allclose(stress, np.array([[2.0], [1.0]]) + 0 * stress, rtol=1e-10)

"""Constant strain is exact, rigid motions have no energy, invalid input is named."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from fem.shell.strains import moduli, operator, unknowns
from tests.fem.shell.grids import over, straightened

E, NU, T = 210.0, 0.3, 0.05
STEEL = Elastic(E=E, nu=NU)
ROUND_OFF = 1e-10
TILT = Rotation.from_rotvec(0.7 * np.array([1, 2, 3]) / 14**0.5).as_matrix()
SURFACES = {
    "flat": lambda u, v: (u, v, 0 * u),
    "cylinder": lambda u, v: (np.sin(u), v, np.cos(u)),
    "saddle": lambda u, v: (u, v, 0.3 * u * v + 0.2 * u**2 - 0.3 * v**2),
    "skew": lambda u, v: (u + 0.2 * u * v, v - 0.15 * u * v, 0 * u),
}


def distorted():
    """Straight-sided cells, none a parallelogram, in the plane z = 0."""
    return straightened(
        over(
            3, 3, lambda u, v: (2 * u + 0.2 * np.sin(7 * u * v), v + 0.1 * np.sin(5 * u) * v, 0 * u)
        )
    )


def outer(grid):
    return np.unique(np.concatenate([grid.boundaries[name] for name in grid.boundaries]))


def solve_inside(displacement, rotation, nodes=None):
    """Distorted cells in a tilted plane, moved along their border; also what they should do."""
    flat = distorted()
    grid = flat._replace(points=flat.points @ TILT.T)
    exact_u = displacement(*flat.points.T).T @ TILT.T
    exact_r = rotation(*flat.points.T).T @ TILT.T
    supports = {
        int(node): dict(zip("xyzabc", (*exact_u[node], *exact_r[node]), strict=True))
        for node in outer(grid)
    }
    for node in range(len(flat.points)) if nodes == "turned" else ():
        held = dict(zip("abc", exact_r[node], strict=True))
        supports[node] = held | dict(supports.get(node, {}))
    solved = solve_shell(grid.points, grid.cells, thickness=T, materials=STEEL, supports=supports)
    return solved, exact_u, exact_r


def tilted(tensor):
    """A plane tensor in the tilted plane."""
    full = np.zeros((3, 3))
    full[:2, :2] = tensor
    return TILT @ full @ TILT.T


def hooke(e11, e22, e12):
    """Plane stress of three tensor strains."""
    factor = E / (1 - NU**2)
    s12 = E / (1 + NU) * e12
    return np.array([[factor * (e11 + NU * e22), s12], [s12, factor * (e22 + NU * e11)]])


def test_constant_membrane_strain():
    e11, e22, e12, turn = 2e-3, -1e-3, 0.7e-3, 0.4e-3
    s, u, rotation = solve_inside(
        lambda x, y, z: np.array([e11 * x + (e12 - turn) * y, (e12 + turn) * x + e22 * y, 0 * x]),
        lambda x, y, z: np.array([0 * x, 0 * x, turn + 0 * x]),
    )
    np.testing.assert_allclose(s.u, u, atol=ROUND_OFF * np.abs(u).max())
    np.testing.assert_allclose(s.rotation, rotation, atol=ROUND_OFF * np.abs(u).max())
    stress = tilted(hooke(e11, e22, e12))
    np.testing.assert_allclose(
        s.membrane_stress, np.broadcast_to(stress, s.membrane_stress.shape), atol=ROUND_OFF
    )
    np.testing.assert_allclose(s.bending_stress, 0, atol=ROUND_OFF)


def test_constant_curvature():
    a, b, c = 3e-3, -2e-3, 1e-3  # w = (a x^2 + b y^2)/2 + c x y, strains -w'' t/2 at +n
    s, u, rotation = solve_inside(
        lambda x, y, z: np.array([0 * x, 0 * x, (a * x**2 + b * y**2) / 2 + c * x * y]),
        lambda x, y, z: np.array([b * y + c * x, -(a * x + c * y), 0 * x]),
    )
    np.testing.assert_allclose(s.u, u, atol=ROUND_OFF * np.abs(u).max())
    np.testing.assert_allclose(s.rotation, rotation, atol=ROUND_OFF * np.abs(rotation).max())
    stress = tilted(hooke(a, b, c)) * -T / 2
    np.testing.assert_allclose(
        s.bending_stress, np.broadcast_to(stress, s.bending_stress.shape), atol=ROUND_OFF
    )
    np.testing.assert_allclose(s.shear_stress, 0, atol=ROUND_OFF)


def test_constant_transverse_shear():
    s, u, _ = solve_inside(
        lambda x, y, z: np.array([0 * x, 0 * x, 2e-3 * x - 1e-3 * y]),
        lambda x, y, z: np.zeros((3, x.size)),
        nodes="turned",
    )
    np.testing.assert_allclose(s.u, u, atol=ROUND_OFF * np.abs(u).max())
    shear = 5 / 6 * E / (2 * (1 + NU)) * TILT @ (2e-3, -1e-3, 0)
    np.testing.assert_allclose(
        s.shear_stress, np.broadcast_to(shear, s.shear_stress.shape), atol=ROUND_OFF
    )


@pytest.mark.parametrize(("name", "count"), [("flat", (1, 1)), ("saddle", (2, 2))])
def test_a_free_shell_has_six_motions_without_energy_and_no_more(name, count):
    grid = over(*count, SURFACES[name])
    B, area, _ = operator(grid.points[grid.cells])
    m = len(grid.cells)
    D = moduli(np.full(m, E), np.full(m, NU), np.full(m, T), area.sum(axis=1))
    cells = np.einsum("mqsu,mst,mqtv,mq->muv", B, D, B, area, optimize=True)
    K = np.zeros((6 * len(grid.points),) * 2)
    for k, own in zip(cells, unknowns(grid.cells), strict=True):
        K[np.ix_(own, own)] += k
    energies = np.linalg.eigvalsh(K)
    assert abs(energies[:6]).max() < 1e-14 * energies[-1]
    assert energies[6] > 1e-4 * T**2 * energies[-1]  # as stiff as bending


GRID = over(2, 1, lambda u, v: (u, v, 0 * u))
BODIES = {"left": np.array([0]), "right": np.array([1])}
GOOD = {
    "points": GRID.points,
    "cells": GRID.cells,
    "thickness": 0.1,
    "materials": Elastic(E=1.0, nu=0.3),
    "boundaries": GRID.boundaries,
    "bodies": BODIES,
    "supports": {"u=0": "xyzabc"},
    "edge_loads": {"u=1": (0.0, 0.0, 1.0)},
}
MOVED = GRID.points.copy()
MOVED[GRID.number[1, 0]] = GRID.points[GRID.number[4, 2]]
LOST = np.vstack([GRID.points, [9.0, 9.0, 9.0]])


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"points": GRID.points[:, :2]}, "points must have three finite coordinates"),
        ({"points": LOST}, "every node must belong to a cell, but node"),
        ({"points": MOVED}, "cell 0 is folded or has no area"),
        ({"cells": GRID.cells[:, :8]}, r"cells must have nine nodes each, got shape"),
        ({"cells": GRID.cells + 1}, "no node 15: the shell has nodes 0 to 14"),
        ({"thickness": 0.0}, "thickness must be positive and finite, got 0"),
        ({"thickness": {"left": 0.1}}, "1 of 2 cells have no thickness"),
        ({"materials": {"middle": Elastic(E=1.0, nu=0.0)}}, "no body 'middle'; bodies: left, rig"),
        (
            {"materials": {"left": Elastic(E=1.0, nu=0.0)}},
            "1 of 2 cells have no material",
        ),
        ({"supports": {"top": "xyz"}}, "no boundary 'top'; boundaries: u=0, u=1, v=0, v=1"),
        ({"supports": {"u=0": "xyr"}}, "boundary 'u=0': components must be x, y, z"),
        ({"supports": {99: "x"}}, "no node 99: the shell has nodes 0 to 14"),
        ({"supports": {"u=0": {"x": np.inf}}}, "'u=0': the value of x must be finite, got"),
        (
            {"supports": {"u=0": "xyzabc", "v=0": {"x": 1.0}}},
            "'v=0': x is already prescribed with another",
        ),
        ({"supports": {}}, "the shell can move rigidly"),
        ({"supports": {"u=0": "xyz"}}, r"can move rigidly \(.*turn about y\): support it against"),
        (
            {"supports": {"u=0": "xyzabc", 14: {"x": 1.0}}, "ties": {"v=1": "x"}},
            r"node 2: x is tied to a node with another",
        ),
        ({"ties": {"u=2": "x"}}, "no boundary 'u=2'"),
        ({"edge_loads": {"u=1": (0, 1)}}, "'u=1': a load must have three components"),
        ({"pressures": {"middle": 1.0}}, "no body 'middle'"),
        ({"loads": {3: (0, 0, 1)}}, "node 3: a load must have 3 forces and 3"),
    ],
)
def test_wrong_input_is_refused(change, message):
    problem = GOOD | change
    with pytest.raises(ValueError, match=message) as refused:
        solve_shell(problem.pop("points"), problem.pop("cells"), **problem)
    assert "\n" not in str(refused.value)


def test_each_part_needs_what_holds_it_and_that_may_be_a_tie():
    points = np.vstack([GRID.points, GRID.points + np.array([0, 0, 1])])
    apart = GOOD | {
        "bodies": {},
        "points": points,
        "cells": np.vstack([GRID.cells, GRID.cells + 15]),
    }
    with pytest.raises(ValueError, match="the part of node 15 can move rigidly"):
        solve_shell(apart.pop("points"), apart.pop("cells"), **apart)
    # held against all but a turn about y; a line of one height along x keeps it from that
    problem = GOOD | {"supports": {"u=0": "xyz"}, "ties": {"far": "z"}}
    problem["boundaries"] = GRID.boundaries | {"far": GRID.boundaries["v=0"][1:]}
    s = solve_shell(problem.pop("points"), problem.pop("cells"), **problem)
    assert np.abs(s.u).max() < 1e4  # a force of one on E = 1, 0.1 thick

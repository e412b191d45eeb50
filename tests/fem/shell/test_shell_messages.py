"""Wrong input is refused in one line that says what and where."""

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from tests.fem.shell.grids import over

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
        ({"points": GRID.points[:, :2]}, "points need three finite coordinates each"),
        ({"points": LOST}, "node 15 belongs to no cell"),
        ({"points": MOVED}, "cell 0 is folded or has no area"),
        ({"cells": GRID.cells[:, :8]}, r"cells need nine nodes each, got shape \(2, 8\)"),
        ({"cells": GRID.cells + 1}, "no node 15: the shell has nodes 0 to 14"),
        ({"thickness": 0.0}, "thickness must be positive, got 0"),
        ({"thickness": {"left": 0.1}}, "1 of 2 cells have no thickness"),
        ({"materials": {"middle": Elastic(E=1.0, nu=0.0)}}, "no body 'middle'; bodies: left, rig"),
        ({"materials": {"left": Elastic(E=1.0, nu=0.0)}}, "1 of 2 cells have no material"),
        ({"supports": {"top": "xyz"}}, "no boundary 'top'; boundaries: u=0, u=1, v=0, v=1"),
        ({"supports": {"u=0": "xyr"}}, "boundary 'u=0': components are x, y, z, a, b, c, got 'r'"),
        ({"supports": {99: "x"}}, "no node 99: the shell has nodes 0 to 14"),
        ({"supports": {"u=0": {"x": np.inf}}}, "'u=0': x must be held at a number, got inf"),
        (
            {"supports": {"u=0": "xyzabc", "v=0": {"x": 1.0}}},
            "'v=0': x is held at another value already",
        ),
        ({"supports": {}}, "the shell can move rigidly"),
        ({"supports": {"u=0": "xyz"}}, r"can move rigidly \(.*turn about y\): support it against"),
        (
            {"supports": {"u=0": "xyzabc", 14: {"x": 1.0}}, "ties": {"v=1": "x"}},
            r"node \d+: x is tied to one held at another value",
        ),
        ({"ties": {"u=2": "x"}}, "no boundary 'u=2'"),
        ({"edge_loads": {"u=1": (0, 1)}}, "'u=1': a load has three components"),
        ({"pressures": {"middle": 1.0}}, "no body 'middle'"),
        ({"loads": {3: (0, 0, 1)}}, "node 3: a load has three forces and three couples"),
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

"""Shells of flat leaves that branch, against frames."""

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from tests.fem.shell.grids import over

E, NU, T, L = 1e9, 0.3, 0.01, 1.0
EI = E / (1 - NU**2) * T**3 / 12
GA = 5 / 6 * E / (2 * (1 + NU)) * T
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


def plate(start, end, count=4):
    """From one line along z to another, both through points (x, y)."""
    (a, b), (c, d) = start, end
    return over(count, 1, lambda u, v: (a + (c - a) * u, b + (d - b) * u, DEPTH * v))


def solve(grids, clamped, loaded, force):
    points, cells, boundaries = joined(*grids)
    sides = {name: "zab" for name in boundaries if name.startswith("v=")}
    return solve_shell(
        points, cells, thickness=T, materials=Elastic(E=E, nu=NU), boundaries=boundaries,
        supports=sides | dict.fromkeys(clamped, "xyzabc"), edge_loads={loaded: (*force, 0)},
    )  # fmt: skip


def test_a_branch_shares_the_moment_out_between_its_partners():
    """Three leaves meet; two are clamped, the third is bent by a force across its end."""
    s = solve(
        [plate((-L, 0), (0, 0)), plate((0, 0), (L, 0)), plate((0, 0), (0, L))],
        ["u=0 of 0", "u=1 of 1"], "u=1 of 2", (1.0, 0),
    )  # fmt: skip
    # slope-deflection with shear: (4 + phi)/(1 + phi) EI/L of each clamped leaf
    phi = 12 * EI / (GA * L**2)
    turn = -L / (2 * (4 + phi) / (1 + phi) * EI / L)
    node = np.argmin(np.abs(s.points).sum(axis=1))
    assert s.rotation[node, 2] == pytest.approx(turn, rel=1e-9)
    for end in ("u=0 of 0", "u=1 of 1"):
        assert s.reaction(end)[0] == pytest.approx(-DEPTH / 2, rel=1e-9)

"""Strips with held edges against beams in plane strain, and leaves that branch."""

from math import pi

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from meshes.shell.panel import cylinder_panel
from tests.fem.shell.grids import over

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
    E, NU, T, L = 1e9, 0.3, 0.01, 1.0
    EI, GA = E / (1 - NU**2) * T**3 / 12, 5 / 6 * E / (2 * (1 + NU)) * T
    points, cells, boundaries = joined(
        leaf((-L, 0), (0, 0)), leaf((0, 0), (L, 0)), leaf((0, 0), (0, L))
    )
    sides = {name: "zab" for name in boundaries if name.startswith("v=")}
    s = solve_shell(
        points, cells, thickness=T, materials=Elastic(E=E, nu=NU), boundaries=boundaries,
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

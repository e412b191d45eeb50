"""Strips against beams: narrow ones in plane stress, those with held edges in plane strain."""

from math import pi

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.shell.solve import solve_shell
from meshes.shell.panel import cylinder_panel, rectangle

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


def test_an_endless_strip_bends_with_the_stiffness_of_a_plate():
    length, t = 1.0, 1e-2
    mesh = rectangle(length=length, width=0.3, along=8, across=1)
    moved = tip(mesh, t, (0, FORCE, 0), **EDGES_HELD)
    exact = FORCE * (length**3 / (3 * WIDE * t**3 / 12) + length / (SHEAR * G * t))
    assert moved[1] == pytest.approx(exact, rel=1e-9)
    assert moved[5] == pytest.approx(-FORCE * length**2 / (2 * WIDE * t**3 / 12), rel=1e-9)


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

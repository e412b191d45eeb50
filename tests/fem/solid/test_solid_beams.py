"""Straight strips against Timoshenko's beam, narrow and with held edges.

The stresses of a beam under a force at its end, bending linear and shear parabolic over the
thickness, act on both cut faces; with them its energy is that of Timoshenko & Goodier, art. 21.
"""

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.solid.solve import solve_solid
from meshes.solid.strip import solid_strip
from meshes.spring.path import Piece

E, NU, FORCE = 206e3, 0.3, 1.0


def beam(length, b, width):
    return Piece("leaf", 0.0, 0.0, 0.0, length, 0.0, 1), {"b": b, "width": width}


def compliance(length, b, width, *, held):
    """Of the strip's end, the head, along y."""
    piece, section = beam(length, b, width)
    mesh = solid_strip([piece], through=4, per_arc=1, per_leaf=12, across=1, **section)
    inertia = width * b**3 / 12

    def shear(x):
        return FORCE / (width * b) * 1.5 * (1 - (2 * x[1] / b) ** 2)

    def root(x):
        return np.array([-FORCE * length * x[1] / inertia, -shear(x), 0 * x[0]])

    solved = solve_solid(
        mesh, materials=Elastic(E=E, nu=NU),
        supports={
            (length, 0.0, None): "y", "middle": "z",
            (length, b / 2, 0.0): "x", (length, -b / 2, 0.0): "x",
        } | ({"edge": "z"} if held else {}),
        tractions={"head": lambda x: np.array([0 * x[0], shear(x), 0 * x[0]]), "tail": root},
    )  # fmt: skip
    return -2 * solved.potential_energy / FORCE**2


def timoshenko(length, b, width, modulus):
    inertia, G = width * b**3 / 12, E / (2 * (1 + NU))
    return length**3 / (3 * modulus * inertia) + 1.2 * length / (G * b * width)


@pytest.mark.parametrize("held", [False, True], ids=["narrow", "edges held"])
def test_a_strip_bends_and_shears_like_timoshenkos_beam(held):
    # plane stress but for (nu width / b)^2 = 2e-4, of which a part counts
    length, b, width = 3.0, 1.0, 0.05
    modulus = E / (1 - NU**2) if held else E
    found = compliance(length, b, width, held=held)
    assert found == pytest.approx(timoshenko(length, b, width, modulus), rel=1e-4)


def test_two_points_along_one_long_cell_do_not_lock():
    """A leaf with a guided head, its tail moved, of nu = 0: 12 E I / L^3 but for shear."""
    slender, b = 100.0, 1.0
    piece, section = beam(slender * b, b, 1.0)
    mesh = solid_strip([piece], through=1, per_arc=1, per_leaf=1, across=1, **section)
    solved = solve_solid(
        mesh, materials=Elastic(E=E, nu=0.0), points=(2, 3, 3),
        supports={
            "head": "x", "tail": "x", "middle": "z", (slender * b, 0.0, None): "y",
            (0.0, 0.0, None): {"y": 1.0},
        },
    )  # fmt: skip
    found = 2 * solved.strain_energy / (E / (slender * b) ** 3)  # I = 1/12
    # faces that stay plane hold back what shear does to the thickness there, by 0.5 (b/L)^3
    assert found == pytest.approx(1 / (1 + 2 / slender**2), rel=1e-6 + 0.5 / slender**3)

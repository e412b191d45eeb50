"""Straight strips against Timoshenko's beam, narrow and with held edges, and what long cells lock.

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
LONG = (2, 3, 3)  # Gauss points of cells that are long in their first direction


def beam(length, b, width):
    return Piece("leaf", 0.0, 0.0, 0.0, length, 0.0, 1), {"b": b, "width": width}


def compliance(length, b, width, *, nu=NU, held=False, points=None, through=2, **cells):
    """Of the strip's end, the head, along y."""
    piece, section = beam(length, b, width)
    mesh = solid_strip([piece], through=through, per_arc=1, **section, **{"across": 1} | cells)
    inertia = width * b**3 / 12

    def shear(x, force):
        return force / (width * b) * 1.5 * (1 - (2 * x[1] / b) ** 2)

    def root(x):
        return np.array([-FORCE * length * x[1] / inertia, -shear(x, FORCE), 0 * x[0]])

    supports = {(length, 0.0, None): "y", "middle": "z"} | ({"edge": "z"} if held else {})
    top = {(length, b / 2, 0.0): "x", (length, -b / 2, 0.0): "x"}
    solved = solve_solid(
        mesh,
        materials=Elastic(E=E, nu=nu),
        supports=supports | top,
        tractions={"head": lambda x: np.array([0 * x[0], shear(x, FORCE), 0 * x[0]]), "tail": root},
        points=points,
    )
    return -2 * solved.potential_energy / FORCE**2


def timoshenko(length, b, width, modulus):
    inertia, G = width * b**3 / 12, E / (2 * (1 + NU))
    return length**3 / (3 * modulus * inertia) + 1.2 * length / (G * b * width)


@pytest.mark.parametrize("held", [False, True], ids=["narrow", "edges held"])
def test_a_strip_bends_and_shears_like_timoshenkos_beam(held):
    length, b, width = (
        3.0,
        1.0,
        0.05,
    )  # plane stress but for (nu width / b)^2 = 2e-4, of which a part counts
    modulus = E / (1 - NU**2) if held else E
    found = compliance(length, b, width, held=held, through=4, per_leaf=12)
    assert found == pytest.approx(timoshenko(length, b, width, modulus), rel=1e-4)


def guided(cells, slender, points):
    """Stiffness of a leaf with a guided head, its tail held, over 12 E I / L^3; nu = 0."""
    b = 1.0
    piece, section = beam(slender * b, b, 1.0)
    mesh = solid_strip([piece], through=1, per_arc=1, per_leaf=cells, across=1, **section)
    solved = solve_solid(
        mesh,
        materials=Elastic(E=E, nu=0.0),
        supports={
            "head": "x", "tail": "x", "middle": "z", (slender * b, 0.0, None): "y",
            (0.0, 0.0, None): {"y": 1.0},
        },
        points=points,
    )  # fmt: skip
    return 2 * solved.strain_energy / (E / (slender * b) ** 3)  # I = 1/12


END = 0.5  # of (b/L)^3: faces that stay plane hold back what shear does to the thickness there


@pytest.mark.parametrize(("slender", "n"), [(10, 16), (1000, 4)])
def test_long_cells_lock_as_their_shear_has_it_at_most_by_the_square_of_their_number(slender, n):
    """A cell's rotation a (x^2 - l^2/12) bends with E I a^2 l^3/3, and shears with G A a^2 l^5/180.

    So a curvature that is linear in a cell, of which the compliance holds 1/n^2, counts as
    1 / (1 + s), s = (l/b)^2/10 for nu = 0: fully integrated, 8 long cells are 1.6 % too stiff. One
    cell through the strip has even shear, 2 (b/L)^2 of the compliance.
    """
    s = (slender / n) ** 2 / 10
    exact = 1 / (1 + 2 / slender**2 - s / (1 + s) / n**2)
    assert guided(n, slender, None) == pytest.approx(exact, rel=1e-6 + END / slender**3)


def test_two_points_along_long_cells_do_not_lock():
    slender = 100
    found = guided(1, slender, LONG)
    assert found == pytest.approx(1 / (1 + 2 / slender**2), rel=1e-6 + END / slender**3)

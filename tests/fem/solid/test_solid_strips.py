"""Wide strips: a barrel roof, the accordion's loops, and the limits of narrow and wide ones."""

from math import cos, radians, sin

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from fem.solid.solve import solve_solid
from meshes.solid.strip import solid_strip
from meshes.spring.path import Piece, accordion
from meshes.spring.strip import strip

E, NU, B, R = 206e3, 0.3, 0.1, 0.5  # the paper's spring [N/mm^2, mm]
LONG = (2, 3, 3)
SPRING = {"n": 3, "L1": 11.6, "radius": R, "alpha": radians(80)}


def shear(centre, width, force):
    """Traction along x of a force, parabolic over the thickness."""

    def traction(x):
        t = force / (B * width) * 1.5 * (1 - (2 * (x[0] - centre) / B) ** 2)
        return np.array([t, *[0 * t] * (len(x) - 1)])

    return traction


def stiffness(pieces, width, *, held=False, E=E, nu=NU, points=LONG, **cells):
    """Of half a strip of 2 `width`, its head guided and moved as one along x, its tail held."""
    (x, y), end = pieces[-1].end, {} if not held else {"edge": "z"}
    mesh = solid_strip(pieces, b=B, width=width, **{"through": 1} | cells)
    solved = solve_solid(
        mesh, materials=Elastic(E=E, nu=nu), points=points,
        supports={"middle": "z", "head": "y", "tail": "y", (x, y, None): "x"} | end,
        uniform={(0.0, 0.0, None): "x"},
        tractions={"head": shear(0.0, width, 1.0), "tail": shear(x, width, -1.0)},
    )  # fmt: skip
    return -1 / (2 * solved.potential_energy)


def test_a_slice_with_held_edges_is_the_plane_strip_in_plane_strain():
    tail = "arc"
    cells = {"through": 1, "per_arc": 4, "per_leaf": 5}
    pieces = list(accordion(**SPRING, tail=tail))
    solid = stiffness(pieces, 0.7, held=True, points=None, across=2, **cells)
    x, y = pieces[-1].end
    plane = solve_plane(
        strip(**SPRING, b=B, tail=tail, **cells), materials=Elastic(E=E, nu=NU),
        assumption="plane strain", supports={"head": "y", "tail": "y"}, anchors={(x, y): "x"},
        tractions={"head": shear(0.0, 0.7, 1.0), "tail": shear(x, 0.7, -1.0)}, thickness=0.7,
    )  # fmt: skip
    assert solid == pytest.approx(-1 / (2 * plane.potential_energy), rel=1e-7)


def test_a_barrel_roof_sags_as_scordelis_and_lo_have_it():
    """Midside sag 0.3024 of shallow theory (MacNeal & Harder 1985), 0.3006 of deep thin shells."""
    radius, half = 25.0, radians(40)
    roof = Piece("arc", 0.0, 0.0, 0.0, radius * half, -half, 1)
    sag = {}
    for cells, points in ((8, None), (8, LONG)):
        mesh = solid_strip(
            [roof], b=0.25, width=25.0, through=1, per_arc=cells, per_leaf=1, across=cells
        )
        solved = solve_solid(
            mesh, materials=Elastic(E=4.32e8, nu=0.0), body_force=(0.0, -90 / 0.25, 0.0),
            supports={"head": "x", "middle": "z", "edge": "xy"}, points=points,
        )  # fmt: skip
        at = (radius * sin(half), radius * (cos(half) - 1), 0.0)
        sag[cells, points] = -solved.displacement_at(at)[1]
    assert 0.3000 < sag[8, LONG] < 0.3024
    assert sag[8, None] < 0.99 * sag[8, LONG]  # four-thirds of a sixteenth: locked

"""Wide strips: a barrel roof, the accordion's loops, and the limits of narrow and wide ones."""

from math import cos, radians, sin

from fem.plane.material import Elastic
from fem.solid.solve import solve_solid
from meshes.solid.strip import solid_strip
from meshes.spring.path import Piece

LONG = (2, 3, 3)


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

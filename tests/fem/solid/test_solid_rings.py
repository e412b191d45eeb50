"""Curved solids: Lamé's cylinder, and a quarter of a curved bar under a force at its end (Golovin).

Timoshenko & Goodier, art. 28 and 33, in plane strain: the edges of the strip are held.
"""

from functools import cache
from math import pi

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.solid.solve import solve_solid
from meshes.solid.strip import solid_strip
from meshes.spring.path import Piece

E, NU, PRESSURE, FORCE = 100.0, 0.3, 2.0, 0.5
A, B, WIDTH = 1.0, 2.0, 0.5  # inner and outer radius
MIDDLE = (A + B) / 2
WIDE = E / (1 - NU**2)
STEEL = Elastic(E=E, nu=NU)
HELD = {"middle": "z", "edge": "z"}
SPREAD = 0.15  # of an order observed between 4 x 12 and 8 x 24 cells


def quarter(through, **changed):
    """From (0, 0) around the centre (MIDDLE, 0) to (MIDDLE, MIDDLE)."""
    piece = Piece("arc", 0.0, 0.0, pi / 2, MIDDLE * pi / 2, -pi / 2, 1)
    cells = {"through": through, "per_arc": 3 * through, "per_leaf": 1, "across": 1}
    return solid_strip([piece], b=B - A, width=WIDTH, **cells | changed)


@cache
def cylinder(through, **changed):
    return solve_solid(
        quarter(through, **changed), materials=STEEL, pressures={"right": PRESSURE},
        supports={"head": "y", "tail": "x"} | HELD,
    )  # fmt: skip


def bore_movement():
    """Of the bore under a pressure in it, plane strain."""
    nu = NU / (1 - NU)
    return PRESSURE * A / WIDE * ((A**2 + B**2) / (B**2 - A**2) + nu)


def energy_error(solved):
    work = PRESSURE * A * pi / 2 * WIDTH * bore_movement()
    return abs(-2 * solved.potential_energy / work - 1)


def test_a_cylinder_expands_as_lame_has_it():
    solved = cylinder(8)
    r = np.hypot(solved.mesh.doflocs[0] - MIDDLE, solved.mesh.doflocs[1])
    bore = solved.displacement[abs(r - A) < 1e-6]
    assert np.hypot(bore[:, 0], bore[:, 1]) == pytest.approx(bore_movement(), rel=1e-4)
    s = solved.stresses()
    radial = np.stack([s.x[:, 0] - MIDDLE, s.x[:, 1], 0 * s.x[:, 0]], axis=1)
    r = np.linalg.norm(radial, axis=1)
    across = np.einsum("mi,mij,mj->m", radial, s.stress, radial) / r**2
    scale = PRESSURE * A**2 / (B**2 - A**2)
    assert across == pytest.approx(scale * (1 - (B / r) ** 2), abs=0.02 * PRESSURE)
    assert s.stress[:, 2, 2] == pytest.approx(2 * NU * scale, abs=0.02 * PRESSURE)


@pytest.mark.parametrize(("straight", "order"), [(False, 4), (True, 2)])
def test_the_cylinders_energy_has_order_4_on_curved_cells_and_2_on_straight_ones(straight, order):
    error = [energy_error(cylinder(through, straight=straight)) for through in (4, 8)]
    assert np.log2(error[0] / error[1]) == pytest.approx(order, abs=SPREAD)

"""The direction of contact weighs both bodies by their moduli, and finds what Hertz is off by.

The excesses over Hertz are those of a solver of another kind (discs by Fourier modes, plane
stress); they are of first order in a/R here, as the materials couple both directions.
"""

import numpy as np
import pytest

from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import full_block
from meshes.contact.disc import half_disc
from meshes.join import join

R, MU = 1.0, 0.2
FINE = {"zone": 0.06, "refine": 1}
UP = np.array([[0.0], [1.0]])


def slid(normal, along=0.02):
    """A disc of E = 1 pressed on a block and slid until nothing sticks."""
    problem = ContactProblem(
        join({"disc": half_disc(R=R, **FINE), "block": full_block(width=R, depth=R, **FINE)}),
        materials=Elastic(E=1.0, nu=0.3),
        assumption="plane strain",
        supports={"block.bottom": "xy", "disc.middle": "xy"},
        contacts=[
            Pair(slave="disc.surface", master="block.surface", friction=MU, normal=normal,
                 slave_shape=Circle((0.0, R), R), master_shape=Flat())
        ],
    )  # fmt: skip
    pressed = problem.solve(displacements={"disc.middle": {"y": -0.004}})
    return problem.solve(displacements={"disc.middle": {"x": along, "y": -0.004}}, after=pressed)


def test_pressure_keeps_one_direction_along_a_flat_master_and_turns_between_two_bodies():
    touch = slid("master").touches[0]
    np.testing.assert_allclose(touch.mortar.points.n, -UP * np.ones(touch.p.size), atol=1e-14)
    x, y = touch.force
    assert x == pytest.approx(-MU * y, rel=1e-12)
    touch = slid("between").touches[0]
    # half of the disc's slope, both moduli being alike
    near = np.abs(touch.mortar.points.x[0]) < 0.1 * R
    n = touch.mortar.points.n[:, near]
    expected = touch.mortar.points.x[0, near] / (2 * R)
    np.testing.assert_allclose(n[0] / -n[1], expected, rtol=0.01, atol=1e-6)
    x, y = touch.force
    assert abs(x / (MU * y) + 1) > 1e-4  # the contact has moved to where the surface is inclined
    with pytest.raises(ValueError, match="'between' or that of the 'master', got 'slave'"):
        Pair(slave="a", master="b", normal="slave")

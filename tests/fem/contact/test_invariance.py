"""What must not change a contact's answer: its place, its units, its start."""

from dataclasses import replace

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import full_block
from meshes.contact.disc import half_disc
from meshes.join import join
from meshes.polyhedral.half_sector import half_sector

R, E, NU = 10e-3, 210e9, 0.3  # m, Pa
A = 0.02 * R  # about the half-width of the contact
DOWN, ALONG = 2e-6, 0.3e-6  # m; presses the disc into the block, then pushes it along
SOLVED = 1e-8  # relative; the solver's part


def turn(angle, v):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s], [s, c]]) @ v


def rolling(angle=0.0, shift=(0.0, 0.0), scale=1.0, stress=1.0, thickness=1.0):
    """A disc pressed and pushed along a block, with `scale` units a metre, `stress` a pascal."""
    mesh = join({
        "disc": half_disc(R=R * scale, zone=1.4 * A * scale, refine=1),
        "block": full_block(
            width=R * scale, depth=R * scale, zone=1.5 * A * scale, refine=1, cells=7
        ),
    })  # fmt: skip
    mesh = replace(mesh, doflocs=turn(angle, mesh.doflocs) + np.reshape(shift, (2, 1)))
    disc = Circle(tuple(turn(angle, (0.0, R * scale)) + shift), R * scale)
    flat = Flat(tuple(shift), tuple(turn(angle, (0.0, 1.0))))
    problem = ContactProblem(
        mesh, assumption="plane strain", thickness=thickness,
        materials={"disc": Elastic(E=E * stress, nu=NU),
                   "block": Elastic(E=E * stress / 2, nu=0.2)},
        supports={"block.bottom": "xy", "disc.middle": "xy"},
        contacts=[Pair(slave="disc.surface", master="block.surface", friction=0.25,
                       slave_shape=disc, master_shape=flat)],
    )  # fmt: skip
    s = None
    for along in (0.0, ALONG):
        x, y = turn(angle, (along * scale, -DOWN * scale))
        s = problem.solve(displacements={"disc.middle": {"x": x, "y": y}}, after=s)
    return s


def test_place_units_and_thickness_change_nothing():
    # in millimetres and megapascals, turned and shifted, 0.04 of the thickness
    angle = 2.5
    upright = rolling()
    s = rolling(angle=angle, shift=(13.0, -20.0), scale=1e3, stress=1e-6, thickness=0.04)
    one, other = upright.touches[0], s.touches[0]
    assert 2 < np.count_nonzero(one.sticks) < np.count_nonzero(one.closed) - 2
    np.testing.assert_allclose(other.force, 0.04e-3 * turn(angle, one.force), rtol=SOLVED)
    np.testing.assert_allclose(other.pressure, 1e-6 * one.pressure, atol=SOLVED * 1e-6 * one.peak)
    np.testing.assert_allclose(other.traction, 1e-6 * one.traction, atol=SOLVED * 1e-6 * one.peak)
    np.testing.assert_allclose(other.gap, 1e3 * one.gap, atol=SOLVED * 1e3 * abs(one.gap).max())
    np.testing.assert_array_equal(other.sticks, one.sticks)
    assert other.half_width() == pytest.approx(1e3 * one.half_width(), rel=SOLVED)
    assert s.strain_energy == pytest.approx(0.04 * upright.strain_energy, rel=SOLVED)


R_E, ROLLER, THICKNESS = 0.04, 0.005, 0.03  # [m]
CLEARANCE = 3e-5  # [m] one side's, which the ring takes up at 20 MPa of 30


def pressed(start, interference):
    """Force [N] between the half sector of a ring under pressure and a roller at `start`."""
    mesh = half_sector(z=6, d_e=2 * R_E, d_i=0.072, fillet=0.002, zone=4e-4, refine=2)
    problem = ContactProblem(
        mesh, materials=Elastic(E=210e9, nu=0.3), assumption="plane stress",
        supports={"mid": "n", "corner": "n"}, thickness=THICKNESS,
        obstacles={"roller": Obstacle(Circle((R_E + start + ROLLER, 0.0), ROLLER))},
        contacts=[Pair(slave="zone", master="roller", slave_shape=Circle((0.0, 0.0), R_E),
                       interference=interference)],
    )  # fmt: skip
    return problem.solve(pressures={"bore": 30e6}).touches[0].force[0]


def test_a_half_ring_that_grows_into_touch_carries_what_one_with_its_gaps_widened_carries():
    # the flattening half of a contact turns; a centre 0.04 m away that moved along its tangent
    # would lift the surface off by 4 % of the clearance, and take 8 % of the force
    assert pressed(CLEARANCE, 0.0) == pytest.approx(pressed(0.0, -CLEARANCE), rel=3e-4)

"""Half of a symmetric body that comes from afar touches as one that starts in touch."""

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Motion
from fem.plane.material import Elastic
from meshes.polyhedral.half_sector import half_sector

R_E, ROLLER, THICKNESS = 0.04, 0.005, 0.03  # [m]
CLEARANCE = 3e-5  # [m] one side's, which the ring takes up at 20 MPa of 30


def test_a_circle_that_turns_about_one_of_its_points_still_goes_through_it():
    about = (0.3 + 40 * np.cos(0.2), 40 * np.sin(0.2))
    motion = Motion((0.5, -0.25), 0.1, about)
    moved = Circle((0.3, 0.0), 40.0, hollow=True).moved(motion)
    assert np.hypot(*np.subtract(motion.of(about), moved.centre)) == pytest.approx(40, rel=1e-14)


@pytest.mark.parametrize("angle", [1e-12, -2.0])
def test_a_rigid_motion_is_found_from_what_it_does_to_points(angle):
    x = np.random.default_rng(6).normal(size=(2, 7))
    motion = Motion((0.1, -0.2), angle, tuple(x.mean(axis=1)))
    assert Motion.fitted(x, motion.displacement(x)).angle == pytest.approx(angle, abs=1e-15)


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

"""Contact is found in a few exchanges on any mesh, and from any start."""

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.disc import half_disc, quarter_disc

R, STEEL = 10e-3, Elastic(E=210e9, nu=0.3)
LOAD = np.pi * 210e9 / 0.91 * (1e-4) ** 2 / (4 * R) / 2  # half of what makes a = R/100


def disc(refine):
    return ContactProblem(
        quarter_disc(R=R, zone=0.15e-3, refine=refine), materials=STEEL,
        assumption="plane strain", supports={"axis": "x"}, obstacles={"flat": Obstacle(Flat())},
        contacts=[Pair(slave="surface", master="flat", slave_shape=Circle((0, R), R))],
    )  # fmt: skip


@pytest.mark.parametrize("refine", [1, 6])
def test_exchanges_do_not_grow_with_the_mesh(refine):
    step = disc(refine).solve(forces={"middle": (0, -LOAD)})
    assert np.count_nonzero(step.changes) <= 4
    assert step.touches[0].normal_force == pytest.approx(LOAD, rel=1e-9)


def test_friction_that_makes_the_exchanges_circle_is_solved_all_the_same():
    # pressed against a rigid flat, a disc's surface creeps inwards: slip outside, stick inside
    disc = ContactProblem(
        half_disc(R=R, zone=0.28e-3, refine=2), materials=STEEL, assumption="plane strain",
        supports={"middle": "xy"}, obstacles={"flat": Obstacle(Flat(), free="xy")},
        contacts=[
            Pair(slave="surface", master="flat", slave_shape=Circle((0, R), R), friction=0.5)
        ],
    )  # fmt: skip
    step = disc.solve(forces={"flat": (0, 1e6)})
    touch = step.touches[0]
    assert len(step.changes) < 200
    assert touch.force == pytest.approx((0, -1e6), abs=1e-2)
    assert touch.sticks.any()
    assert (touch.closed & ~touch.sticks).any()
    assert touch.friction_force == pytest.approx(0, abs=1e-2)  # left and right pull alike

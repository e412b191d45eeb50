"""Contact is found in a few exchanges on any mesh, and from any start."""

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.contact.system import OPEN, STICK
from fem.plane.material import Elastic
from meshes.contact.disc import quarter_disc

R, STEEL = 10e-3, Elastic(E=210e9, nu=0.3)
LOAD = np.pi * 210e9 / 0.91 * (1e-4) ** 2 / (4 * R) / 2  # half of what makes a = R/100


def disc(refine):
    return ContactProblem(
        quarter_disc(R=R, zone=0.15e-3, refine=refine), materials=STEEL,
        assumption="plane strain", supports={"axis": "x"}, obstacles={"flat": Obstacle(Flat())},
        contacts=[Pair(slave="surface", master="flat", slave_shape=Circle((0, R), R))],
    )  # fmt: skip


@pytest.mark.parametrize("refine", [1, 2, 4, 6])
def test_exchanges_do_not_grow_with_the_mesh(refine):
    step = disc(refine).solve(forces={"middle": (0, -LOAD)})
    assert np.count_nonzero(step.changes) <= 4
    assert step.touches[0].normal_force == pytest.approx(LOAD, rel=1e-9)


@pytest.mark.parametrize("share", [0.01, 100.0])
def test_a_step_finds_its_contact_from_that_of_any_other(share):
    problem = disc(3)
    far = problem.solve(forces={"middle": (0, -share * LOAD)})
    near = problem.solve(forces={"middle": (0, -LOAD)})
    again = problem.solve(forces={"middle": (0, -LOAD)}, after=far)
    assert again.touches[0].pressure == pytest.approx(near.touches[0].pressure, rel=1e-9)


@pytest.mark.parametrize("seed", range(5))
def test_the_kernel_finds_the_same_contact_from_random_states(seed):
    problem = disc(2)
    near = problem.solve(forces={"middle": (0, -LOAD)})
    kernel = problem.interface.kernel
    # the system that this step solved, taken back from its solution
    w_0 = near.w - kernel.B @ near.rest.multipliers - kernel.D @ near.rest.motion
    e = -kernel.D.T @ near.rest.multipliers
    start = np.random.default_rng(seed).choice([OPEN, STICK], near.states.size).astype(np.int8)
    found = kernel.solve(w_0, e, start)
    assert found.multipliers == pytest.approx(
        near.rest.multipliers, rel=1e-8, abs=1e-8 * near.touches[0].peak
    )

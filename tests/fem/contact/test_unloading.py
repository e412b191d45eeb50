"""Bodies that were pressed and dragged, and are then unloaded: friction leaves displacements."""

import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Flat
from fem.plane.material import Elastic
from meshes.contact.block import block


def on_floor():
    return ContactProblem(
        block(x=(-1, 1), y=(0, 1), nx=8, ny=4), materials=Elastic(E=100.0, nu=0.3),
        assumption="plane strain", obstacles={"floor": Obstacle(Flat())},
        contacts=[Pair(slave="bottom", master="floor", friction=0.3)],
    )  # fmt: skip


def test_a_free_block_that_friction_holds_aside_stays_there_as_its_load_falls():
    problem = on_floor()
    at = problem.solve(forces={"top": (0.0, -1.0)})
    at = problem.solve(forces={"top": (0.0, -1.0), "bottom": (0.27, 0.0)}, after=at)
    for load in (1.0, 1e-3):
        at = problem.solve(forces={"top": (0.0, -load)}, after=at)
        assert at.touches[0].force == pytest.approx((0.0, -load), abs=1e-8 * load)

"""Bodies that nothing but contact holds, that start apart, and exchanges that find their rest."""

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block, full_block
from meshes.contact.disc import half_disc
from meshes.contact.round import full_disc
from tests.fem.contact.models import STEEL, on_flat

R, LOAD = 10e-3, 1e5
EXACT = 1e-8


def in_groove(friction):
    n = {"left": (1.0, 1.0), "right": (-1.0, 1.0)}
    foot = R / np.sqrt(2)
    return ContactProblem(
        full_disc(R=R, around=32), materials=STEEL, assumption="plane strain",
        anchors={} if friction else {(0.0, R): "x"},  # against turning
        obstacles={k: Obstacle(Flat((-foot * v[0], -foot), v)) for k, v in n.items()},
        contacts=[Pair(slave="rim", master=k, slave_shape=Circle((0, 0), R), friction=friction)
                  for k in n],
    ).solve(body_forces=(0.0, -LOAD / (np.pi * R**2)))  # fmt: skip


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_a_disc_slips_down_a_groove_as_far_as_friction_lets_it(friction):
    # weight = 2 (N cos 45 deg + mu N sin 45 deg); it is that of the disc made of parabolas
    for touch in in_groove(friction).touches:
        assert touch.normal_force == pytest.approx(LOAD / np.sqrt(2) / (1 + friction), rel=1e-5)
        assert abs(touch.friction_force) == pytest.approx(friction * touch.normal_force, rel=1e-6)


def on_floor(**problem):
    """A block that friction holds on a rigid floor."""
    given = {
        "friction": 0.3,
        "x": (-1, 1),
        "y": (0, 1),
        "nx": 8,
        "ny": 4,
        "floor": Flat(),
    } | problem
    friction, floor = given.pop("friction"), given.pop("floor")
    cells = {key: given.pop(key) for key in ("x", "y", "nx", "ny")}
    return ContactProblem(
        block(**cells), **{"materials": Elastic(E=100.0, nu=0.3), "assumption": "plane strain"}
        | given, obstacles={"floor": Obstacle(floor)},
        contacts=[Pair(slave="bottom", master="floor", friction=friction)],
    )  # fmt: skip


def test_a_block_on_a_rough_floor_holds_up_to_its_friction():
    problem = on_floor()
    down = problem.solve(forces={"top": (0.0, -1.0)})

    def pushed(share):
        load = {"top": (0.0, -1.0), "right": (0.3 * share, 0.0)}
        return problem.solve(forces=load, after=down).touches[0]

    np.testing.assert_allclose(pushed(0.999).force, (0.3 * 0.999, -1.0), atol=EXACT)
    assert np.any(pushed(0.999).sticks)
    with pytest.raises(ValueError, match="loads do move it"):
        pushed(1.001)


def test_what_slides_before_it_touches_costs_nothing():
    # a column of E = 1 is driven down through a gap and aside at once: in the first half it does
    # not touch, from there on it sticks, and bends and shears by half of the whole shift
    def column(gap, aside, steps):
        touch = on_floor(
            x=(0, 1), y=(0, 4), nx=4, ny=16, friction=5.0, floor=Flat((0, -gap)),
            materials=Elastic(E=1.0, nu=0.0), supports={"top": "xy"},
        ).solve(
            displacements={"top": {"x": aside, "y": -gap - 1e-4}}, steps=steps
        ).touches[0]  # fmt: skip
        return touch.normal_force, touch.friction_force

    N, T = column(1e-4, 1e-4, 1)
    assert pytest.approx(1e-4 / 4, rel=1e-9) == N  # E times the strain of the second half
    assert pytest.approx((N, T), rel=1e-6) == column(1e-4, 1e-4, 20)
    _, already_down = column(0.0, 0.5e-4, 20)
    assert pytest.approx(already_down, rel=1e-6) == T


def punch(start=0.0, zone=1.2, friction=0.0, free=""):
    """A round punch of radius 5 over a block, from `start` above it."""
    return ContactProblem(
        full_block(width=10.0, depth=10.0, zone=zone, refine=1), materials=Elastic(E=1e3, nu=0.3),
        assumption="plane strain", supports={"bottom": "xy"},
        obstacles={"punch": Obstacle(Circle((0.0, 5.0 + start), 5.0), free=free)},
        contacts=[Pair(slave="surface", master="punch", friction=friction)],
    )  # fmt: skip


def test_an_obstacle_keeps_its_own_curvature_from_wherever_it_comes():
    near, far = (punch(s, free="y").solve(forces={"punch": (0, -100.0)}) for s in (0.0, 15.0))
    one, other = near.touches[0], far.touches[0]
    assert other.peak == pytest.approx(one.peak, rel=1e-3)
    assert other.half_width() == pytest.approx(one.half_width(), rel=1e-3)
    assert far.motion("punch")[1] + 15 == pytest.approx(near.motion("punch")[1], rel=1e-3)


def test_friction_that_makes_the_exchanges_circle_is_solved_all_the_same():
    # pressed against a rigid flat, a disc's surface creeps inwards: slip outside, stick inside
    disc = half_disc(R=R, zone=0.28e-3, refine=2)
    flat = {"flat": Obstacle(Flat(), free="xy")}
    step = on_flat(disc, friction=0.5, supports={"middle": "xy"}, obstacles=flat).solve(
        forces={"flat": (0, 1e6)}
    )
    touch = step.touches[0]
    assert len(step.changes) < 200
    assert touch.force == pytest.approx((0, -1e6), abs=1e-2)
    assert touch.sticks.any()
    assert (touch.closed & ~touch.sticks).any()
    assert touch.friction_force == pytest.approx(0, abs=1e-2)  # left and right pull alike

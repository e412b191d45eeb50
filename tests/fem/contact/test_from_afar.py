"""Where bodies start, their steps and what spins freely do not change the contact."""

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block, full_block
from meshes.contact.disc import half_disc
from meshes.contact.round import full_disc, full_ring
from meshes.join import join

SOFT = Elastic(E=1e3, nu=0.3)


def punched(start):
    """A round punch that a force drives into a block from `start` above it."""
    punch = Obstacle(Circle((0.0, 5.0 + start), 5.0), free="y")
    problem = ContactProblem(
        full_block(width=10.0, depth=10.0, zone=1.2, refine=1), materials=SOFT,
        assumption="plane strain", supports={"bottom": "xy"}, obstacles={"punch": punch},
        contacts=[Pair(slave="surface", master="punch")],
    )  # fmt: skip
    return problem.solve(forces={"punch": (0, -100.0)}).touches[0]


@pytest.mark.parametrize("start", [0.5, 5.0, 15.0])
def test_an_obstacle_keeps_its_own_curvature_from_wherever_it_comes(start):
    near, far = punched(0.0), punched(start)
    assert far.peak == pytest.approx(near.peak, rel=1e-3)
    assert far.half_width() == pytest.approx(near.half_width(), rel=1e-3)


def dropped(gap):
    """A hard half disc that falls on a rough block."""
    R = 5.0
    mesh = join({
        "disc": half_disc(R=R, zone=0.9, refine=1, cells=5).translated((0.0, gap)),
        "block": full_block(width=10.0, depth=10.0, zone=0.9, refine=1),
    })  # fmt: skip
    problem = ContactProblem(
        mesh, materials={"disc": Elastic(E=1e6, nu=0.3), "block": SOFT},
        assumption="plane strain", supports={"block.bottom": "xy"},
        contacts=[Pair(slave="disc.surface", master="block.surface", friction=0.3)],
    )  # fmt: skip
    return problem.solve(body_forces={"disc": (0.0, -100 / (np.pi * R**2 / 2))}).touches[0]


def test_a_fall_through_a_gap_is_no_slip():
    touched, fell = dropped(0.0), dropped(2.0)
    assert fell.peak == pytest.approx(touched.peak, rel=5e-3)
    right = fell.closed & (fell.x[0] > 0.3)
    # the block's surface creeps inwards under the disc and drags at it: outwards on the block
    assert np.all(np.sign(fell.traction[right]) == np.sign(touched.traction[right]))
    assert np.abs(fell.slip[fell.closed]).max() < 0.02


def column(steps):
    """A column that is driven down through a gap and aside at once; T of it as it should be.

    Half of the way it does not touch. From there on it sticks: it bends and shears by half of
    the whole shift.
    """
    gap = 1e-4
    problem = ContactProblem(
        block(x=(0, 1), y=(0, 4), nx=4, ny=16), materials=Elastic(E=1.0, nu=0.0),
        assumption="plane strain", supports={"top": "xy"},
        obstacles={"floor": Obstacle(Flat((0, -gap)))},
        contacts=[Pair(slave="bottom", master="floor", friction=5.0)],
    )  # fmt: skip
    touch = problem.solve(displacements={"top": {"x": gap, "y": -2 * gap}}, steps=steps).touches[0]
    return touch.normal_force, touch.friction_force


def test_what_slides_before_it_touches_costs_nothing():
    N, T = column(1)
    many = column(20)
    assert pytest.approx(1e-4 / 4, rel=1e-9) == N  # E times the strain of what is left of the way
    assert pytest.approx((N, T), rel=1e-6) == many
    both = ContactProblem(  # the same column, already down, and aside by the second half alone
        block(x=(0, 1), y=(0, 4), nx=4, ny=16), materials=Elastic(E=1.0, nu=0.0),
        assumption="plane strain", supports={"top": "xy"}, obstacles={"floor": Obstacle(Flat())},
        contacts=[Pair(slave="bottom", master="floor", friction=5.0)],
    ).solve(displacements={"top": {"x": 0.5e-4, "y": -1e-4}}, steps=20)  # fmt: skip
    assert pytest.approx(both.touches[0].friction_force, rel=1e-6) == T


def test_steps_of_one_call_are_those_of_many():
    problem = ContactProblem(
        half_disc(R=5.0, zone=0.4, refine=1), materials=SOFT, assumption="plane strain",
        supports={"middle": "xy"}, obstacles={"flat": Obstacle(Flat())},
        contacts=[Pair(slave="surface", master="flat", friction=0.2)],
    )  # fmt: skip
    step = None
    for share in (0.25, 0.5, 0.75, 1.0):
        down = {"middle": {"x": 0.0, "y": -0.01 * share}}
        step = problem.solve(displacements=down, after=step)
    at_once = problem.solve(displacements={"middle": {"x": 0, "y": -0.01}}, steps=4)
    assert at_once.touches[0].traction == pytest.approx(
        step.touches[0].traction, abs=1e-9 * step.touches[0].peak
    )
    with pytest.raises(ValueError, match="steps must be 1 or more, got 0"):
        problem.solve(steps=0)


def fitted(friction, torque, *, shapes=False, after=None):
    """A disc pressed into a ring, and turned."""
    mesh = join({"disc": full_disc(R=1.0, around=32),
                 "ring": full_ring(r_i=1.0, r_o=1.6, around=40, across=2)})  # fmt: skip
    circle = Circle((0.0, 0.0), 1.0)
    pair = Pair(
        slave="disc.rim", master="ring.bore", friction=friction, interference=1e-3,
        slave_shape=circle if shapes else None,
        master_shape=Circle((0.0, 0.0), 1.0, hollow=True) if shapes else None,
    )  # fmt: skip
    problem = ContactProblem(
        mesh, materials=SOFT, assumption="plane strain", supports={"ring.rim": "xy"},
        contacts=[pair],
    )  # fmt: skip
    step = problem.solve()
    if not torque:
        return step.touches[0]
    turning = {"disc": lambda x: torque * 2 / np.pi * np.array([-x[1], x[0]])}
    return problem.solve(body_forces=turning, after=step).touches[0]


@pytest.mark.parametrize("shapes", [False, True])
def test_a_smooth_disc_may_spin_in_its_ring_as_long_as_nothing_turns_it(shapes):
    touch = fitted(0.0, 0.0, shapes=shapes)
    assert touch.pressure.mean() > 0
    assert abs(touch.moment()) < 1e-6 * touch.normal_force
    with pytest.raises(ValueError, match=r"rotation.* and the loads do move it"):
        fitted(0.0, 0.1 * touch.normal_force, shapes=shapes)


def test_a_fit_holds_up_to_its_torque_and_slips_round_beyond():
    capacity = 0.2 * fitted(0.2, 0.0).normal_force
    assert fitted(0.2, 0.98 * capacity).moment() == pytest.approx(0.98 * capacity, rel=1e-4)
    with pytest.raises(ArithmeticError, match=r"within small motions|slide or roll away"):
        fitted(0.2, 1.1 * capacity)


@pytest.mark.parametrize("angle", [0.0, 1e-4])
def test_an_obstacle_turns_about_its_point(angle):
    # a floor that turns about (0, 0) by a small angle presses the block's right half
    problem = ContactProblem(
        block(x=(-1, 1), y=(0, 1), nx=8, ny=4), materials=SOFT, assumption="plane strain",
        supports={"top": "xy"}, obstacles={"floor": Obstacle(Flat())},
        contacts=[Pair(slave="bottom", master="floor")],
    )  # fmt: skip
    touch = problem.solve(displacements={"floor": {"r": angle}}).touches[0]
    assert np.all(touch.x[0, touch.closed & (touch.pressure > 0)] > -0.3)
    assert (touch.moment() < 0) == (angle > 0)
    if angle:
        assert touch.x[0] @ touch.pressure > 0


def test_a_round_punch_that_turns_drags_as_one_that_is_shifted():
    R, down, aside = 5.0, -0.05, 2e-3
    punch = ContactProblem(
        full_block(width=10.0, depth=10.0, zone=1.0, refine=1), materials=SOFT,
        assumption="plane strain", supports={"bottom": "xy"},
        obstacles={"punch": Obstacle(Circle((0.0, R), R))},
        contacts=[Pair(slave="surface", master="punch", friction=0.9)],
    )  # fmt: skip
    pressed = punch.solve(displacements={"punch": {"y": down}})
    drags = [
        punch.solve(displacements={"punch": {"y": down, **way}}, after=pressed).touches[0]
        for way in ({"r": aside / R}, {"x": aside})
    ]
    # the point of contact is R below the centre: turning to the left moves it to the right, and
    # the block with it, which pulls the punch back
    turned, shifted = (touch.friction_force for touch in drags)
    assert abs(turned) > 0.3
    assert turned == pytest.approx(shifted, rel=0.02)  # (a/R)^2, by which the contact is curved

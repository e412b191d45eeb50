"""Where bodies start, their steps and what spins freely do not change the contact."""

import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block, full_block

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


def test_an_obstacle_keeps_its_own_curvature_from_wherever_it_comes():
    near, far = punched(0.0), punched(15.0)
    assert far.peak == pytest.approx(near.peak, rel=1e-3)
    assert far.half_width() == pytest.approx(near.half_width(), rel=1e-3)


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

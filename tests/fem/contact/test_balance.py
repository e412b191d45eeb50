"""Loads, supports and contact forces balance; work and energy do."""

import numpy as np
import pytest

from fem.contact.errors import NotFoundError
from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.contact.round import full_ring
from meshes.join import join

EXACT = 1e-8  # of the load
SOFT, HARD = Elastic(E=1.0, nu=0.3), Elastic(E=4.0, nu=0.2)


def tower(cells="quad", order=2, thickness=1.0, friction=0.5):
    """A narrow block on a wide one on a rigid floor, held by friction alone."""
    make = {"cells": cells, "order": order}
    mesh = join({
        "up": block(x=(0.2, 0.7), y=(0.5, 1.0), nx=6, ny=5, **make),
        "low": block(x=(0, 1), y=(0, 0.5), nx=11, ny=5, **make),
    })  # fmt: skip
    return ContactProblem(
        mesh, materials={"up": SOFT, "low": HARD}, assumption="plane stress", thickness=thickness,
        obstacles={"floor": Obstacle(Flat())},
        contacts=[Pair(slave="up.bottom", master="low.top", friction=friction),
                  Pair(slave="low.bottom", master="floor", friction=friction)],
    )  # fmt: skip


@pytest.mark.parametrize(("cells", "order"), [("quad", 2), ("tri", 1)])
def test_what_is_loaded_above_arrives_below(cells, order):
    load = np.array([1e-3, -8e-3])
    s = tower(cells, order, thickness=0.3).solve(
        forces={"up.top": tuple(load)}, body_forces={"low": (0.0, -0.02)}
    )
    upper, lower = s.touches
    weight = np.array([0.0, -0.02 * 0.5 * 0.3])
    np.testing.assert_allclose(upper.force, load, atol=EXACT * 8e-3)
    np.testing.assert_allclose(lower.force, load + weight, atol=EXACT * 8e-3)
    # moments about the origin: of the load at (0.45, 1), and the weight at (0.5, 0.25)
    moment = 0.45 * load[1] - 1.0 * load[0]
    assert upper.moment() == pytest.approx(moment, abs=EXACT * 8e-3)
    assert upper.moment(on="slave") == pytest.approx(-moment, abs=EXACT * 8e-3)
    assert lower.moment() == pytest.approx(moment + 0.5 * weight[1], abs=EXACT * 8e-3)
    assert s.plane.residual < 1e-10


def test_friction_stays_within_its_bound_and_sticking_points_do_not_slip():
    problem = tower(friction=0.2)
    s = problem.solve(forces={"up.top": (0.0, -8e-3)})
    s = problem.solve(forces={"up.top": (1.4e-3, -8e-3)}, after=s)
    for touch in s.touches:
        assert np.all(touch.pressure >= 0)
        assert np.all(np.abs(touch.traction) <= 0.2 * touch.pressure * (1 + 1e-9))
        assert np.abs(touch.slip[touch.sticks]).max(initial=0) < 1e-10 * np.abs(touch.slip).max()
        assert np.abs(touch.gap[touch.closed]).max() < 1e-10
        slides = touch.closed & ~touch.sticks & (np.abs(touch.slip) > 1e-12)
        assert np.any(slides)
        assert np.all(touch.traction[slides] * touch.slip[slides] < 0)  # drag, never drive


def rings(share, *, swap=False):
    """A ring turned on another that holds it by a press fit, by `share` of what makes it slide."""
    r, fit, mu = 0.04, 1e-5, 0.2
    mesh = join({"in": full_ring(r_i=0.02, r_o=r, around=32, across=4),
                 "out": full_ring(r_i=r, r_o=0.07, around=24, across=5)})  # fmt: skip
    sides = {"in.rim": Circle((0, 0), r), "out.bore": Circle((0, 0), r, hollow=True)}
    slave, master = list(sides)[::-1] if swap else list(sides)
    problem = ContactProblem(
        mesh, materials=Elastic(E=210e9, nu=0.3), assumption="plane strain",
        supports={"in.bore": "xy"},
        contacts=[Pair(slave=slave, master=master, friction=mu, interference=fit,
                       slave_shape=sides[slave], master_shape=sides[master])],
    )  # fmt: skip
    pressed = problem.solve()
    moment = share * mu * r * pressed.touches[0].normal_force

    def around(x):
        return moment / (2 * np.pi * 0.07**2) * np.array([-x[1], x[0]]) / np.hypot(*x)

    return problem.solve(tractions={"out.rim": around}, after=pressed), moment


@pytest.mark.parametrize("swap", [False, True], ids=["", "swapped"])
def test_a_ring_hands_its_torque_to_the_ring_that_it_is_pressed_on(swap):
    # the load itself acts on parabolas, 1e-5 of the moment off the circle
    s, moment = rings(0.9, swap=swap)
    touch, sign = s.touches[0], 1 if swap else -1
    assert s.plane.reaction("in.bore")[2] == pytest.approx(-moment, rel=2e-5)
    assert sign * touch.moment() == pytest.approx(moment, rel=2e-5)
    assert sign * touch.moment(on="slave") == pytest.approx(-moment, rel=2e-5)
    np.testing.assert_allclose(touch.force, 0.0, atol=EXACT * touch.normal_force)


def test_a_press_fit_turns_at_its_friction_and_not_before():
    s, _ = rings(0.999)
    assert np.any(s.touches[0].sticks)
    with pytest.raises(NotFoundError, match="no state of rest was found"):
        rings(1.001)

"""Bodies supported by contact only, bodies with an initial gap, and the search for equilibrium."""

import numpy as np
import pytest

from fem.contact.pairs import Obstacle, Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle, Flat
from fem.plane.material import Elastic
from meshes.contact.block import block, full_block
from meshes.contact.disc import half_disc
from meshes.contact.round import full_disc
from meshes.join import join
from tests.fem.contact.models import STEEL, on_flat

R, LOAD = 10e-3, 1e5


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
def test_a_disc_slips_down_a_groove_to_the_friction_limit(friction):
    # weight = 2 (N cos 45 deg + mu N sin 45 deg); it is that of the disc made of parabolas
    for touch in in_groove(friction).touches:
        assert touch.normal_force == pytest.approx(LOAD / np.sqrt(2) / (1 + friction), rel=1e-5)
        assert abs(touch.friction_force) == pytest.approx(friction * touch.normal_force, rel=1e-6)


def test_what_slides_before_it_touches_costs_nothing():
    # a column of E = 1 is driven down through a gap and aside at once: in the first half it does
    # not touch, from there on it sticks, and bends and shears by half of the whole shift
    def column(gap, aside, steps):
        problem = ContactProblem(
            block(x=(0, 1), y=(0, 4), nx=4, ny=16), materials=Elastic(E=1.0, nu=0.0),
            assumption="plane strain", supports={"top": "xy"},
            obstacles={"floor": Obstacle(Flat((0, -gap)))},
            contacts=[Pair(slave="bottom", master="floor", friction=5.0)],
        )  # fmt: skip
        moved = {"top": {"x": aside, "y": -gap - 1e-4}}
        touch = problem.solve(displacements=moved, steps=steps).touches[0]
        return touch.normal_force, touch.friction_force

    N, T = column(1e-4, 1e-4, 1)
    assert pytest.approx(1e-4 / 4, rel=1e-9) == N  # E times the strain of the second half
    assert pytest.approx((N, T), rel=1e-6) == column(1e-4, 1e-4, 20)
    _, already_down = column(0.0, 0.5e-4, 20)
    assert pytest.approx(already_down, rel=1e-6) == T


def test_an_obstacle_has_its_curvature_on_either_side():
    near, far = (
        ContactProblem(
            full_block(width=10.0, depth=10.0, zone=1.2, refine=1),
            materials=Elastic(E=1e3, nu=0.3), assumption="plane strain", supports={"bottom": "xy"},
            obstacles={"punch": Obstacle(Circle((0.0, 5.0 + start), 5.0), free="y")},
            contacts=[Pair(slave="surface", master="punch")],
        ).solve(forces={"punch": (0, -100.0)})
        for start in (0.0, 15.0)
    )  # fmt: skip
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
    assert touch.friction_force == pytest.approx(0, abs=1e-2)  # left and right pull equally


RADIUS, MU = 1.0, 0.2
FINE = {"zone": 0.06, "refine": 1}


def slid(normal):
    """A disc pressed on a block and slid until nothing sticks."""
    problem = ContactProblem(
        join({"disc": half_disc(R=RADIUS, **FINE),
              "block": full_block(width=RADIUS, depth=RADIUS, **FINE)}),
        materials=Elastic(E=1.0, nu=0.3), assumption="plane strain",
        supports={"block.bottom": "xy", "disc.middle": "xy"},
        contacts=[Pair(slave="disc.surface", master="block.surface", friction=MU, normal=normal,
                       slave_shape=Circle((0.0, RADIUS), RADIUS), master_shape=Flat())],
    )  # fmt: skip
    pressed = problem.solve(displacements={"disc.middle": {"y": -0.004}})
    return problem.solve(displacements={"disc.middle": {"x": 0.02, "y": -0.004}}, after=pressed)


def test_pressure_keeps_one_direction_along_a_flat_master_and_turns_between_two_bodies():
    touch = slid("master").touches[0]
    np.testing.assert_allclose(touch.mortar.points.n.T, [(0, -1)] * touch.p.size, atol=1e-14)
    x, y = touch.force
    assert x == pytest.approx(-MU * y, rel=1e-12)
    touch = slid("between").touches[0]
    # half of the disc's slope, both moduli being equal
    near = np.abs(touch.mortar.points.x[0]) < 0.1 * RADIUS
    n = touch.mortar.points.n[:, near]
    expected = touch.mortar.points.x[0, near] / (2 * RADIUS)
    np.testing.assert_allclose(n[0] / -n[1], expected, rtol=0.01, atol=1e-6)
    x, y = touch.force
    assert abs(x / (MU * y) + 1) > 1e-4  # the contact has moved to where the surface is inclined
    with pytest.raises(ValueError, match="'between' or 'master', got 'slave'"):
        Pair(slave="a", master="b", normal="slave")

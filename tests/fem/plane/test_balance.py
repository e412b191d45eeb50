"""Supports answer loads: forces, moments and work balance on any mesh."""

import numpy as np
import pytest

from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from tests.fem.plane.models import every_case, trapezoid

MATERIAL = Elastic(E=1000.0, nu=0.3)
BALANCE = 1e-9  # of the loads; the refined solve leaves about 1e-13


def moment(at, force):
    return at[0] * force[1] - at[1] * force[0]


@every_case
def test_a_clamped_side_answers_every_kind_of_load_at_once(kind, assumption):
    p, t, w, P, thickness = 3.0, (0.5, -1.2), (0.7, -2.0), (1.1, 0.4), 0.02
    s = solve_plane(
        trapezoid(kind), materials=MATERIAL, assumption=assumption, thickness=thickness,
        supports={"left": "xy"}, pressures={"top": p}, tractions={"right": t}, body_forces=w,
        point_forces={(4, 0): P},
    )  # fmt: skip
    # by hand: the top runs from (0, 1) to (4, 3), which turned inwards is (2, -4) p; the right side
    # is 3 long; the area int (1 + x/2) dx = 8 has its centroid at (56/3, 26/3) / 8
    loads = [
        ((2.0, 2.0), (2 * p * thickness, -4 * p * thickness)),
        ((4.0, 1.5), (3 * t[0] * thickness, 3 * t[1] * thickness)),
        ((7 / 3, 13 / 12), (8 * w[0] * thickness, 8 * w[1] * thickness)),
        ((4.0, 0.0), P),
    ]
    f_x, f_y = (sum(force[i] for _, force in loads) for i in (0, 1))
    couple = sum(moment(at, force) for at, force in loads)
    assert s.reaction("left") == pytest.approx((-f_x, -f_y, -couple), rel=BALANCE)


@every_case
def test_smooth_walls_that_share_a_corner_answer_the_load_once_and_across_alone(kind, assumption):
    # 3 times (2, -1) at the middle of the right side; the corner (0, 0) is held by both walls
    s = solve_plane(
        trapezoid(kind), materials=MATERIAL, assumption=assumption,
        supports={"left": "x", "bottom": "y"}, tractions={"right": (2.0, -1.0)},
    )  # fmt: skip
    left, bottom = s.reaction("left"), s.reaction("bottom")
    total = np.add(left, bottom)
    assert total == pytest.approx([-6, 3, -moment((4, 1.5), (6, -3))], rel=BALANCE)
    assert (left[1], bottom[0]) == pytest.approx((0, 0), abs=6 * BALANCE)


@every_case
def test_anchors_answer_like_a_beam_on_two_supports(kind, assumption):
    four = 10 * (0.1 + 0.2) + 1  # 4.000000000000001: found by its place, not by its last digit
    s = solve_plane(
        trapezoid(kind), materials=MATERIAL, assumption=assumption, supports={},
        anchors={(0, 0): "xy", (four, 0): {"y": 0.0}}, point_forces={(0, 1): (2.0, -10.0)},
    )  # fmt: skip
    # moments about (0, 0): 4 R - 1 * 2 = 0, as the force is 2 along x at a height of 1
    assert s.reaction_at((4, 0)) == pytest.approx((0, 2 / 4), abs=10 * BALANCE)
    assert s.reaction_at((0, 0)) == pytest.approx((-2, 10 - 2 / 4), abs=10 * BALANCE)

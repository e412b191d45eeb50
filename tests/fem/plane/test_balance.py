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


def test_a_pressure_that_grows_with_depth_presses_with_its_resultant():
    # water to the top of the right side: rho g int (3 - y) dy = 4.5 at a third of the height
    s = solve_plane(
        trapezoid("tri6"), materials=MATERIAL, assumption="plane strain",
        supports={"bottom": "xy"}, pressures={"right": lambda x: 3 - x[1]},
    )  # fmt: skip
    assert s.reaction("bottom") == pytest.approx((4.5, 0, -4.5), abs=4.5 * BALANCE)


def test_far_from_the_origin_the_moment_is_still_about_the_origin():
    s = solve_plane(
        trapezoid("quad9", origin=(1000.0, -500.0)), materials=MATERIAL, assumption="plane strain",
        supports={"left": "xy"}, point_forces={(1004.0, -500.0): (2.0, 3.0)},
    )  # fmt: skip
    expected = -2, -3, -moment((1004, -500), (2, 3))
    assert s.reaction("left") == pytest.approx(expected, rel=BALANCE)


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


def test_supports_that_say_the_same_share_their_force():
    # the block's foot is held along y twice over, by name and by anchors
    s = solve_plane(
        trapezoid("quad9"), materials=MATERIAL, assumption="plane stress",
        supports={"left": {"x": 0.0, "n": 0.0}, "bottom": "y"},
        anchors={(0, 0): "y", (4, 0): "y"}, tractions={"right": (2.0, -1.0)},
    )  # fmt: skip
    feet = [s.reaction_at(point) for point in ((0, 0), (4, 0))]
    total = np.add(s.reaction("left"), s.reaction("bottom"))[:2] + np.sum(feet, axis=0)
    assert tuple(total) == pytest.approx((-6, 3), rel=BALANCE)


@every_case
def test_the_work_of_a_prescribed_movement_is_stored(kind, assumption):
    delta = 0.01
    s = solve_plane(
        trapezoid(kind), materials=MATERIAL, assumption=assumption,
        supports={"left": "xy", "right": {"x": delta, "y": 0.0}},
    )  # fmt: skip
    # Clapeyron: the force rises in proportion to delta
    assert s.strain_energy == pytest.approx(s.reaction("right")[0] * delta / 2, rel=BALANCE)
    assert s.potential_energy == s.strain_energy  # no loads


def test_two_point_forces_move_each_others_points_alike():
    # Maxwell and Betti: 1 along x at A moves B along y as 1 along y at B moves A along x
    A, B = (4, 3), (4, 0)

    def under(point, force):
        return solve_plane(
            trapezoid("tri6"), materials=MATERIAL, assumption="plane stress",
            supports={"left": "xy"}, point_forces={point: force},
        )  # fmt: skip

    of_A_at_B = under(A, (1.0, 0.0)).displacement_at(B)[1]
    of_B_at_A = under(B, (0.0, 1.0)).displacement_at(A)[0]
    assert of_A_at_B == pytest.approx(of_B_at_A, rel=BALANCE)
    assert of_A_at_B != 0

"""A disc in a ring of its own material under outer pressure: hydrostatic, but for the facets."""

from functools import cache

import numpy as np
import pytest

from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.contact.shapes import Circle
from fem.plane.material import Elastic
from meshes.contact.round import full_disc, full_ring
from meshes.join import join

P, R = 0.01, 1.0  # any; P/E = 1/300 is what gaps between facets count against
SHAPES = {"disc.rim": Circle((0, 0), R), "ring.bore": Circle((0, 0), R, hollow=True)}


@cache
def nested(refine, *, swap, shapes, friction=0.3, order=2):
    mesh = join({
        "disc": full_disc(R=R, around=24 * refine, order=order),
        "ring": full_ring(
            r_i=R, r_o=1.6, around=32 * refine, across=4 * refine, order=order
        ),
    })  # fmt: skip
    slave, master = list(SHAPES)[::-1] if swap else list(SHAPES)
    exact = {"slave_shape": SHAPES[slave], "master_shape": SHAPES[master]} if shapes else {}
    problem = ContactProblem(
        mesh, materials=Elastic(E=3.0, nu=0.3), assumption="plane strain",
        anchors={(0, 0): "xy", (1.6, 0): "y"},
        contacts=[Pair(slave=slave, master=master, friction=friction, **exact)],
    )  # fmt: skip
    return problem.solve(pressures={"ring.rim": P})


def stress_error(solution):
    xx, yy, xy, _ = solution.plane.in_body().stress
    return np.abs(np.array([xx + P, yy + P, xy])).max() / P


@pytest.mark.parametrize(
    ("shapes", "swap", "coarse"),
    # parabolas miss the circle by R phi^4/384 = 1e-5 R at most, R P/E is 3e-3 R: parts in 300 at
    # the vertices, a tenth of it or less where gaps come from the circles themselves
    [(False, True, 3e-2), (True, False, 1e-4)],
    ids=["facets, swapped", "circles"],
)
def test_parabolic_facets_fall_away_with_the_third_order_at_least(shapes, swap, coarse):
    errors = [stress_error(nested(k, swap=swap, shapes=shapes)) for k in (1, 2)]
    assert errors[0] < coarse
    assert np.log2(errors[0] / errors[1]) > 2.7, errors


def test_straight_cells_with_exact_circles_leave_the_interface_free_of_facets():
    # the circles' polygons are up to 0.9 % of R apart, three times what the load moves them
    with_circles = nested(1, swap=False, shapes=True, order=1)
    assert stress_error(with_circles) < 3e-3
    assert stress_error(nested(1, swap=False, shapes=False, order=1)) > 0.3


def test_no_part_of_the_interface_rubs_or_opens():
    touch = nested(1, swap=False, shapes=True, friction=0.1).touches[0]
    assert np.all(touch.closed)
    assert np.all(touch.sticks)
    assert np.abs(touch.traction).max() < 1e-4 * P  # the stresses' own error


def test_without_friction_the_disc_may_turn_and_the_state_is_as_hydrostatic():
    assert stress_error(nested(1, swap=False, shapes=True, friction=0.0)) < 1e-4


def test_around_a_circle_middle_nodes_lie_halfway_between_their_neighbours():
    touch = nested(1, swap=False, shapes=True).touches[0]
    half = np.sin(np.pi / 24)  # of a chord of the circle of radius 1
    assert touch.arc.size == 2 * 24
    assert touch.arc.min() == 0  # the curve is closed: its last node is its first
    np.testing.assert_allclose(np.diff(np.sort(touch.arc)), half, rtol=1e-6)

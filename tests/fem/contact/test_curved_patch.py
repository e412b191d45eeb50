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


@pytest.mark.parametrize("swap", [False, True], ids=["", "swapped"])
@pytest.mark.parametrize(
    ("shapes", "coarse"),
    # parabolas miss the circle by R phi^4/384 = 1e-5 R at most, R P/E is 3e-3 R: parts in 300 at
    # the vertices, a tenth of it or less where gaps come from the circles themselves
    [(False, 3e-2), (True, 1e-4)],
    ids=["facets", "circles"],
)
def test_parabolic_facets_fall_away_with_the_third_order_at_least(swap, shapes, coarse):
    errors = [stress_error(nested(k, swap=swap, shapes=shapes)) for k in (1, 2)]
    assert errors[0] < coarse
    assert np.log2(errors[0] / errors[1]) > 2.7, errors


@pytest.mark.parametrize("swap", [False, True], ids=["", "swapped"])
def test_the_mean_pressure_is_that_on_the_ring(swap):
    # its error is that of the parabolas' area, which goes with the fourth order
    errors = [
        nested(k, swap=swap, shapes=False).touches[0].normal_force / (2 * np.pi * R * P) - 1
        for k in (1, 2)
    ]
    assert abs(errors[0]) < 1e-3
    assert np.log2(errors[0] / errors[1]) == pytest.approx(4, abs=0.1)


def test_straight_cells_with_exact_circles_leave_the_interface_free_of_facets():
    # the circles' polygons are up to 0.9 % of R apart, three times what the load moves them
    with_circles = nested(1, swap=False, shapes=True, order=1)
    assert stress_error(with_circles) < 3e-3
    assert stress_error(nested(1, swap=False, shapes=False, order=1)) > 0.3


@pytest.mark.parametrize("friction", [0.1, 2.0])
def test_no_part_of_the_interface_rubs_or_opens(friction):
    touch = nested(1, swap=False, shapes=True, friction=friction).touches[0]
    assert np.all(touch.closed)
    assert np.all(touch.sticks)
    assert np.abs(touch.traction).max() < 1e-4 * P  # the stresses' own error


def test_without_friction_the_disc_may_turn_and_the_state_is_as_hydrostatic():
    assert stress_error(nested(1, swap=False, shapes=True, friction=0.0)) < 1e-4

"""Places along a surface where its traction is given, middle nodes among them."""

import numpy as np
import pytest

from fem.contact.pairs import Pair
from fem.contact.problem import ContactProblem
from fem.plane.material import Elastic
from meshes.contact.block import block
from meshes.contact.round import full_disc, full_ring
from meshes.join import join

STEEL = Elastic(E=3.0, nu=0.3)


@pytest.mark.parametrize("order", [1, 2])
def test_along_a_straight_surface_the_arc_is_the_way_from_its_start(order):
    mesh = join({
        "top": block(x=(0, 1), y=(1, 2), nx=4, ny=2, order=order),
        "low": block(x=(0, 1), y=(0, 1), nx=3, ny=2, order=order),
    })  # fmt: skip
    problem = ContactProblem(
        mesh, materials=STEEL, assumption="plane strain",
        supports={"low.bottom": "xy"}, anchors={(0, 2): "x", (1, 2): "x"},
        contacts=[Pair(slave="top.bottom", master="low.top")],
    )  # fmt: skip
    touch = problem.solve(pressures={"top.top": 0.01}).touches[0]
    assert touch.arc.size == 4 * order + 1
    start = touch.x[:, touch.arc.argmin()]
    np.testing.assert_allclose(touch.arc, np.hypot(*(touch.x.T - start).T), atol=1e-12)


def test_around_a_circle_middle_nodes_lie_halfway_between_their_neighbours():
    count = 24
    mesh = join({
        "disc": full_disc(R=1.0, around=count, order=2),
        "ring": full_ring(r_i=1.0, r_o=1.6, around=32, across=2, order=2),
    })  # fmt: skip
    problem = ContactProblem(
        mesh, materials=STEEL, assumption="plane strain",
        anchors={(0, 0): "xy", (1.6, 0): "y"},
        contacts=[Pair(slave="disc.rim", master="ring.bore", friction=0.3)],
    )  # fmt: skip
    touch = problem.solve(pressures={"ring.rim": 0.01}).touches[0]
    half = np.sin(np.pi / count)  # of a chord of the circle of radius 1
    assert touch.arc.size == 2 * count
    assert touch.arc.min() == 0  # the curve is closed: its last node is its first
    np.testing.assert_allclose(np.diff(np.sort(touch.arc)), half, rtol=1e-6)

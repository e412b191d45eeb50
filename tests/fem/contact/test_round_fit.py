"""Readings of two walls that touch along a circle, of pressures and fields that are known."""

from types import SimpleNamespace

import numpy as np
import pytest

from fem.contact.round_fit import mean_and_scatter, means_on, pressure_at
from fem.plane.material import Elastic
from fem.plane.solve import solve_plane
from meshes.ring.quarter import quarter_ring


def test_scatter_is_weighed_and_none_of_an_even_pressure():
    weight = np.array([1.0, 1.0, 2.0])
    even = SimpleNamespace(p=np.full(3, 5.0), weight=weight)
    assert mean_and_scatter(even) == (5.0, 0.0)
    uneven = SimpleNamespace(p=np.array([4.0, 4.0, 6.0]), weight=weight)
    assert mean_and_scatter(uneven) == (5.0, 1.0)


def test_pressures_are_taken_by_angle_whatever_the_order_of_the_nodes():
    turn = np.radians([50.0, 10.0, 30.0])
    touch = SimpleNamespace(x=2 * np.array([np.cos(turn), np.sin(turn)]), pressure=10 * turn)
    at = np.radians([20.0, 45.0])
    assert pressure_at(touch, at) == pytest.approx(10 * at)


def test_a_ring_under_pressure_has_lame_s_means():
    ring = solve_plane(
        quarter_ring(r_i=1.0, r_o=2.0, refine=8), materials=Elastic(E=3.0, nu=0.3),
        assumption="plane stress", supports={"x=0": "x", "y=0": "y"}, pressures={"bore": 0.6},
    )  # fmt: skip
    moved, hoop = means_on(ring, "bore")
    assert hoop == pytest.approx(0.6 * 5 / 3, rel=1e-3)
    assert moved == pytest.approx(0.6 / 3 * (5 / 3 + 0.3), rel=1e-4)

"""Second moments of leaves and arcs against quadrature along them."""

import math

import numpy as np
import pytest

from analytic.spring.wire import Wire, arc, leaf


def quadrature(start, heading, length, turn):
    """G and D by Gauss points along a piece, from its curvature alone."""
    t, w = np.polynomial.legendre.leggauss(40)
    s, w = (t + 1) / 2 * length, w / 2 * length
    angle = heading + turn * s / length
    if turn:
        k = turn / length
        x = start[0] + (np.sin(angle) - math.sin(heading)) / k
        y = start[1] - (np.cos(angle) - math.cos(heading)) / k
    else:
        x, y = start[0] + s * math.cos(heading), start[1] + s * math.sin(heading)
    v, tangent = np.array([np.ones_like(x), x, y]), np.array([np.cos(angle), np.sin(angle)])
    return (v * w) @ v.T, (tangent * w) @ tangent.T


@pytest.mark.parametrize("turn", [-0.5 * math.pi, -1.2, 0.3, 1.4, 0.5 * math.pi])
@pytest.mark.parametrize("heading", [0.0, 0.5 * math.pi, -1.4])
def test_an_arc_s_moments_are_those_of_its_points(turn, heading):
    start, R = np.array([2.0, -3.0]), 0.7
    wire, end = arc(start, heading, R, turn)
    G, D = quadrature(start, heading, R * abs(turn), turn)
    np.testing.assert_allclose(wire.G, G, rtol=1e-12)
    np.testing.assert_allclose(wire.D, D, atol=1e-14)
    chord = 2 * R * math.sin(abs(turn) / 2)
    towards = heading + turn / 2
    np.testing.assert_allclose(end - start, [chord * math.cos(towards), chord * math.sin(towards)])


def test_a_leaf_s_moments_are_those_of_its_points():
    start = np.array([1.0, 4.0])
    wire, end = leaf(start, -1.1, 3.0)
    G, D = quadrature(start, -1.1, 3.0, 0.0)
    np.testing.assert_allclose(wire.G, G, rtol=1e-12)
    np.testing.assert_allclose(wire.D, D, rtol=1e-12)
    np.testing.assert_allclose(end, start + 3 * np.array([math.cos(1.1), -math.sin(1.1)]))


def test_parts_add_up_to_the_whole_and_come_off_again():
    first, middle = leaf(np.zeros(2), 0.4, 2.0)
    second, _ = leaf(middle, 0.4, 3.0)
    whole, _ = leaf(np.zeros(2), 0.4, 5.0)
    np.testing.assert_allclose((first + second).G, whole.G, rtol=1e-13)
    np.testing.assert_allclose((whole - first).D, second.D, rtol=1e-13)
    assert whole.length == pytest.approx(5.0)
    assert isinstance(first + second, Wire)


def test_many_pieces_at_once_are_the_same_as_one_by_one():
    R, turn = np.array([0.4, 0.5, 0.6]), np.array([-1.0, 0.7, 1.5])
    start, heading = np.zeros((3, 2)), np.array([0.0, 1.0, -1.0])
    together, ends = arc(start, heading, R, turn)
    for i in range(3):
        alone, end = arc(start[i], heading[i], R[i], turn[i])
        np.testing.assert_allclose(together.G[i], alone.G, rtol=1e-13)
        np.testing.assert_allclose(ends[i], end, rtol=1e-13)

"""The force method and second moments of leaves and arcs against closed forms."""

import math

import numpy as np
import pytest

from analytic.spring import frame
from analytic.spring.wire import arc

STRIP = {"b": 0.1, "h": 56.0, "E": 206e3, "nu": 0.3}
EI, EA = 206e3 * 56.0 * 0.1**3 / 12, 206e3 * 5.6
PAPER = {"n": 10, "L1": 11.6, "radius": 0.5, "alpha": math.radians(80)}


def compliance(parts, theory="bending"):
    return frame.flexibility(frame.sections(iter(parts)), **STRIP, theory=theory)


def test_a_straight_cantilever_bends_as_in_every_table():
    """A leaf of length L along y: L³/3EI for a force along x, L²/2EI turning, no C_yy."""
    L = 7.0
    C = compliance([(L, 0.0)])
    np.testing.assert_allclose(
        C * EI, [[L**3 / 3, 0, L**2 / 2], [0, 0, 0], [L**2 / 2, 0, L]], atol=1e-10
    )


@pytest.mark.parametrize("nu", [0.0, 0.3, 3 / 7], ids=["nu 0", "nu 0.3", "nu 0.3, plane strain"])
@pytest.mark.parametrize("b", [0.025, 0.05, 0.1])
def test_a_quarter_ring_under_a_radial_force_deflects_as_in_plane_elasticity(b, nu):
    """Timoshenko and Goodier, art. 33: pi D/E with D = P (i² + o²)/N, whatever nu is.

    What the thick theory leaves out is of the fourth order in b/R; without nu in the coupling of
    M and N it would be 0.06 (b/R)².
    """
    R, h, E = 0.5, 56.0, 206e3
    i, o = R - b / 2, R + b / 2
    N = (i**2 + o**2) * math.log(o / i) - (o**2 - i**2)
    exact = math.pi * (i**2 + o**2) / (E * h * N)
    quarter = frame.sections(iter([(R * math.pi / 2, -math.pi / 2)]))
    C = frame.flexibility(quarter, b=b, h=h, E=E, nu=nu, theory="thick")
    assert C[0, 0] == pytest.approx(exact, rel=0.1 * (b / R) ** 4)


@pytest.mark.parametrize("n", [3, 4, 9, 10])
def test_the_held_mid_leaf_lies_on_the_line_of_force(n):
    x, y = frame.end_point(**PAPER | {"n": n}, tail="mid-leaf")
    assert y == pytest.approx(0.0, abs=1e-12)
    # n - 1 loops, each as long as its two half pitches: 2 R sin α + L2 cos α, quarter arcs R
    a = PAPER["alpha"]
    L2 = 11.6 / math.sin(a) + 1.0 / math.tan(a)
    assert x == pytest.approx((n - 2) * (math.sin(a) + L2 * math.cos(a)) + 1.0, rel=1e-13)


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

"""The force method and second moments of leaves and arcs against closed forms."""

import math

import numpy as np
import pytest

from analytic.spring import frame

STRIP = {"b": 0.1, "h": 56.0, "E": 206e3, "nu": 0.3}
EI, EA = 206e3 * 56.0 * 0.1**3 / 12, 206e3 * 5.6


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

"""Large bending of springs: small displacements, textbook columns, derivatives, no scale."""

import math

import numpy as np
import pytest
from scipy.special import ellipe, ellipk

from analytic.spring import frame
from analytic.spring.elastica import Elastica

SHAPE = {"n": 10, "L1": 11.6, "radius": 0.5, "alpha": math.radians(80)}
STRIP = {"b": 0.1, "h": 56.0, "E": 206e3, "nu": 0.3}
E_I, E_A = 206e3 * 56 * 0.1**3 / 12, 206e3 * 56 * 0.1
STIFF = {"EI": E_I, "EA": E_A, "GA": 5 / 6 * E_A / 2.6}


def spring(tail="arc", **changes):
    return Elastica(frame.pieces(**SHAPE, tail=tail), **STIFF | changes)


@pytest.mark.parametrize("tail", ["arc", "mid-leaf"])
@pytest.mark.parametrize("head", ["free", "hinged", "guided"])
def test_a_small_push_meets_the_stiffness_of_the_force_method(head, tail):
    k = frame.stiffness(**SHAPE, **STRIP, head=head, tail=tail, theory="shear")
    error = [spring(tail).path(head, [U])[0].F / U / k - 1 for U in (2e-4, 1e-4)]
    assert 2 * error[1] - error[0] == pytest.approx(0, abs=1e-9)


def test_a_straight_column_bends_as_the_elastica_of_elliptic_integrals():
    """T. & G., art. 2.7: a cantilever whose end has turned by 60 deg."""
    line, k = Elastica([(1.0, 0.0)] * 4, EI=1.0), math.sin(math.radians(30))
    K, E = ellipk(k**2), ellipe(k**2)
    P = (K / 4) ** 2
    state = line.unloaded()
    for share in np.linspace(0.2, 1, 9):  # round the bifurcation, pushed a little aside
        state = line.pushed((2e-2 * P, share * P), state)
    for aside in (5e-3, 0.0):
        state = line.pushed((aside * P, P), state)
    assert abs(state.head[0]) == pytest.approx(math.radians(60), rel=1e-8)
    assert 4 - state.drift == pytest.approx(4 * (2 * E / K - 1), rel=1e-8)
    assert abs(state.U) == pytest.approx(4 * 2 * k / K, rel=1e-8)

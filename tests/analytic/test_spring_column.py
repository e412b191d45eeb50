"""The force method, the elastica and the equivalent column: closed forms, mutual comparison."""

import math

import numpy as np
import pytest
from scipy.special import ellipe, ellipk

from analytic.spring import column, frame
from analytic.spring.elastica import Elastica
from analytic.spring.stability import critical, determinant, lateral_stiffness

SHAPE = {"L1": 11.6, "radius": 0.5, "alpha": math.radians(80)}
STRIP = {"b": 0.1, "h": 56.0, "E": 206e3, "nu": 0.3}


def spring(n, tail="arc"):
    EA = 206e3 * 56 * 0.1
    parts = frame.pieces(n=n, **SHAPE, tail=tail)
    return Elastica(parts, EI=EA * 0.1**2 / 12, EA=EA, GA=5 / 6 * EA / 2.6)


def test_a_straight_cantilever_bends_as_in_every_table():
    """A leaf of length L along y: L³/3EI for a force along x, L²/2EI turning, no C_yy."""
    L, EI = 7.0, 206e3 * 56.0 * 0.1**3 / 12
    C = frame.flexibility(frame.sections(iter([(L, 0.0)])), **STRIP, theory="bending")
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


@pytest.mark.parametrize("tail", ["arc", "mid-leaf"])
@pytest.mark.parametrize("head", ["free", "hinged", "guided"])
def test_a_small_push_meets_the_stiffness_of_the_force_method(head, tail):
    k = frame.stiffness(n=10, **SHAPE, **STRIP, head=head, tail=tail, theory="shear")
    error = [spring(10, tail).path(head, [U])[0].F / U / k - 1 for U in (2e-4, 1e-4)]
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


@pytest.mark.parametrize("alpha", [20.0, 55.0, 80.0, 90.0])
def test_a_unit_s_flexibilities_are_the_unit_load_integrals(alpha):
    """Against Gauss points on its arc, leaf and arc, seen from its centre."""
    shape = SHAPE | {"alpha": math.radians(alpha)}
    parts = list(frame.pieces(n=4, **shape))[2:5]
    line = frame.sections(iter([(1e-9, -math.pi / 2), *parts]))
    line.at[:] -= np.average(line.at, axis=1, weights=line.ds)[:, None]
    C = frame.flexibility(line, **STRIP, theory="shear")
    unit = column.unit(**shape, **STRIP)
    assert [unit.axial, unit.lateral, unit.turn] == pytest.approx(np.diag(C), rel=1e-6)


@pytest.mark.parametrize(("head", "waves"), [("free", math.pi / 2), ("guided", 2 * math.pi)])
def test_the_shortening_solves_haringx_s_equation(head, waves):
    n = 10 if head == "free" else 60
    xi = column.critical_shortening(head, n=n, b=0.1, **SHAPE)
    kL = wave(n, xi)[0]
    assert kL == pytest.approx(waves, rel=1e-12)
    xi = column.critical_shortening("hinged", n=30, b=0.1, **SHAPE)
    kL, stiffer = wave(30, xi)
    assert math.tan(kL) == pytest.approx(kL / stiffer, rel=1e-9)
    assert math.pi < kL < 1.5 * math.pi


def wave(n, xi):
    """Wave number times length, and 1 + P/S, by the rigidities of the shortened column."""
    u = column.unit(**SHAPE, **STRIP)
    p, L0 = u.pitch, column.free_length(n=n, **SHAPE)
    B, C = p / u.turn * (1 - xi), p / u.axial
    S = p / (u.lateral - p**2 * u.turn / 12) * (1 - xi)
    P, L = C * xi, L0 * (1 - xi)
    return float(np.sqrt(P / B * (1 + P / S)) * L), float(1 + P / S)


@pytest.mark.parametrize(
    ("n", "tail", "within"),
    [(6, "arc", 0.24), (10, "arc", 0.07), (20, "arc", 0.03), (10, "mid-leaf", 0.01)],
)
def test_the_column_comes_nearer_to_the_elastica_with_more_units(n, tail, within):
    xi = column.critical_shortening("free", n=n, b=0.1, **SHAPE)
    L0 = column.free_length(n=n, **SHAPE)
    state = critical(spring(n, tail), "free", np.linspace(0.2, 2, 10) * xi * L0)
    assert pytest.approx(xi, rel=within) == state.U / L0
    assert determinant(state, "free") == pytest.approx(0, abs=1e-8)


def test_the_lateral_stiffness_is_that_of_the_force_method_at_first():
    line = frame.sections(frame.pieces(n=10, **SHAPE))
    C = frame.flexibility(line, **STRIP, theory="shear")
    assert lateral_stiffness(spring(10).unloaded()) == pytest.approx(
        np.linalg.inv(C)[1, 1], rel=1e-7
    )


def test_ever_more_units_make_euler_s_column():
    xi = column.critical_shortening("free", n=4000, b=0.1, **SHAPE)
    u, L0 = column.unit(**SHAPE, **STRIP), column.free_length(n=4000, **SHAPE)
    P = column.critical_force("free", n=4000, **SHAPE, **STRIP)
    assert pytest.approx(math.pi**2 / 4 * u.pitch / u.turn / L0**2, rel=1e-5) == P
    assert pytest.approx(u.pitch / u.axial * xi, rel=1e-12) == P

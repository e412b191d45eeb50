"""The force method on leaves and arcs against closed forms of single members."""

import math

import numpy as np
import pytest

from analytic.spring import frame

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


def test_a_straight_cantilever_stretches_and_shears():
    L, G = 7.0, 206e3 / 2.6
    thin, shear = compliance([(L, 0.0)], "thin"), compliance([(L, 0.0)], "shear")
    assert thin[1, 1] == pytest.approx(L / EA, rel=1e-13)
    assert shear[0, 0] - thin[0, 0] == pytest.approx(1.2 * L / (G * 5.6), rel=1e-9)


def test_a_quarter_arc_bends_as_in_every_table():
    """Radius R from the top of a quarter circle: πR³/4 across, R³(3π/4 - 2) along, R³/2 mixed."""
    R = 3.0
    C = compliance([(R * math.pi / 2, -math.pi / 2)]) * EI / R**3
    assert sorted([C[0, 0], C[1, 1]]) == pytest.approx(
        [3 * math.pi / 4 - 2, math.pi / 4], rel=1e-12
    )
    assert abs(C[0, 1]) == pytest.approx(0.5, rel=1e-12)


@pytest.mark.parametrize("b", [0.02, 0.05, 0.1])
def test_pure_bending_of_a_curved_bar_is_softer_by_a_thirtieth_of_its_curvature_squared(b):
    """Series of Golovin's solution: EI c_MM = 1 + (b/R)²/30 + O((b/R)^4)."""
    R, h, E = 0.5, 56.0, 206e3
    *_, c_MM = frame._curved_bar(R, b, h, E, 0.3)
    excess = c_MM * E * h * b**3 / 12 - 1
    assert excess == pytest.approx((b / R) ** 2 / 30, rel=(b / R) ** 2)


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


def test_more_support_makes_the_spring_stiffer():
    k = {
        (head, tail): frame.stiffness(**PAPER, **STRIP, head=head, tail=tail)
        for head in ("free", "hinged", "guided")
        for tail in ("arc", "mid-leaf")
    }
    for tail in ("arc", "mid-leaf"):
        assert k["free", tail] < k["hinged", tail] < k["guided", tail]
    for head in ("free", "hinged", "guided"):
        assert k[head, "mid-leaf"] < k[head, "arc"]


def test_each_theory_makes_the_thin_spring_softer():
    """Every effect adds compliance, and none more than (b/R)² = 4 %."""
    k = [frame.stiffness(**PAPER, **STRIP, theory=t) for t in ("bending", "thin", "shear")]
    assert k[0] > k[1] > k[2] > 0.96 * k[0]


def test_a_wide_strip_is_stiffer_by_the_plate_factor():
    narrow = frame.stiffness(**PAPER, **STRIP)
    wide = frame.stiffness(**PAPER, **STRIP, plane_strain=True)
    assert wide / narrow == pytest.approx(1 / (1 - 0.09), rel=1e-13)


def test_head_and_tail_may_change_places():
    """A tail held in mid-leaf mirrors a guided head: hinged at either end gives one stiffness."""
    ends = {"tail": "mid-leaf"}
    a = frame.stiffness(**PAPER, **STRIP, **ends, head="hinged", hold="clamped")
    b = frame.stiffness(**PAPER, **STRIP, **ends, head="guided", hold="hinged")
    assert a == pytest.approx(b, rel=1e-10)


@pytest.mark.parametrize("n", [3, 4, 9, 10])
def test_the_held_mid_leaf_lies_on_the_line_of_force(n):
    x, y = frame.end_point(**PAPER | {"n": n}, tail="mid-leaf")
    assert y == pytest.approx(0.0, abs=1e-12)
    # n - 1 loops, each as long as its two half pitches: 2 R sin α + L2 cos α, quarter arcs R
    a = PAPER["alpha"]
    L2 = 11.6 / math.sin(a) + 1.0 / math.tan(a)
    assert x == pytest.approx((n - 2) * (math.sin(a) + L2 * math.cos(a)) + 1.0, rel=1e-13)


def test_a_spring_that_swings_freely_is_refused():
    with pytest.raises(ValueError, match="swings freely"):
        frame.stiffness(**PAPER, **STRIP, head="free", hold="hinged")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"n": 2}, "at least 3 segments"),
        ({"radius": 0.0}, "must be positive"),
        ({"alpha": 2.0}, "alpha must lie in"),
        ({"b": 0.0}, "needs b, h, E > 0"),
        ({"b": 1.0, "theory": "thick"}, "cannot have the radius"),
    ],
)
def test_input_that_makes_no_sense_is_refused(change, message):
    with pytest.raises(ValueError, match=message):
        frame.stiffness(**PAPER | STRIP | change)

"""Elastic columns of a sprag: discs, patches, rolling ends, flanks, scales of the whole clutch."""

import numpy as np
import pytest

from analytic.contact.hertz_line_approach import approach_to_centre
from analytic.sprag.bending import Ends, shift
from analytic.sprag.closure import wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.column import Column, Outline, approach
from analytic.sprag.compliance import Compliance
from analytic.sprag.elastic import ElasticSpragClutch
from analytic.sprag.geometry import LogSprag
from analytic.sprag.parts import SpragClutchParts
from tests.analytic.sprag.models import SPRAG

RIGID = SpragClutch(sprag=SPRAG, n_s=12, compliance=Compliance(
    contact_i=np.zeros_like, contact_e=np.zeros_like, race_i=0.0, race_e=0.0, sprag=0.0,
))  # fmt: skip
AT, COLUMN = wedged(RIGID, 1.0), Column(sprag=SPRAG, b=4e-3)
NONE = (0.0, 0.0)


def test_the_centre_of_pressure_of_a_cubic_gap_is_that_of_its_integral_equation():
    """Slope s/R - m s²/(2 r²) on a patch about c, pressure by the finite Hilbert transform."""
    none = Ends(moved=NONE, turned=NONE)
    a, m = 5e-5, float(SPRAG.m)
    got = shift(AT, none, column=COLUMN, a=(a, a), P=0.0, races=NONE)
    r, OA = float(AT.rho) * np.hypot(1, m), float(AT.OA)
    R = 1 / (1 / r + 1 / OA)
    turn = (np.arange(400) + 0.5) * np.pi / 400
    x = a * np.cos(turn)

    def slope(c):
        return (x + c) / R - m * (x + c) ** 2 / (2 * r**2)

    # closed at both ends where the mean slope over 1/sqrt(a² - x²) vanishes
    c = 0.0
    for _ in range(20):
        c -= slope(c).mean() * R
    waves = [2 * np.mean(slope(c) * np.cos(n * turn)) for n in (1, 2)]
    centre = c + a * waves[1] / (2 * waves[0])  # U_0 and U_1 times sqrt(1 - x²/a²)
    assert got.spiral == pytest.approx(centre / OA / float(AT.beta), rel=1e-4)


@pytest.mark.parametrize("end", [0, 1])
def test_an_end_that_rolls_is_touched_on_the_line_through_the_axis_and_its_centre(end):
    """A circle on a disc, or in a bore: beside the point that it has touched with, moved as well.

    Turned by psi where it touches, its centre moves by r psi; moved by u, by u.
    """
    psi, u, P = 2.0, 0.3, 1e-6
    one = np.eye(2)[end]
    bent_end = Ends(moved=tuple(u * one), turned=tuple(psi * one))
    got = shift(AT, bent_end, column=COLUMN, a=NONE, P=P, races=NONE)
    race = float((AT.OA, AT.OB)[end])
    r = float((np.asarray(AT.rho * np.hypot(1, SPRAG.m)), np.asarray(SPRAG.r_e))[end])
    centre = race + r if end == 0 else race - r  # its distance from the axis
    turned = P * psi * r / centre
    moved = P * u / centre - P * u / race  # of the contact, but for the point itself
    sign = -1.0 if end == 0 else 1.0
    assert got.turned * float(AT.beta) == pytest.approx(-turned, rel=1e-12)
    assert got.moved * float(AT.beta) == pytest.approx(-sign * moved, rel=1e-12)


PATCHES = (112e-6, 154e-6)


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
def test_a_disc_of_any_size_and_place_yields_as_in_closed_form(nu):
    R, turn = 4e-3, np.linspace(-1.5, 1.5, 101)
    right = 0.02 + R * np.exp(1j * (turn + 0.3))
    left = 0.02 - R * np.exp(1j * (0.3 - turn))
    A, B = 0.02 - 1j * R * np.exp(0.3j), 0.02 + 1j * R * np.exp(0.3j)
    disc = Outline(A=A, B=B, left=left, right=right)
    exact = sum(float(approach_to_centre(P=1.0, a=a, R=R, E_plane=1.0)) for a in PATCHES)
    assert approach(disc, a=PATCHES, nu=nu) == pytest.approx(exact, rel=1e-9)


def made(size=1.0, R_ed=26.23e-3, b=4e-3, r_i=4.02e-3):
    sprag = LogSprag.from_wedge_angle(
        nu_0=0.055, R_i=size * 11.11e-3, R_e=size * 19.44e-3, r_i=size * r_i
    )
    return ElasticSpragClutch(
        SpragClutchParts(sprag=sprag, n_s=12, l=size * 9e-3, b=size * b, R_id=size * 7.21e-3,
              R_ed=size * R_ed, E=206e9, nu=0.3)
    )  # fmt: skip


def test_a_clutch_twice_as_large_under_four_times_the_force_has_equal_strains():
    small, large = made(), made(size=2.0)
    for kind in ("clutch", "plane"):
        one, other = wedged(getattr(small, kind), 3000.0), wedged(getattr(large, kind), 12000.0)
        assert float(other.yields.H) == pytest.approx(2 * float(one.yields.H), rel=1e-6)
        assert float(other.alpha_b) == pytest.approx(float(one.alpha_b), rel=1e-6)
    assert large.rolls_over_at == pytest.approx(8 * small.rolls_over_at, rel=1e-5)


def test_beyond_a_flank_there_is_no_outline():
    whole = COLUMN
    assert 0.4 < whole.turned < 0.6
    assert 0.4 < whole.alpha_b < 0.6
    assert whole.stands(turned=0.999 * whole.turned, alpha_b=0.0)
    assert whole.outline(turned=1.001 * whole.turned, alpha_b=0.0) is None
    assert whole.outline(turned=0.0, alpha_b=1.001 * whole.alpha_b) is None


def test_a_sprag_wider_than_it_is_round_stands_for_a_disc_and_never_rolls_over():
    wide = made(r_i=6e-3, b=5e-3)
    assert wide.column is None
    assert wide.rolls_over_at == np.inf
    assert np.isfinite(float(wedged(wide.clutch, 3000.0).yields.H))

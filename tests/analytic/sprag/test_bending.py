"""Bending of a wedged sprag: beams, discs, rolling, a spiral's cubic gap."""

import numpy as np
import pytest

from analytic.sprag.bending import Ends, ends, shift
from analytic.sprag.closure import wedged
from analytic.sprag.clutch import Clutch
from analytic.sprag.column import Column
from analytic.sprag.compliance import Compliance
from analytic.sprag.geometry import LogSprag

SPRAG = LogSprag.from_wedge_angle(nu_0=np.radians(3.15), R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3)
A = (1e-4, 1e-4)
RIGID = Clutch(sprag=SPRAG, n_s=12, compliance=Compliance(
    contact_i=np.zeros_like, contact_e=np.zeros_like, race_i=0.0, race_e=0.0, sprag=0.0,
))  # fmt: skip


def bent(b, turned, a=A):
    return ends(Column(sprag=SPRAG, b=b), turned=turned, alpha_b=turned, a=a, nu=0.3)


def beam(b, turned):
    """Psi over P/E' of the ends of a beam under forces e beside its middle, P e h/(4 E' I)."""
    h, e = 8.33e-3, 4.16e-3 * turned
    return e * h / 4 / (b**3 / 12)


def test_the_ends_of_a_slender_column_turn_as_those_of_a_beam():
    """Shorter by a part of its width at either end; the turn goes with the length squared."""
    turned, widths = 0.04, np.array([0.8e-3, 1.2e-3, 1.6e-3])
    roots = [
        np.sqrt(np.mean(np.subtract(bent(b, turned).turned, bent(b, 0.0).turned)) / beam(b, turned))
        for b in widths
    ]
    _, shorter, slender = np.polyfit(widths, roots, 2)
    assert slender == pytest.approx(1.0, abs=0.1)
    assert -1.5 < shorter * 8.33e-3 / 2 < 0


def test_ends_turn_as_far_as_their_contacts_leave_the_middle_and_not_beyond_a_flank():
    once, twice, none = (np.array(bent(4e-3, t).turned) for t in (0.05, 0.1, 0.0))
    assert np.all(twice > once)
    assert twice - none == pytest.approx(2 * (once - none), rel=0.25)
    assert bent(4e-3, 0.6) is None


def test_a_column_that_turns_about_the_axis_as_a_whole_changes_no_force():
    at, column = wedged(RIGID, 1.0), Column(sprag=SPRAG, b=4e-3)
    OA, OB = float(at.OA), float(at.OB)
    whole = Ends(moved=(-OA, -OB), turned=(1.0, 1.0))
    got = shift(at, whole, column=column, a=(0.0, 0.0), P=1e-3, races=(0.0, 0.0))
    assert abs(got.whole) < 1e-12 * got.size


def test_a_race_that_moves_along_with_its_end_leaves_the_contact_where_it_is():
    at, column = wedged(RIGID, 1.0), Column(sprag=SPRAG, b=4e-3)
    moved = Ends(moved=(1.0, -1.0), turned=(0.0, 0.0))
    got = shift(at, moved, column=column, a=(0.0, 0.0), P=1e-6, races=(1e-6, 1e-6))
    assert abs(got.whole) < 1e-12 * got.size


def test_the_centre_of_pressure_of_a_cubic_gap_is_that_of_its_integral_equation():
    """Slope s/R - m s²/(2 r²) on a patch about c, pressure by the finite Hilbert transform."""
    at, column = wedged(RIGID, 1.0), Column(sprag=SPRAG, b=4e-3)
    none = Ends(moved=(0.0, 0.0), turned=(0.0, 0.0))
    a, m = 5e-5, float(SPRAG.m)
    got = shift(at, none, column=column, a=(a, a), P=0.0, races=(0.0, 0.0))
    r, OA = float(at.rho) * np.hypot(1, m), float(at.OA)
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
    assert got.spiral == pytest.approx(centre / OA / float(at.beta), rel=1e-4)


@pytest.mark.parametrize("end", [0, 1])
def test_an_end_that_rolls_is_touched_on_the_line_through_the_axis_and_its_centre(end):
    """A circle on a disc, or in a bore: beside the point that it has touched with, moved as well.

    Turned by psi where it touches, its centre moves by r psi; moved by u, by u.
    """
    at, column = wedged(RIGID, 1.0), Column(sprag=SPRAG, b=4e-3)
    psi, u, P = 2.0, 0.3, 1e-6
    one = np.eye(2)[end]
    bent_end = Ends(moved=tuple(u * one), turned=tuple(psi * one))
    got = shift(at, bent_end, column=column, a=(0.0, 0.0), P=P, races=(0.0, 0.0))
    race = float((at.OA, at.OB)[end])
    r = float((np.asarray(at.rho * np.hypot(1, SPRAG.m)), np.asarray(SPRAG.r_e))[end])
    centre = race + r if end == 0 else race - r  # its distance from the axis
    turned = P * psi * r / centre
    moved = P * u / centre - P * u / race  # of the contact, but for the point itself
    sign = -1.0 if end == 0 else 1.0
    assert got.turned * float(at.beta) == pytest.approx(-turned, rel=1e-12)
    assert got.moved * float(at.beta) == pytest.approx(-sign * moved, rel=1e-12)

"""Laws of one contact, pressures along crowned sprags, races as rings."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact import crown, slices
from analytic.contact.hertz_line_approach import approach_to_depth
from analytic.ring import rotating
from analytic.sprag import pressure
from analytic.sprag.closure import wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.crowned import Crowned, mid, stiffness
from analytic.sprag.laws import plane_law, sliced_law
from analytic.sprag.race_stress import hoop, over_smeared
from analytic.sprag.tolerance import slope, wedge_angle_sensitivities
from tests.analytic.sprag.models import PARTS, SPRAG

N = np.geomspace(1.0, 1e4, 60)


@pytest.fixture
def contact(parts):
    """A crowned inner contact, 41 slices."""
    length, E_star = 9e-3, float(parts.E_star)
    y = crown.slice_centres(length=length, slices=41)
    gap = crown.logarithmic(
        y, K_1=1.0, K_2=0.7, z_m=1e-5, load=3407.0, length=length, E_star=E_star
    )
    return gap, {"R": float(parts.R_contact_i), "E_star": E_star}


def test_slices_are_met_between_their_loads_from_none_to_the_largest(contact):
    gap, body = contact
    law = sliced_law(gap, l=9e-3, N_max=1e4, **body)
    exact = slices.press_slices(gap - gap.min(), length=9e-3, load=N, **body).approach
    assert law(N) == pytest.approx(exact, rel=2e-3)
    assert law(np.array(1e4)) == pytest.approx(exact[-1], rel=1e-12)
    # they grow from nothing and end at their largest load
    assert law(np.array([0.0, np.nan, 1.01e4])).tolist() == pytest.approx(
        [0.0, np.nan, np.nan], nan_ok=True
    )
    way = law(np.geomspace(1e-6, 1e4, 500))
    assert np.all(np.diff(way) > 0)


CONTACT = {"length": 9e-3, "R": 2.95e-3, "E_star": 113.2e9}  # the inner contact of Huang 2018
PRESSURE_N = np.array([0.0, 50.0, 900.0, 3407.0, 6238.0, 5000.0])


def test_the_largest_pressure_is_that_of_slices_solved_at_each_load():
    y = crown.slice_centres(length=9e-3, slices=41)
    gap = crown.logarithmic(y, K_1=1, K_2=0.7, z_m=0.01e-3, load=3407, length=9e-3, E_star=113.2e9)
    p = pressure.along(PRESSURE_N, gap, **CONTACT)
    exact = slices.press_slices(gap, load=PRESSURE_N[1:], **CONTACT).peak_pressure
    assert p.shape == (6, 41)
    assert np.all(p[0] == 0)
    np.testing.assert_allclose(p[1:].max(axis=1), exact.max(axis=1), rtol=2e-3)
    assert np.abs(p[1:] - exact).max() < 0.05 * exact.max()


ONE = Crowned(
    PARTS, SpragClutch(sprag=SPRAG, n_s=12, compliance=PARTS.plane()), np.zeros(21), N_top=2e4
)  # fmt: skip


def test_the_outer_flank_lies_in_its_bore():
    """A circle in a larger one: their curvatures' difference, and Hertz's pressure of it."""
    now = wedged(ONE.clutch, 3000.0)
    R = ONE.radii(now)[1]
    curvature = 1 / float(SPRAG.r_e) - 1 / 19.44e-3
    assert R * curvature == pytest.approx(1.0, rel=1e-12)
    hertz = np.sqrt(float(now.N_e) / 9e-3 * float(PARTS.E_star) / (np.pi * R))
    outer = ONE.pressed(3000.0)[1]
    assert 0.95 * hertz < mid(outer) < hertz < outer.peak_pressure.max()


def test_the_plane_law_adds_the_approaches_of_both_bodies():
    body = {"E": 200e9, "nu": 0.3}
    law = plane_law(l=2.0, r=1.0, R=-2.0, depth_sprag=0.5, depth_race=0.7, **body)
    P, R = 1e4 / 2.0, 2.0
    a = np.sqrt(4 * P * R / (np.pi * 200e9 / 0.91 / 2))
    each = [approach_to_depth(d, P=P, a=a, assumption="plane strain", **body) for d in (0.5, 0.7)]
    assert float(law(np.array(1e4))) == pytest.approx(sum(map(float, each)), rel=1e-12)
    assert float(law(np.array(0.0))) == 0.0


def test_hoop_stresses_balance_the_pressure_on_a_race():
    """Their mean over the wall is pressure times radius over thickness; the largest is more."""
    found = hoop(PARTS, 3000.0, 3000.0)
    mean = 12 * 3000.0 / (2 * np.pi * 9e-3) / (26.23e-3 - 19.44e-3)
    assert found["s_e"] > mean > 0 > found["s_i"] > found["s_id"]
    assert found["Tresca_i"] == -found["s_id"]


def test_speed_makes_the_outer_race_grow_by_eq_8(parts):
    bore = rotating.radial_displacement(
        19.44e-3, r_i=19.44e-3, r_o=26.23e-3, rho=7850.0, omega=1000.0, E=206e9, nu=0.3,
        assumption="plane stress",
    )  # fmt: skip
    assert float(replace(parts, omega=1000.0).palmgren().yields(1.0).d_ce) == float(bore)
    assert float(parts.palmgren().yields(1.0).d_ce) == 0.0


def test_a_torque_of_a_pressure_has_it_and_stiffness_grows_with_the_load():
    T = ONE.torque_at(2.5e9, 0)
    N = 2e4 * np.linspace(0.01, 1, 400)
    force = float(np.interp(T, wedged(ONE.clutch, N).T, N))
    assert ONE.peaks(force)[0] == pytest.approx(2.5e9, rel=1e-4)
    assert ONE.torque_at(1e12, 0) == np.inf
    assert stiffness(ONE.clutch, 6000.0) > stiffness(ONE.clutch, 1000.0) > 0


def test_slopes_of_the_wedge_angle_are_its_derivatives():
    exact = wedge_angle_sensitivities(SPRAG)
    assert slope(SPRAG, "dR_i")[0] == pytest.approx(float(exact.R_i), rel=1e-5)


def test_a_race_of_many_sprags_deflects_as_a_smeared_one():
    many = replace(PARTS, n_s=60, b=0.5e-3)
    for loaded in ("rim", "bore"):
        few, more = (abs(over_smeared(p, 1e-4, loaded) - 1) for p in (PARTS, many))
        assert more < few


def test_a_centroid_given_along_one_axis_is_where_it_was_along_the_other(clutch):
    x, y = clutch.centroid
    assert replace(clutch, c_x=1e-3).centroid == (1e-3, y)
    assert replace(clutch, c_y=1e-3).centroid == (x, 1e-3)

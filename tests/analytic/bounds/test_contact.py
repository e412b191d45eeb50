"""Bounds of contacts contain the values of finite bodies, and exclude a wrong formula."""

import numpy as np
import pytest

from analytic.bounds.contact import point, roller
from analytic.bounds.contact.line import OnFlat
from analytic.bounds.contact.line_bodies import InRace, OfDiscs
from analytic.contact import disc_stress, hertz_line_stress, hertz_point, sphere_series
from analytic.contact.disc import disc_in_contact

LIKE = {"E_1": 2.0, "nu_1": 0.3, "E_2": 2.0, "nu_2": 0.3}
UNLIKE = LIKE | {"E_2": 5.0, "nu_2": 0.2}


def holds(estimate, error):
    return abs(error - estimate.error) <= estimate.slack


@pytest.mark.parametrize("a", [0.02, 0.05, 0.1, 0.2])
def test_the_error_of_hertz_for_a_disc_on_a_flat_is_within_the_bounds(a):
    disc = disc_in_contact(a=a, R=1.0, E_plane=1.0)
    width = np.sqrt(4 * disc.P / np.pi)
    known = OnFlat(width)
    assert holds(known.pressure, 2 * disc.P / (np.pi * width) / disc.p_0 - 1)
    assert holds(known.width, width / disc.moment_width - 1)
    approach = disc.P / np.pi * (2 * np.log(4 / width) - 1)
    assert holds(known.approach, approach / disc.approach - 1)
    tau, _ = hertz_line_stress.largest_shear_stress(a=width, p_0=2 * disc.P / (np.pi * width))
    exact, _ = disc_stress.largest_shear_stress(disc=disc)
    assert holds(known.shear, float(tau) / exact - 1)


def test_the_error_of_hertz_for_spheres_is_the_first_correction():
    ball = sphere_series.Sphere(R=1.0, E=0.75, nu=0.3)
    flat = sphere_series.Sphere(R=np.inf, E=np.inf, nu=0.0)
    found = sphere_series.pressed_spheres(ball, flat, P=1e-4)
    hertz = {"P": 1e-4, "R": 1.0, "E_star": 1 / ball.softness}
    a = float(hertz_point.radius(**hertz))
    known = point.corrected(found.a_excess, beyond=a**2)
    assert holds(known, a / found.a - 1)
    assert not holds(known, 1.01 * a / found.a - 1)
    assert point.corrected(0.1, beyond=0.01, power=1.5).slack == pytest.approx(0.015)
    assert point.axis_shear(beyond=0.01) == (0.0, pytest.approx(0.1))


STRIPS = {"value": 1.0, "twice": 1.001, "b": 0.01, "length": 1.0}


def test_the_error_of_strips_is_half_to_twice_their_estimate():
    low, high = roller.of_strips(4e-3, **STRIPS, loaded=False, user_inputs=False)
    cut = 2 * 1e-3 + 1e-4
    assert (low, high) == (pytest.approx(-8e-3 - cut), pytest.approx(-2e-3 + cut))
    assert roller.of_strips(4e-3, **STRIPS, loaded=True, user_inputs=False)[0] > low


def test_the_local_pressure_is_hertz_s_of_a_long_slender_contact():
    low, high = roller.local_pressure(b=1e-6, R=1.0, length=1.0)
    assert (low, high) == (pytest.approx(-1e-3), pytest.approx(1e-3))
    assert roller.local_pressure(b=0.1, R=1.0, length=1.0)[1] > 0.05


def test_what_unlike_materials_couple_counts_with_either_sign():
    """Of equal E' beta = 1/12 by (1 - 2 nu)/(1 - nu) of 2/3 and 1, kappa = 1/4: 1e-3 together."""
    like = {"E_1": 15 / 16, "nu_1": 0.25, "E_2": 1.0, "nu_2": 0.0}
    turned = {"E_1": 1.0, "nu_1": 0.0, "E_2": 15 / 16, "nu_2": 0.25}
    for materials in (like, turned):
        pair = OfDiscs(a=0.048, R_1=1.0, R_2=2.0, **materials)
        catalan = 0.9159655941772190
        both = 1e-3 * (2 * catalan - 1 / 3 + 64 / 45) / np.pi
        assert pair.coupled == pytest.approx(both, rel=1e-12)


def test_the_bound_of_two_discs_does_not_depend_on_their_order():
    below = {"E_1": UNLIKE["E_2"], "nu_1": UNLIKE["nu_2"], "E_2": UNLIKE["E_1"],
             "nu_2": UNLIKE["nu_1"]}  # fmt: skip
    one = OfDiscs(a=0.1, R_1=1.0, R_2=3.0, **UNLIKE).bounded
    other = OfDiscs(a=0.1, R_1=3.0, R_2=1.0, **below).bounded
    for estimate, same in zip(one, other, strict=True):
        assert estimate == pytest.approx(same, rel=1e-12)
    assert OfDiscs(a=0.1, R_1=3.0, R_2=1.0, **below).e == 0.1  # over the smaller radius
    like = OfDiscs(a=0.1, R_1=1.0, R_2=3.0, **LIKE).bounded
    assert [estimate.slack for estimate in like] == pytest.approx([0.1**4 / 8] * 2)


def test_equal_discs_of_like_material_are_discs_on_a_flat():
    pair, flat = OfDiscs(a=0.01, R_1=1.0, R_2=1.0, **LIKE), OnFlat(0.01)
    assert pair.coupled == 0
    for one, other in ((pair.pressure, flat.pressure), (pair.width, flat.width)):
        assert one.error == pytest.approx(other.error, abs=other.slack)
    assert pair.shear.error == pytest.approx(flat.shear.error, rel=1e-12)


def test_unlike_materials_couple_with_opposite_signs_in_a_race_and_a_thin_wall_widens():
    race = InRace(a=0.01, R_1=1.0, R_2=-3.0, wall=5.0, **UNLIKE)
    assert race.coupled != 0
    assert race.pressure.error * race.width.error < 0
    like = InRace(a=0.01, R_1=1.0, R_2=-3.0, wall=5.0, **LIKE)
    assert like.pressure == (0.0, like.small)
    thick, thin = (InRace(a=0.01, R_1=1.0, R_2=-3.0, wall=w, **LIKE) for w in (5.0, 0.1))
    assert thin.pressure.slack > 50 * thick.pressure.slack
    assert thin.approach.slack > 50 * thick.approach.slack


def test_coupling_of_either_sign_widens_the_bound_of_the_approach_in_a_race():
    """Of equal E' beta is 1/12 with either sign; kappa is (1 + 1/3)/2 in a bore of three radii."""
    first, second = {"E_1": 15 / 16, "nu_1": 0.25}, {"E_2": 1.0, "nu_2": 0.0}
    turned = {"E_1": 1.0, "nu_1": 0.0, "E_2": 15 / 16, "nu_2": 0.25}
    races = [InRace(a=0.018, R_1=1.0, R_2=-3.0, wall=2.0, **pair)
             for pair in (first | second, turned)]  # fmt: skip
    assert races[0].coupled * races[1].coupled < 0
    for race in races:
        half = (0.018**2 + 0.009**2) / 2
        assert race.approach == (0.0, pytest.approx(half + 0.018 / 18, rel=1e-12))


@pytest.mark.parametrize("change", [{"b": 0.04}, {"twice": 1.01}, {"value": 0.0}])
def test_user_inputs_beyond_the_expansion_have_no_interval(change):
    for half_width in (0.01, 0.029):  # slender: up to 0.03 of the length
        slender = STRIPS | {"b": half_width}
        assert roller.of_strips(1e-4, **slender, loaded=False, user_inputs=True)
    assert roller.of_strips(1e-4, **STRIPS | change, loaded=False, user_inputs=True) is None
    assert roller.of_strips(np.nan, **STRIPS, loaded=False, user_inputs=False) is None

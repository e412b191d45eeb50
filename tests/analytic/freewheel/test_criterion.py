"""Required friction, the couple that the criterion omits, and load paths of the test rig."""

import numpy as np
import pytest

from analytic.freewheel import criterion, state, tilt
from analytic.freewheel.course import follow
from analytic.freewheel.load_path import AxialRamp, BothAlternating

ALPHA = np.radians(3.5)
CLUTCH = {"alpha": ALPHA, "R": 16.5e-3}


def forces(T, F_ax, z=8):
    """Of one contact: F_t from the torque, F_n from the clamping angle, F_ax shared."""
    F_t = T / (z * CLUTCH["R"])
    return {"F_t": F_t, "F_n": F_t / np.tan(ALPHA), "F_a": F_ax / z}


def test_the_clamping_angle_is_not_the_quotient_of_the_forces_but_its_arctangent():
    """Text after Eq. 1."""
    quotient = forces(20.0, 0.0)["F_t"] / forces(20.0, 0.0)["F_n"]
    assert quotient == pytest.approx(0.06116, abs=5e-6)
    assert np.arctan(quotient) == pytest.approx(ALPHA, rel=1e-12)
    assert quotient != pytest.approx(ALPHA, rel=1e-3)


def test_at_equality_the_clutch_holds_and_is_green():
    """Eq. 10 as printed, mu_req < mu, would have it slip."""
    mu = float(criterion.required_friction(T=20.0, F_ax=600.0, **CLUTCH))
    assert criterion.safety(mu=mu, mu_req=mu) == 1
    assert criterion.traffic_light(1.0) == "green"
    assert not criterion.self_releasing(alpha=np.arctan(0.1), mu=np.tan(np.arctan(0.1)))


def test_an_axial_load_changes_eq_8_and_not_eq_1():
    """At slip under a growing axial load it is Eq. 8 that is no longer fulfilled."""
    mu, F_ax = 0.1, np.array([0.0, 3000.0])
    asked = criterion.required_friction(T=20.0, F_ax=F_ax, **CLUTCH)
    assert (asked <= mu).tolist() == [True, False]
    assert not criterion.self_releasing(alpha=ALPHA, mu=mu)  # Eq. 1, at either load


@pytest.mark.parametrize(
    ("T", "F_ax", "expected"),
    [(0.0, 0.0, np.tan(ALPHA)), (0.0, 5.0, np.inf), (-3.0, 5.0, np.nan), (-3.0, 0.0, np.nan)],
)
def test_without_locking_torque_the_criterion_is_infinite_or_silent(T, F_ax, expected):
    found = float(criterion.required_friction(T=T, F_ax=F_ax, **CLUTCH))
    assert found == pytest.approx(expected, nan_ok=True)


def test_the_offset_balances_the_couple_of_the_axial_forces():
    """Both resultants along the chord, 2 e from each other, against F_a at its ends."""
    r, F_a, F_n = 2.5e-3, 40.0, 900.0
    e = float(tilt.offset(F_a=F_a, F_n=F_n, r=r, alpha=ALPHA))
    resultant, chord = F_n / np.cos(ALPHA), 2 * r * np.cos(ALPHA)
    assert resultant * 2 * e == pytest.approx(F_a * chord, rel=1e-13)


@pytest.mark.parametrize("e", [0.0, 0.5, 1.6, 2.0, 4.0])
def test_the_linear_line_load_carries_force_and_moment(e):
    L = 10.0
    peak = float(tilt.peak_factor(e=e, L=L))  # of the mean load 1
    assert float(tilt.pressure_factor(e=e, L=L)) == pytest.approx(np.sqrt(peak), rel=1e-14)
    z = np.linspace(-L / 2, L / 2, 200001)
    length = L if e <= L / 6 else 3 * (L / 2 - e)
    low = 2 - peak if e <= L / 6 else 0.0
    q = np.where(z > L / 2 - length, low + (peak - low) * (z - L / 2 + length) / length, 0.0)
    assert np.trapezoid(q, z) == pytest.approx(L, rel=1e-4)
    assert np.trapezoid(q * z, z) == pytest.approx(e * L, abs=1e-3)


RAMP = AxialRamp(T=20.0, F=3000.0, rise=1.0, duration=3.0)


def test_a_ramp_needs_most_friction_at_its_end_and_slips_at_the_largest_axial_load(star):
    course = follow(star, RAMP, mu=0.1)
    now = state.loaded(star, 20.0)
    worst = criterion.required_friction(alpha=now.alpha, T=20.0, F_ax=3000.0, R=16.5e-3)
    assert course.when == 3
    assert course.peak == pytest.approx(float(worst), rel=1e-12)
    held = criterion.largest_axial_load(alpha=now.alpha, T=20.0, R=16.5e-3, mu=0.1)
    assert RAMP.axial_load(course.slips_at) == pytest.approx(float(held), abs=2.0)
    assert course.light == "red"


@pytest.mark.parametrize("ulp", [-4, 0, 4])
def test_the_end_of_a_half_cycle_is_locked_whatever_the_last_bits_of_its_time(cup, ulp):
    """The torque of an outer cam's most demanding time is zero but for the sine of half a turn."""
    path = BothAlternating(T=10.0, F=500.0, frequency=1.0, duration=1e3)
    t = 500 + np.array([0.25, 0.49, 0.5 + ulp * np.spacing(500.5)])
    course = follow(cup, path, mu=0.1, t=t)
    limit = np.tan(float(cup.cam.alpha0)) * np.hypot(1, 50.0 * 0.5005 * cup.cam.race)
    assert course.when == t[-1]
    assert course.peak == pytest.approx(float(limit), rel=1e-9)


def test_torque_that_crosses_zero_under_axial_load_needs_infinite_friction(star):
    crossing = BothAlternating(T=20.0, F=3000.0, frequency=3.0, duration=10.0, T_m=10.0)
    lifted = BothAlternating(T=20.0, F=3000.0, frequency=3.0, duration=10.0, T_m=21.0)
    course = follow(star, crossing, mu=0.1)
    assert course.peak == np.inf
    assert course.light == "red"
    assert np.all(course.T[np.isinf(course.mu_req)] > 0)  # of locked times alone
    assert np.isfinite(follow(star, lifted, mu=0.1).peak)

"""The rig's three load cases: loads over time, and the friction that they ask for."""

import numpy as np
import pytest

from analytic.freewheel import criterion, state
from analytic.freewheel.course import follow
from analytic.freewheel.load_path import AlternatingAxial, AxialRamp, BothAlternating

RAMP = AxialRamp(T=20.0, F=3000.0, rise=1.0, duration=3.0)
ALTERNATING = AlternatingAxial(T=20.0, F=3000.0, rise=1.0, duration=11.0, frequency=3.0)
BOTH = BothAlternating(T=20.0, F=3000.0, frequency=3.0, duration=10.0)


def test_the_axial_load_waits_for_the_torque():
    for path in (RAMP, ALTERNATING):
        assert float(path.torque(1.0)) == 20
        assert np.all(path.axial_load(np.linspace(0, 1, 9)) == 0)


def test_an_alternating_load_grows_from_peak_to_peak():
    t = 1 + (np.arange(30) + 0.25) / 3.0
    peaks = ALTERNATING.axial_load(t)
    np.testing.assert_allclose(np.diff(peaks), 3000 / 10 / 3, rtol=1e-9)


def test_in_phase_both_loads_pass_through_zero_together():
    t = np.linspace(0.01, 9.99, 777)
    assert np.all(BOTH.torque(t) * BOTH.axial_load(t) >= 0)
    np.testing.assert_allclose(BOTH.ratio(t) * BOTH.torque(t), BOTH.axial_load(t), rtol=1e-9)


def test_the_ramp_asks_most_at_its_end_and_slips_where_the_axial_load_is_the_largest(star):
    course = follow(star, RAMP, mu=0.1)
    now = state.loaded(star, 20.0)
    worst = criterion.required_friction(alpha=now.alpha, T=20.0, F_ax=3000.0, R=16.5e-3)
    assert course.when == 3
    assert course.peak == pytest.approx(float(worst), rel=1e-12)
    held = criterion.largest_axial_load(alpha=now.alpha, T=20.0, R=16.5e-3, mu=0.1)
    assert RAMP.axial_load(course.slips_at) == pytest.approx(float(held), abs=2.0)
    assert course.light == "red"


def test_on_the_ramp_the_torque_alone_asks_for_its_clamping_angle(star):
    course = follow(star, RAMP, mu=0.1, t=np.linspace(0, 1, 11))
    np.testing.assert_allclose(course.mu_req, np.tan(course.alpha), rtol=1e-14)
    assert course.slips_at == np.inf
    assert course.light == "green"


def test_a_sampled_peak_is_close_to_that_of_finer_times(star):
    coarse = follow(star, ALTERNATING, mu=0.1).peak
    fine = follow(star, ALTERNATING, mu=0.1, t=np.linspace(10.5, 11, 20001)).peak
    assert coarse == pytest.approx(fine, rel=5e-4)


def test_in_phase_overrunning_half_cycles_ask_for_nothing(star):
    course = follow(star, BOTH, mu=0.1)
    np.testing.assert_array_equal(np.isnan(course.mu_req), course.T < 0)


def test_as_torque_vanishes_in_phase_the_limit_is_that_of_the_amplitudes_ratio(star):
    """Alpha goes to alpha_0 and F_ax/T stays: mu_req is finite at T = 0 and continuous."""
    t = 1 / 3 * np.array([6, 6 + 1e-7])
    at, after = follow(star, BOTH, mu=0.1, t=t).mu_req
    ratio = 3000.0 / 20.0 * t[0] / 10
    limit = np.tan(float(star.cam.alpha0)) * np.hypot(1, ratio * 16.5e-3)
    assert at == pytest.approx(limit, rel=1e-6)
    assert after == pytest.approx(at, rel=1e-4)


def test_an_inner_cam_asks_most_at_the_torque_s_peak_and_an_outer_one_at_its_rise(star, cup):
    path = BothAlternating(T=10.0, F=500.0, frequency=1.0, duration=1e3)
    half = 500 + np.linspace(1e-6, 0.5, 101)  # the amplitude hardly grows within it
    inner, outer = follow(star, path, mu=0.1, t=half), follow(cup, path, mu=0.1, t=half)
    assert inner.when == pytest.approx(500.25, abs=0.02)
    assert not 500.05 < outer.when < 500.45


def test_torque_that_crosses_zero_under_axial_load_asks_for_infinite_friction(star):
    crossing = BothAlternating(T=20.0, F=3000.0, frequency=3.0, duration=10.0, T_m=10.0)
    lifted = BothAlternating(T=20.0, F=3000.0, frequency=3.0, duration=10.0, T_m=21.0)
    course = follow(star, crossing, mu=0.1)
    assert course.peak == np.inf
    assert course.light == "red"
    assert np.all(course.T[np.isinf(course.mu_req)] > 0)  # of locked times alone
    assert np.isfinite(follow(star, lifted, mu=0.1).peak)


@pytest.mark.parametrize("ulp", [-4, 0, 4])
def test_the_end_of_a_half_cycle_is_locked_whatever_the_last_bits_of_its_time(cup, ulp):
    """The torque of an outer cam's most demanding time is zero but for the sine of half a turn."""
    path = BothAlternating(T=10.0, F=500.0, frequency=1.0, duration=1e3)
    t = 500 + np.array([0.25, 0.49, 0.5 + ulp * np.spacing(500.5)])
    course = follow(cup, path, mu=0.1, t=t)
    limit = np.tan(float(cup.cam.alpha0)) * np.hypot(1, 50.0 * 0.5005 * cup.cam.race)
    assert course.when == t[-1]
    assert course.peak == pytest.approx(float(limit), rel=1e-9)


@pytest.mark.parametrize("ulp", [-4, 0, 4])
def test_torque_at_zero_under_axial_load_asks_for_infinite_friction(star, ulp):
    """T_m + T sin(7 pi/6) is zero but for round-off where T_m = T/2."""
    path = BothAlternating(T=20.0, F=3000.0, frequency=1.0, duration=10.0, T_m=10.0)
    t = 5 + np.array([0.25, 7 / 12 + ulp * np.spacing(5.5)])
    mu_req = follow(star, path, mu=0.1, t=t).mu_req
    assert np.isfinite(mu_req[0])
    assert mu_req[1] == np.inf


@pytest.mark.parametrize(
    ("make", "rule"),
    [
        (lambda: AxialRamp(T=0.0, F=1.0, rise=1.0, duration=2.0), "torque"),
        (lambda: AxialRamp(T=1.0, F=1.0, rise=2.0, duration=1.0), "rise"),
        (lambda: AlternatingAxial(T=1.0, F=1.0, rise=1.0, duration=2.0, frequency=0.0), "freq"),
        (lambda: BothAlternating(T=1.0, F=-1.0, frequency=1.0, duration=2.0), "axial load"),
    ],
)
def test_paths_that_make_no_sense_are_refused(make, rule):
    with pytest.raises(ValueError, match=rule):
        make()

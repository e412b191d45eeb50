"""Times of slip along the rig's paths, by the definitions of the paths."""

import math

import pytest

from analytic.bounds.freewheel.slip_times import Rig

RIG = Rig(R=16.5e-3, T=26.0, T_m=0.0, T_critical=26.0, F_ax=3000.0, f=30.0, rise=0.1, duration=0.5)


def alike(_):
    """tan(alpha) that no torque changes."""
    return 0.06


@pytest.mark.parametrize("at", [0.35, 0.8])
def test_a_path_reaches_a_load_no_sooner_than_it_grows_to_it(at):
    """A ramp at F = at F_ax; a sine not before, and within half a swing, at its definition."""
    ramp, sine = (RIG.time_of_slip(path, at * RIG.F_ax, alike) for path in (1, 2))
    assert ramp == pytest.approx(RIG.rise + at * (RIG.duration - RIG.rise), rel=1e-12)
    assert ramp <= sine <= ramp + 0.5 / RIG.f
    turn = 2 * math.pi * 30 * (sine - 0.1)
    assert 3000 * (sine - 0.1) / 0.4 * abs(math.sin(turn)) == pytest.approx(3000 * at, rel=1e-9)


@pytest.mark.parametrize(
    ("F", "t"),
    [(1050.0, 0.175), (1150.0, 0.2)],  # grown after 5.25 cycles, and after 5.75: it overruns
)
def test_of_one_angle_the_path_in_phase_slips_as_its_amplitude_has_grown_and_it_locks(F, t):
    assert RIG.time_of_slip(3, F, alike) == pytest.approx(t, abs=1e-9)


def test_a_path_that_never_reaches_the_load_has_no_time_of_slip():
    assert all(RIG.time_of_slip(path, 1.1 * RIG.F_ax, alike) == math.inf for path in (1, 2, 3))


def test_the_line_through_two_frictions_has_their_angles():
    lever = RIG.R * RIG.F_ax / RIG.T
    tan = RIG.tangent((1.0, 0.5), (0.07 * math.hypot(1, lever), 0.06 * math.hypot(1, lever)))
    assert [tan(T) for T in (26.0, 13.0, 19.5)] == pytest.approx([0.07, 0.06, 0.065], rel=1e-12)

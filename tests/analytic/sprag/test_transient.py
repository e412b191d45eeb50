"""Engagements against closed forms: energy, statics, frequency, friction's limit, order."""

import math
from dataclasses import replace
from time import perf_counter

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from analytic.sprag.balance import balance
from analytic.sprag.closure import at_torque
from analytic.sprag.course import energy, rolled
from analytic.sprag.history import Phase
from analytic.sprag.motion import Speeds, Torque
from analytic.sprag.steps import missing
from analytic.sprag.table import tabulated
from analytic.sprag.transient import engage

QUIET = {"C_rl": 0.0, "k_out": 1e7}  # an outer race that hardly moves


def test_without_damping_the_first_peak_is_where_the_torque_s_work_is_stored(
    engaged, table, motion
):
    """C theta_i + work of the blades = n_s W, rolling: theta_i' = (b_e/OB + b_i/OA) alpha'."""
    run = engaged(25.0, **QUIET)

    def power(alpha):
        g = table.at(alpha)
        blades = motion.K_r * (motion.alpha_max - alpha) * (1 - g["b_e"] / g["OB"])
        driven = 25.0 * (g["b_e"] / g["OB"] + g["b_i"] / g["OA"])
        return float(driven + 12 * (blades - g["N"] * g["h"]))

    top = brentq(lambda a: quad(power, run.alpha[0], a, epsrel=1e-9)[0], 0.1, 0.6)
    assert run.first_peak[1] == pytest.approx(float(table.at(top)["N"]), rel=5e-6)
    assert run.N_max == run.first_peak[1]


def test_the_first_peak_is_that_of_the_struts_own_energy(engaged, clutch):
    """C theta = n_s U without blades worth the name; N_e = N_i and a first slip: 2e-4."""
    run = engaged(25.0, **QUIET, K_r=1e-5, mu_s=0.9, mu_c=0.9)
    N = brentq(lambda N: float(25.0 * rolled(clutch, N) - 12 * energy(clutch, N)), 4e3, 12e3)
    assert run.first_peak[1] == pytest.approx(N, rel=5e-4)


def test_heavy_damping_ends_at_the_static_force(engaged, clutch):
    """Blades of Table 1 would add 0.3 % to it, as they help to press."""
    run = engaged(25.0, duration=0.3, dt=2e-5, C_rl=3.0, K_r=1e-4)
    assert run.verdict == "locks"
    assert run.N[-1] == pytest.approx(float(at_torque(clutch, 25.0).N), rel=1e-3)
    assert run.N[-1] == pytest.approx(run.N_static, rel=2e-4)
    assert run.N_max < 1.001 * run.N_static


def test_a_slow_ramp_has_no_peak(engaged):
    run = engaged(Torque.step(25.0, t_ramp=0.2), duration=0.2, dt=2e-5)
    assert run.N_max == pytest.approx(run.N_static, rel=0.02)
    swift = engaged(Torque.step(25.0, t_ramp=0.002), duration=0.02)
    assert run.N_max < swift.N_max < engaged(25.0).N_max


def test_small_oscillations_have_the_frequency_of_torque_over_angle(engaged, table):
    """Both races swing against each other only where the outer one is held: omega² = k/I_bi."""
    steady = float(table.static_torque(0.12))
    torque = Torque(
        times=np.array([0.0, 0.05, 0.0501]), values=np.array([0.0, 1.0, 1.002]) * steady
    )
    run = engaged(torque, duration=0.2, dt=2e-5, C_rl=0.0, k_out=1e6)
    late = run.t > 0.06
    y = run.N[late] - run.N[late].mean()
    rising = np.flatnonzero((y[:-1] < 0) & (y[1:] >= 0))
    crossed = rising - y[rising] / (y[rising + 1] - y[rising])
    period = float(np.polyfit(np.arange(len(crossed)), crossed, 1)[0]) * run.dt
    near = 0.12 + np.array([-1e-4, 1e-4])
    g = table.at(0.12)
    rolling = float(g["b_e"] / g["OB"] + g["b_i"] / g["OA"])
    stiffness = float(np.diff(table.static_torque(near))[0]) / 2e-4 / rolling
    series = 1 / (1 / stiffness + 1 / 1e6)
    assert 2 * np.pi / period == pytest.approx(np.sqrt(series / 1.41e-3), rel=3e-3)


@pytest.mark.parametrize("torque", [25.0, 40.0])
def test_half_the_step_changes_the_peak_by_less_than_1e_4_with_fourth_order(engaged, torque):
    peaks = [engaged(torque, dt=dt, K_r=0.1).N_max for dt in (8e-5, 4e-5, 2e-5, 1e-5, 5e-6)]
    steps = np.abs(np.diff(peaks))
    assert steps[-1] < 1e-6 * peaks[-1]
    assert steps[0] / steps[1] > 3.5  # the parabola through the peak is of lower order


@pytest.mark.parametrize("other", [QUIET, {}, {"alpha_max": 0.02, "mu_s": 0.06, "mu_c": 0.05}])
def test_no_work_is_lost(engaged, other):
    run = engaged(25.0, duration=0.06, **other)
    parts = balance(run)
    assert float(np.abs(parts.missing).max()) < 1e-6 * float(parts.torque.max())
    if other.get("C_rl", 1.0) == 0.0:
        assert float(parts.damping.max()) == 0.0
    if "mu_s" in other:
        assert float(parts.friction[-1]) > 1e-4  # J: it slips at the start
        assert np.all(np.diff(parts.friction) > -1e-12)


def test_the_same_engagement_is_the_same_to_the_last_bit(engaged):
    one, two = engaged(25.0), engaged(25.0)
    assert one.states.tobytes() == two.states.tobytes()
    assert one.told.tobytes() == two.told.tobytes()


def test_an_engagement_of_60_ms_takes_well_below_a_tenth_of_a_second(engaged):
    engaged(25.0)
    times = []
    for _ in range(5):
        before = perf_counter()
        engaged(25.0, duration=0.06)
        times.append(perf_counter() - before)
    assert min(times) < 0.1


def slipping(engaged, mu, torque):
    run = engaged(torque, duration=0.25, dt=2e-5, C_rl=1.0, K_r=1e-4, mu_s=mu, mu_c=mu)
    return run.verdict == "slips"


@pytest.mark.parametrize("torque", [10.0, 25.0, 40.0])
def test_it_locks_where_friction_reaches_the_wedge_angle_under_the_load(engaged, clutch, torque):
    """At mu = tan(nu) of the strut under the torque, not of the unloaded one; without blades."""
    low, high = 0.05, 0.06
    assert slipping(engaged, low, torque)
    assert not slipping(engaged, high, torque)
    while high - low > 1e-5:
        mid = (low + high) / 2
        low, high = (mid, high) if slipping(engaged, mid, torque) else (low, mid)
    assert high == pytest.approx(float(np.tan(at_torque(clutch, torque).nu)), rel=1e-3)


def test_a_clutch_that_slips_carries_less_than_its_torque(engaged):
    run = engaged(25.0, duration=0.1, mu_s=0.05, mu_c=0.04)
    assert run.verdict == "slips"
    assert run.N[-1] < 0.5 * run.N_static
    assert run.theta_i[-1] > 1.0


def test_what_ends_before_its_peak_is_not_followed(engaged):
    run = engaged(25.0, duration=0.002)
    assert run.verdict == "not followed"
    assert not run.followed
    assert math.isnan(run.peak_factor)
    assert engaged(25.0, duration=0.01).verdict == "locks"


def test_a_race_that_still_overruns_at_the_end_has_not_engaged(engaged):
    run = engaged(25.0, duration=0.002, speeds=Speeds(inner=-50.0))
    assert run.overruns
    assert run.verdict == "not followed"
    assert not engaged(25.0, duration=0.06, mu_s=0.05, mu_c=0.04).overruns


def test_a_force_that_creeps_up_to_its_value_at_rest_is_followed(engaged):
    run = engaged(25.0, duration=0.06, C_rl=3.0)
    assert int(np.argmax(run.N)) == len(run.N) - 1
    assert run.verdict == "locks"
    assert run.peak_factor == pytest.approx(1.0, abs=5e-3)
    assert engaged(25.0, duration=0.06, C_rl=100.0).verdict == "not followed"


@pytest.mark.parametrize(
    "other",
    [{"dt": 1e-3}, {"dt": 1e-3, "mu_s": 0.05, "mu_c": 0.04}, {"I_bi": 1e-7, "I_be": 1e-7},
     {"k_out": 1e9}],
    ids=str,
)  # fmt: skip
def test_a_step_that_is_too_long_is_refused_with_one_that_will_do(engaged, other):
    with pytest.raises(ArithmeticError, match=r"dt=\S+ s is too long .*; take dt=") as error:
        engaged(25.0, **{"duration": 0.06, **other})
    assert "\n" not in str(error.value)
    shorter = {**other, "dt": error.value.enough, "D_V": None}
    run = engaged(25.0, duration=0.02, **shorter)
    assert missing(run) < 1e-4
    assert run.verdict == ("slips" if "mu_s" in other else "locks")


def test_without_the_guard_a_step_that_is_too_long_gives_a_wrong_answer(engaged):
    assert missing(engaged(25.0, duration=0.06, dt=1e-3, D_V=0.5, guard=False)) > 1


def test_what_energies_miss_is_measured_by_the_speed_at_the_start_as_well(engaged):
    assert missing(engaged(1e-3, duration=0.06, speeds=Speeds(inner=-100.0))) < 1e-4


def test_past_the_profile_nothing_is_told(engaged, table):
    run = engaged(150.0, duration=0.02)
    assert run.verdict == "over the end"
    assert float(run.alpha.max()) <= table.end
    assert run.t[-1] < 0.02


def test_without_blades_or_with_blades_that_hold_off_nothing_engages(engaged):
    assert engaged(25.0, K_r=0.0).verdict == "disengages"
    held_off = engaged(25.0, alpha_max=-0.1)
    assert held_off.verdict == "disengages"
    assert held_off.N_max == 0.0


def test_an_overrunning_race_drags_until_the_torque_has_turned_it_back(engaged):
    run = engaged(25.0, duration=0.06, speeds=Speeds(inner=-20.0))
    first = int(np.argmax(run.states[:, 4] > 0))
    assert np.mean((run.phases[1:first] == Phase.STICK).all(axis=1)) < 0.02
    assert float(run.T_i[1:first].mean()) < 0
    assert run.t[first] == pytest.approx(20.0 * 1.41e-3 / 25.0, rel=0.1)  # I omega = C t
    assert run.verdict == "locks"


def test_a_race_that_arrives_with_speed_strikes_harder(engaged):
    still, fast = engaged(25.0), engaged(25.0, speeds=Speeds(inner=20.0))
    assert fast.N_max > 1.05 * still.N_max


def test_sprags_count_as_often_as_they_are(engaged, clutch, motion):
    """Six under half the torque with half the races have the same history."""
    six = replace(clutch, n_s=6)
    half = replace(
        motion, I_bi=motion.I_bi / 2, I_be=motion.I_be / 2, C_rl=motion.C_rl / 2,
        k_out=motion.k_out / 2,
    )  # fmt: skip
    one = engage(tabulated(six, N_end=20e3), half, Torque.step(12.5), duration=0.01)
    np.testing.assert_allclose(one.N, engaged(25.0).N, rtol=1e-9)
    assert float(at_torque(six, 12.5).N) == pytest.approx(float(at_torque(clutch, 25.0).N))


@pytest.mark.parametrize("wrong", [{"duration": 0.0}, {"dt": -1e-5}, {"D_V": np.nan}])
def test_times_and_bands_that_make_no_sense_are_refused(engaged, wrong):
    with pytest.raises(ValueError, match="must be positive and finite"):
        engaged(25.0, **wrong)


def test_a_step_too_long_for_the_motion_is_refused(engaged):
    with pytest.raises(ArithmeticError, match="dt=1e-05 s is too long"):
        engaged(25.0, k_out=1e10)

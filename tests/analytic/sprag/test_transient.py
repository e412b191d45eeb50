"""Engagements against closed forms and event detection: energy, statics, limit of friction."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from analytic.sprag.balance import balance
from analytic.sprag.closure import at_torque
from analytic.sprag.history import Phase
from analytic.sprag.readings import first_slip, steady
from analytic.sprag.steps import missing

QUIET = {"C_rl": 0.0, "k_out": 1e7}  # an outer race that hardly moves


def test_without_damping_the_first_peak_is_where_the_torque_s_work_is_stored(
    engaged, table, motion
):
    """C theta_i + work of the springs = n_s W, rolling: theta_i' = (b_e/OB + b_i/OA) alpha'."""
    run = engaged(25.0, **QUIET)

    def power(alpha):
        g = table.at(alpha)
        blades = motion.K_r * (motion.alpha_max - alpha) * (1 - g["b_e"] / g["OB"])
        driven = 25.0 * (g["b_e"] / g["OB"] + g["b_i"] / g["OA"])
        return float(driven + 12 * (blades - g["N"] * g["h"]))

    top = brentq(lambda a: quad(power, run.alpha[0], a, epsrel=1e-9)[0], 0.1, 0.6)
    assert run.first_peak[1] == pytest.approx(float(table.at(top)["N"]), rel=5e-6)
    assert run.N_max == run.first_peak[1]


def test_heavy_damping_ends_at_the_static_force(engaged, clutch):
    """Energizing springs of Table 1 would add 0.3 % to it, as they press as well."""
    run = engaged(25.0, duration=0.3, dt=2e-5, C_rl=3.0, K_r=1e-4)
    assert run.verdict == "locks"
    assert run.N[-1] == pytest.approx(float(at_torque(clutch, 25.0).N), rel=1e-3)
    assert run.N[-1] == pytest.approx(run.N_static, rel=2e-4)
    assert run.N_max < 1.001 * run.N_static


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


def slipping(engaged, mu, torque):
    run = engaged(torque, duration=0.25, dt=2e-5, C_rl=1.0, K_r=1e-4, mu_s=mu, mu_c=mu)
    return run.verdict == "slips"


@pytest.mark.parametrize("torque", [10.0, 40.0])
def test_it_locks_where_friction_reaches_the_wedge_angle_under_the_load(engaged, clutch, torque):
    """At mu = tan(nu) of the strut under the torque, not of the unloaded one; without springs."""
    low, high = 0.05, 0.06
    assert slipping(engaged, low, torque)
    assert not slipping(engaged, high, torque)
    while high - low > 1e-5:
        mid = (low + high) / 2
        low, high = (mid, high) if slipping(engaged, mid, torque) else (low, mid)
    assert high == pytest.approx(float(np.tan(at_torque(clutch, torque).nu)), rel=1e-3)


@pytest.mark.parametrize(
    "other",
    [{"dt": 1e-3}, {"dt": 1e-3, "mu_s": 0.05, "mu_c": 0.04}, {"I_bi": 1e-7, "I_be": 1e-7}],
    ids=str,
)
def test_a_step_that_is_too_long_is_refused_with_one_that_will_do(engaged, other):
    with pytest.raises(ArithmeticError, match=r"dt=\S+ s is too long .*; take dt=") as error:
        engaged(25.0, **{"duration": 0.06, **other})
    assert "\n" not in str(error.value)
    shorter = {**other, "dt": error.value.enough, "D_V": None}
    run = engaged(25.0, duration=0.02, **shorter)
    assert missing(run) < 1e-4
    assert run.verdict == ("slips" if "mu_s" in other else "locks")


def test_rolling_engagements_agree_to_1e_7(engaged, by_events):
    run, partner = engaged(25.0), by_events(25.0)
    assert run.N_max == pytest.approx(partner.N_max, rel=1e-7)
    assert run.peak[0] == pytest.approx(float(partner.peaks[0, 0]), abs=2e-8)
    between = partner.t <= run.t[-1]
    np.testing.assert_allclose(
        np.interp(partner.t[between], run.t, run.T_i), partner.T_i[between], atol=1.0
    )
    assert bool(partner.rolls.all())


@pytest.mark.parametrize(
    ("torque", "other"),
    [
        (40.0, {"alpha_max": 0.02}),  # what the band's guard protects
        (25.0, {"alpha_max": 0.02, "mu_s": 0.06, "mu_c": 0.05}),
    ],
)
def test_engagements_that_slip_at_the_start_agree_to_1e_4(engaged, by_events, torque, other):
    run, partner = engaged(torque, **other), by_events(torque, **other)
    assert not partner.rolls.all()
    assert run.N_max == pytest.approx(partner.N_max, rel=1e-4)
    slid = run.t[np.flatnonzero(run.phases[:, 0] == Phase.SLIP)[-1]]
    freed = partner.t[np.flatnonzero(~partner.rolls[:, 0])[-1]]
    assert slid == pytest.approx(freed, abs=3e-5)


def test_a_slip_begins_between_the_steps_where_friction_is_reached():
    t, N = 1e-3 * np.arange(6), np.full(6, 200.0)
    phases = np.full((6, 2), Phase.STICK)
    phases[4:, 0] = Phase.SLIP
    found = SimpleNamespace(t=t, N=N, T_i=N * 0.02 * np.arange(6), phases=phases, dt=1e-3)
    assert first_slip(found, 0.065) == pytest.approx(3.25e-3)


def test_half_the_step_changes_the_peak_by_less_than_1e_4_with_fourth_order(engaged):
    peaks = [engaged(25.0, dt=dt, K_r=0.1).N_max for dt in (8e-5, 4e-5, 2e-5, 1e-5, 5e-6)]
    steps = np.abs(np.diff(peaks))
    assert steps[-1] < 1e-6 * peaks[-1]
    assert steps[0] / steps[1] > 3.5  # the parabola through the peak is of lower order


def test_what_ends_before_its_peak_is_not_followed_and_a_profile_s_end_is_its_end(engaged, table):
    run = engaged(25.0, duration=0.002)
    assert run.verdict == "not followed"
    assert not run.followed
    assert math.isnan(run.peak_factor)
    assert engaged(25.0, duration=0.01).verdict == "locks"
    run = engaged(150.0, duration=0.02)
    assert run.verdict == "over the end"
    assert float(run.alpha.max()) <= table.end
    assert run.t[-1] < 0.02


@pytest.mark.parametrize("periods", [20.0, 20.5])
def test_the_mean_of_a_swing_does_not_depend_on_parts_of_a_period(periods):
    t = np.linspace(0, 1, 4001)
    found = SimpleNamespace(N=100 + 30 * np.sin(2 * np.pi * periods * t))
    late, wander = steady(found)
    assert late == pytest.approx(100, abs=0.01)
    assert wander < 0.02

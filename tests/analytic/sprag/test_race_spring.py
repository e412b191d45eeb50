"""The clutch as a spring between its races: work over its twist, oscillations, engagements."""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from analytic.sprag import printed
from analytic.sprag.balance import sampled
from analytic.sprag.closure import wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.course import energy
from analytic.sprag.motion import Motion
from analytic.sprag.oscillation import Oscillation
from analytic.sprag.race_spring import Blades, _sprung, reached
from analytic.sprag.sliding import sliding
from analytic.sprag.start import spring_equilibrium
from analytic.sprag.swing import Driven, swing, time_to_rest
from analytic.sprag.work_balance import (
    asked_at_start,
    at_rest,
    by_turning,
    frequency,
    left_out,
    undamped,
)
from tests.analytic.sprag.models import PARTS, SPRAG

T = 25.0
CLUTCH = SpragClutch(sprag=SPRAG, n_s=12, compliance=PARTS.plane())
HELD = Motion(m_g=2e-3, I_g=2e-8, I_bi=5e-3, I_be=5e3, K_r=0.05, alpha_max=0.3, C_rl=0.0,
              k_out=1e7, mu_s=0.12, mu_c=0.08, gamma_b=1.0)  # fmt: skip


@pytest.fixture(scope="module")
def spring():
    blades = Blades(K_r=HELD.K_r, alpha_max=HELD.alpha_max)
    return reached(lambda _: CLUTCH, 6000.0, T=T, kinetic=0.0, blades=blades)


@pytest.mark.parametrize("w_i", [-8.0, 0.0, 8.0])
def test_a_race_that_turns_ahead_brings_its_energy_and_one_that_overran_does_not(spring, w_i):
    """Without damping: the work of the torque and of the race's speed is that of the spring."""
    stop = HELD.I_bi * max(-w_i, 0.0) / T
    driven = Driven(T=T, t_ramp=0.0, w_i=w_i, t_end=stop + 1.5 / frequency(spring, T, HELD))
    work = spring.resistance().antiderivative()

    def left(theta):
        brought = T * (theta - spring.start) + HELD.I_bi * max(w_i, 0.0) ** 2 / 2
        return float(work(theta) - work(spring.start)) - brought

    farthest = brentq(left, at_rest(spring, T), spring.theta[-1])
    found = swing(spring, driven, HELD)
    assert found.peak[1] == pytest.approx(float(spring.force()(farthest)), rel=1e-3)
    assert not found.over


def test_an_overrunning_race_stops_when_its_momentum_is_used_up():
    step = Driven(T=T, t_ramp=0.0, w_i=-50.0, t_end=1.0)
    assert time_to_rest(step, HELD) == pytest.approx(HELD.I_bi * 50.0 / T)
    slow = Driven(T=T, t_ramp=0.1, w_i=-50.0, t_end=1.0)
    t = time_to_rest(slow, HELD)
    assert np.trapezoid([slow.at(x) for x in np.linspace(0, t, 1001)], dx=t / 1000) == (
        pytest.approx(HELD.I_bi * 50.0, rel=1e-5)
    )


N = np.array([50.0, 500.0, 3407.0, 8000.0])
STEP = 1e-4  # relative, of central differences


def rates(clutch, state=wedged):
    """State at N, differences of the inner and the outer yields and of the races' turn."""
    more, less = (state(clutch, N * (1 + h)) for h in (STEP, -STEP))
    now = state(clutch, N)
    turn = now.OC_e * (np.cos(now.beta) / now.OA - 1 / now.OB) * (more.alpha_b - less.alpha_b)
    turn = turn + np.sin(now.beta) / now.OA * (more.OC_e - less.OC_e)
    inner, outer = more.yields.inner - less.yields.inner, more.yields.outer - less.yields.outer
    return now, inner, outer, turn


def test_eqs_9_and_10_as_printed_lose_a_seventh_of_the_work(clutch):
    """OA with half of delta_HI and without delta_g/2 stands where the whole inner yield must."""
    now, inner, outer, turn = rates(clutch, printed.wedged)
    done = now.T * turn / (12 * (now.N * inner + now.N_e * outer))
    assert done[2] == pytest.approx(0.849, abs=0.002)
    assert np.all((done > 0.8) & (done < 0.87))


def test_the_energy_of_palmgren_s_law_is_known_in_closed_form(clutch):
    y = clutch.compliance.yields(N)
    linear = (y.race_i + y.race_e + y.sprag) / 2
    power = (y.contact_i + y.contact_e) * 0.9 / 1.9
    assert energy(clutch, N) == pytest.approx(N * (linear + power), rel=1e-6)


OUTER = 0.03  # N_e = N_i in the steps, where a strut has cos ω/cos ν


@pytest.fixture
def oscillation(clutch, motion):
    blades = Blades(K_r=motion.K_r, alpha_max=motion.alpha_max)
    spring = reached(lambda _: clutch, 8500.0, T=T, kinetic=0.0, blades=blades)
    f = frequency(spring, T, motion)
    return Oscillation(spring, motion, T=T, f=f, k=motion.I_bi * (2 * math.pi * f) ** 2)


def test_samples_are_of_all_histories_and_balance(engaged):
    run = engaged(T)
    found = sampled(run, 100)
    assert 100 <= len(found["t"]) < 202
    assert {len(column) for column in found.values()} == {len(found["t"])}
    kept = found["kinetic"] + found["elastic"] + found["support"] + found["damping"]
    assert found["torque"] + found["blades"] == pytest.approx(
        kept + found["friction"] + found["missing"]
    )


def test_sliding_sprags_carry_more_as_friction_approaches_the_wedge_angle(spring):
    tan = math.tan(0.055)
    N = [sliding(spring, share * tan).N for share in (0.5, 0.7, 0.9)]
    assert N[0] < N[1] < N[2]
    assert sliding(spring, -0.1).outside


def test_a_small_oscillation_has_the_spring_s_frequency_and_the_work_balance_s_peak(oscillation):
    assert oscillation.frequency(1) == pytest.approx(oscillation.f, rel=OUTER)
    peak = float(oscillation.spring.force()(undamped(oscillation.spring, T)))
    assert oscillation.strut(1e-5).first_peak[1] == pytest.approx(peak, rel=2e-4)
    assert oscillation.undamped(1e-5).first_peak[1] == pytest.approx(peak, rel=OUTER)
    assert oscillation.undamped(1e-5).first_peak[1] != pytest.approx(peak, rel=2e-4)


def test_rolling_and_the_yields_have_the_same_work_and_the_centroid_takes_little(spring):
    assert by_turning(spring) == pytest.approx(1.0, abs=1e-3)
    assert abs(left_out(spring, 3000.0)) < 0.05


def test_the_work_of_the_blades_is_that_of_linear_springs():
    """Twelve of 0.05 N m/rad, slack at 0.3 rad: 0.23 rad in the mean over 0.1 rad."""
    done = _sprung(Blades(K_r=0.05, alpha_max=0.3), 12, np.array([0.02, 0.05, 0.12]))
    assert done == pytest.approx(12 * 0.05 * 0.23 * 0.1, rel=1e-12)


def test_after_the_ramp_the_impulse_of_the_torque_lacks_half_of_the_ramp():
    """T (t - t_ramp/2) = I |w|, with I |w|/T = 10 ms and a ramp of 1 ms."""
    driven = Driven(T=T, t_ramp=1e-3, w_i=-50.0, t_end=1.0)
    assert time_to_rest(driven, HELD) == pytest.approx(HELD.I_bi * 50.0 / T + 0.5e-3, rel=1e-9)


def test_without_torque_the_blades_require_friction_at_the_outer_race_only(spring):
    """Equilibrium of a sprag under its blade: T_i = 0, T_e < 0."""
    now, T_e = spring_equilibrium(CLUTCH, K_r=HELD.K_r, alpha_max=HELD.alpha_max)
    expected = float(abs(T_e) / now.N)
    assert T_e < 0
    assert asked_at_start(spring, 0.0, HELD) == pytest.approx(expected, rel=1e-6)

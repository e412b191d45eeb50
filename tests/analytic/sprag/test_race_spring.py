"""The clutch as a spring between its races: energy, small swings, sprags that slide, in time."""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from analytic.sprag.clutch import Clutch
from analytic.sprag.geometry import LogSprag
from analytic.sprag.motion import Motion
from analytic.sprag.parts import Parts
from analytic.sprag.race_spring import Blades, reached
from analytic.sprag.sliding import sliding
from analytic.sprag.swing import Driven, swing, time_to_rest
from analytic.sprag.work_balance import at_rest, by_turning, frequency, left_out, undamped

T = 25.0
SPRAG = LogSprag.from_wedge_angle(nu_0=0.055, R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3)
PARTS = Parts(
    sprag=SPRAG, n_s=12, l=9e-3, b=4e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3
)  # fmt: skip
CLUTCH = Clutch(sprag=SPRAG, n_s=12, compliance=PARTS.plane())
HELD = Motion(m_g=2e-3, I_g=2e-8, I_bi=5e-3, I_be=5e3, K_r=0.05, alpha_max=0.3, C_rl=0.0,
              k_out=1e7, mu_s=0.12, mu_c=0.08, gamma_b=1.0)  # fmt: skip


@pytest.fixture(scope="module")
def spring():
    blades = Blades(K_r=HELD.K_r, alpha_max=HELD.alpha_max)
    return reached(lambda _: CLUTCH, 6000.0, T=T, kinetic=0.0, blades=blades)


def test_rolling_and_the_yields_have_the_same_work(spring):
    assert by_turning(spring) == pytest.approx(1.0, abs=1e-3)


def test_at_rest_the_spring_and_its_blades_bear_the_torque(spring):
    assert float(spring.resistance()(at_rest(spring, T))) == pytest.approx(T, rel=1e-9)
    assert math.isnan(at_rest(spring, 100 * T))


def test_the_first_peak_without_damping_is_that_of_two_races_in_time(spring):
    """The outer race held by its inertia, the sprags without mass."""
    driven = Driven(T=T, t_ramp=0.0, w_i=0.0, t_end=1.5 / frequency(spring, T, HELD))
    found = swing(spring, driven, HELD)
    assert found.peak[1] == pytest.approx(float(spring.force()(undamped(spring, T))), rel=1e-3)
    assert not found.over


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


def test_light_races_feel_the_sprags_inertia_and_heavy_ones_do_not(spring):
    k = float(spring.resistance()(at_rest(spring, T), 1))
    for I_bi, share in ((5.0, 1e-4), (5e-5, 1.0)):
        motion = Motion(**(vars(HELD) | {"I_bi": I_bi}))
        alone = math.sqrt(k / I_bi) / (2 * math.pi)
        assert 0 < 1 - frequency(spring, T, motion) / alone < share


def test_the_centroid_takes_a_small_part_of_the_work(spring):
    assert abs(left_out(spring, 3000.0)) < 0.05


def test_sprags_that_slide_bear_more_as_friction_comes_near_the_wedge(spring):
    tan = math.tan(0.055)
    N = [sliding(spring, share * tan).N for share in (0.5, 0.7, 0.9)]
    assert N[0] < N[1] < N[2]
    assert sliding(spring, -0.1).outside


def test_an_overrunning_race_stops_when_its_momentum_is_used_up():
    step = Driven(T=T, t_ramp=0.0, w_i=-50.0, t_end=1.0)
    assert time_to_rest(step, HELD) == pytest.approx(HELD.I_bi * 50.0 / T)
    slow = Driven(T=T, t_ramp=0.1, w_i=-50.0, t_end=1.0)
    t = time_to_rest(slow, HELD)
    assert np.trapezoid([slow.at(x) for x in np.linspace(0, t, 1001)], dx=t / 1000) == (
        pytest.approx(HELD.I_bi * 50.0, rel=1e-5)
    )

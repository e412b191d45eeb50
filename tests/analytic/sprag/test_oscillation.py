"""The clutch about its state at rest: compiled steps beside statics, energy and stiffness."""

import math

import pytest

from analytic.sprag.balance import sampled
from analytic.sprag.oscillation import Oscillation, held
from analytic.sprag.race_spring import Blades, reached
from analytic.sprag.work_balance import at_rest, frequency, undamped

T = 25.0
OUTER = 0.03  # N_e = N_i in the steps, where a strut has cos ω/cos ν


@pytest.fixture
def swing(clutch, motion):
    blades = Blades(K_r=motion.K_r, alpha_max=motion.alpha_max)
    spring = reached(lambda _: clutch, 8500.0, T=T, kinetic=0.0, blades=blades)
    f = frequency(spring, T, motion)
    return Oscillation(spring, motion, T=T, f=f, k=motion.I_bi * (2 * math.pi * f) ** 2)


def test_a_slow_rise_ends_at_the_static_force(swing):
    static = float(swing.spring.force()(at_rest(swing.spring, T)))
    assert swing.settled(1) == pytest.approx(static, rel=OUTER)


def test_a_small_oscillation_has_the_frequency_of_stiffness_and_inertia(swing):
    assert swing.frequency(1) == pytest.approx(swing.f, rel=OUTER)


def test_a_strut_reaches_the_peak_of_the_work_balance_and_equal_forces_nearly(swing):
    peak = float(swing.spring.force()(undamped(swing.spring, T)))
    assert swing.strut(1e-5).first_peak[1] == pytest.approx(peak, rel=2e-4)
    assert swing.undamped(1e-5).first_peak[1] == pytest.approx(peak, rel=OUTER)
    assert swing.undamped(1e-5).first_peak[1] != pytest.approx(peak, rel=2e-4)


def test_a_held_race_turns_less_than_a_millionth(swing):
    assert held(swing.motion, C_rl=2.0).I_be == 1e6 * swing.motion.I_be
    assert held(swing.motion, C_rl=2.0).C_rl == 2.0
    run = swing.undamped(1e-5)
    assert abs(run.theta_e).max() < 1e-4 * abs(run.theta_i).max()


def test_samples_are_of_all_histories_and_balance(engaged):
    run = engaged(T)
    found = sampled(run, 100)
    assert 100 <= len(found["t"]) < 202
    assert {len(column) for column in found.values()} == {len(found["t"])}
    kept = found["kinetic"] + found["elastic"] + found["support"] + found["damping"]
    assert found["torque"] + found["blades"] == pytest.approx(
        kept + found["friction"] + found["missing"]
    )

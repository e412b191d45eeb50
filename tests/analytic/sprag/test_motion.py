"""What moves, what drives it, and where it starts."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.sprag.motion import Motion, Speeds, Torque
from analytic.sprag.rest import at_rest
from analytic.sprag.start import spring_equilibrium


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"m_g": 0.0}, "m_g must be positive and finite, got 0.0 kg"),
        ({"I_be": np.nan}, "I_be must be positive and finite, got nan kg m²"),
        ({"C_rl": -0.1}, "C_rl must be finite and not negative, got -0.1 N m s/rad"),
        ({"mu_c": 0.2}, "mu_c <= mu_s, got mu_c=0.2, mu_s=0.12"),
    ],
)
def test_a_motion_that_makes_no_sense_is_refused_in_one_line(motion, wrong, message):
    with pytest.raises(ValueError, match=message):
        replace(motion, **wrong)


def test_a_torque_is_straight_between_its_times():
    torque = Torque(times=np.array([0.0, 1.0, 3.0]), values=np.array([2.0, 4.0, 0.0]))
    assert torque.at([-1.0, 0.5, 2.0, 9.0]).tolist() == [2.0, 3.0, 2.0, 0.0]


@pytest.mark.parametrize(
    ("times", "values", "message"),
    [
        ([0.0, 0.0], [1.0, 2.0], "times of a torque must increase"),
        ([0.0, 1.0], [1.0], "one value for each time"),
        ([0.0], [np.inf], "torque must be finite"),
    ],
)
def test_a_torque_that_makes_no_sense_is_refused(times, values, message):
    with pytest.raises(ValueError, match=message):
        Torque(times=np.array(times), values=np.array(values))


def test_the_start_is_the_blades_equilibrium(table, clutch, motion):
    """Against the closed form: N_0 = 8 N, and the outer race's spring holds T_e."""
    now, T_e = spring_equilibrium(clutch, K_r=motion.K_r, alpha_max=motion.alpha_max)
    start = at_rest(table, motion, Speeds(inner=-3.0))
    assert float(table.at(start[3])["N"]) == pytest.approx(float(now.N), rel=1e-7)
    assert start[3] == pytest.approx(float(now.alpha), rel=1e-5)
    assert start[1] == pytest.approx(float(12 * now.OB * T_e / motion.k_out), rel=1e-6)
    assert start[4:].tolist() == [-3.0, 0.0, 0.0, 0.0]


def test_nothing_moves_from_that_start_without_torque(engaged):
    """Forces that were not balanced would turn the sprag, whose inertia is small, at once."""
    still = engaged(0.0, duration=5e-3)
    assert float(np.ptp(still.N)) < 1e-6 * still.N[0]
    assert float(np.abs(still.T_i).max()) < 1e-6 * still.N[0]


def test_blades_that_turn_the_sprag_off_its_profile_are_refused(table, motion):
    with pytest.raises(ValueError, match="blades turn the sprag to its end"):
        at_rest(table, replace(motion, K_r=1e5, alpha_max=3.0), Speeds())


def test_a_motion_is_what_it_is_told_and_no_more(motion):
    with pytest.raises(TypeError):
        Motion(**{**vars(motion), "C_f": 1.0})

"""Torques at which contacts slip or the spiral ends, least loads, the blades at the start."""

import numpy as np
import pytest

from analytic.sprag.closure import at_torque
from analytic.sprag.limits import limits, slips
from analytic.sprag.search import first_reach


def test_at_the_slip_torque_nu_is_the_angle_of_friction(clutch):
    mu = 0.0555
    T = float(limits(clutch, mu=mu, theta_max=0.5).slip)
    assert float(np.tan(at_torque(clutch, T).nu)) == pytest.approx(mu, rel=1e-10)
    assert slips(at_torque(clutch, [0.99 * T, 1.01 * T]), mu=mu).tolist() == [False, True]


def test_at_the_end_of_the_cam_the_contact_has_walked_the_whole_spiral(clutch):
    T = float(limits(clutch, mu=0.12, theta_max=0.3).end_of_cam)
    assert float(at_torque(clutch, T).turned) == pytest.approx(0.3, rel=1e-10)


def test_a_power_is_inverted_to_round_off_from_any_first_guess():
    goal = np.array([1e-6, 1.0, 1e6])
    for start in (1e-8, 1.0, 1e8):
        found = first_reach(lambda N: N**0.9, goal, start=np.full(3, start))
        assert found == pytest.approx(goal ** (1 / 0.9), rel=1e-12)

"""Torques at which contacts slip or the spiral ends, least loads, the blades at the start."""

import numpy as np
import pytest

from analytic.contact import hertz_line
from analytic.sprag.closure import at_torque, wedged
from analytic.sprag.limits import limits, pressures, slips
from analytic.sprag.search import first_reach
from analytic.sprag.start import drag, spring_equilibrium


def test_at_the_slip_torque_nu_is_the_angle_of_friction(clutch):
    mu = 0.0555
    T = float(limits(clutch, mu=mu, theta_max=0.5).slip)
    assert float(np.tan(at_torque(clutch, T).nu)) == pytest.approx(mu, rel=1e-10)
    assert slips(at_torque(clutch, [0.99 * T, 1.01 * T]), mu=mu).tolist() == [False, True]


def test_limits_are_met_without_load_or_never(clutch):
    found = limits(clutch, mu=[0.05, 0.3], theta_max=0.5)
    assert found.slip.tolist() == [0.0, np.inf]
    assert found.torque.tolist() == [0.0, float(found.end_of_cam)]


def test_at_the_end_of_the_cam_the_contact_has_walked_the_whole_spiral(clutch):
    T = float(limits(clutch, mu=0.12, theta_max=0.3).end_of_cam)
    assert float(at_torque(clutch, T).turned) == pytest.approx(0.3, rel=1e-10)


def test_pressures_are_hertz_s_and_the_inner_one_is_the_larger(parts, clutch):
    now = wedged(clutch, np.array([0.0, 3407.0]))
    p_i, p_o = pressures(parts, now)
    assert p_i[0] == p_o[0] == 0.0
    outer = hertz_line.peak_pressure(P=now.N_e[1] / 9e-3, R=parts.R_contact_e, E_star=parts.E_star)
    assert p_o[1] == pytest.approx(float(outer), rel=1e-12)
    r = float(now.rho[1] * np.hypot(1, parts.sprag.m))  # the spiral has grown
    inner = hertz_line.peak_pressure(
        P=3407 / 9e-3, R=hertz_line.relative_radius(R_1=r, R_2=11.11e-3), E_star=parts.E_star
    )
    assert p_i[1] == pytest.approx(float(inner), rel=1e-12)
    assert p_i[1] > p_o[1]


def test_a_power_is_inverted_to_round_off_from_any_first_guess():
    goal = np.array([1e-6, 1.0, 1e6])
    for start in (1e-8, 1.0, 1e8):
        found = first_reach(lambda N: N**0.9, goal, start=np.full(3, start))
        assert found == pytest.approx(goal ** (1 / 0.9), rel=1e-12)


def test_a_goal_beyond_the_last_value_is_never_reached():
    found = first_reach(
        lambda N: np.where(N <= 7.0, N, np.nan), np.array([6.99, 7.01]), start=np.ones(2)
    )
    assert found[0] == pytest.approx(6.99, rel=1e-12)
    assert np.isnan(found[1])


SPRING = {"K_r": 0.01, "alpha_max": 0.5}


def test_eqs_14_and_15_are_at_rest_with_the_inner_friction_at_zero(clutch):
    now, T_e = spring_equilibrium(clutch, **SPRING)
    moment = now.b_e * T_e - (now.h_i - now.h_e) * now.N + 0.01 * (0.5 - now.alpha)
    assert float(moment) == pytest.approx(0.0, abs=1e-12)
    across = -now.N * np.sin(now.beta + now.gamma) + now.N * np.sin(now.gamma)
    assert float(across - T_e * np.cos(now.gamma)) == pytest.approx(0.0, abs=1e-12)
    assert float(now.N) == pytest.approx(10.9, abs=0.1)


@pytest.mark.parametrize("K_r", [1e-4, 1.0, 10.0, 100.0])
def test_springs_of_any_stiffness_come_to_rest(clutch, K_r):
    now, _ = spring_equilibrium(clutch, K_r=K_r, alpha_max=0.5)
    assert float(now.N * now.OB * drag(now)) == pytest.approx(K_r * (0.5 - now.alpha), rel=1e-9)

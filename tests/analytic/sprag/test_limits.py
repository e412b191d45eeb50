"""Torques at which the contacts slip or the spiral ends, and pressures on the way."""

import numpy as np
import pytest

from analytic.contact import hertz_line
from analytic.sprag.closure import at_torque, wedged
from analytic.sprag.limits import limits, pressures, slips


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


def test_limits_ask_for_friction_and_a_spiral(clutch):
    for wrong, told in (({"mu": 0.0}, "friction"), ({"theta_max": -1.0}, "theta_max")):
        with pytest.raises(ValueError, match=told):
            limits(clutch, **({"mu": 0.1, "theta_max": 0.3} | wrong))

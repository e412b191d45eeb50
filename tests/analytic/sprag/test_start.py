"""Blade spring, sprag and outer race before the inner race drags."""

import numpy as np
import pytest

from analytic.sprag.start import drag, spring_equilibrium

SPRING = {"K_r": 0.01, "alpha_max": 0.5}


def test_eqs_14_and_15_are_at_rest_with_the_inner_friction_at_zero(clutch):
    now, T_e = spring_equilibrium(clutch, **SPRING)
    moment = now.b_e * T_e - (now.h_i - now.h_e) * now.N + 0.01 * (0.5 - now.alpha)
    assert float(moment) == pytest.approx(0.0, abs=1e-12)
    across = -now.N * np.sin(now.beta + now.gamma) + now.N * np.sin(now.gamma)
    assert float(across - T_e * np.cos(now.gamma)) == pytest.approx(0.0, abs=1e-12)
    assert float(now.N) == pytest.approx(10.9, abs=0.1)


def test_a_slack_spring_is_refused(clutch):
    with pytest.raises(ValueError, match="alpha_max above alpha"):
        spring_equilibrium(clutch, K_r=0.01, alpha_max=-0.1)
    with pytest.raises(ValueError, match="spring K_r"):
        spring_equilibrium(clutch, K_r=0.0, alpha_max=0.5)


@pytest.mark.parametrize("K_r", [1e-4, 1.0, 10.0, 100.0])
def test_springs_of_any_stiffness_come_to_rest(clutch, K_r):
    now, _ = spring_equilibrium(clutch, K_r=K_r, alpha_max=0.5)
    assert float(now.N * now.OB * drag(now)) == pytest.approx(K_r * (0.5 - now.alpha), rel=1e-9)


def test_springs_that_no_state_bears_are_told(clutch):
    with pytest.raises(ArithmeticError, match="bears springs of K_r"):
        spring_equilibrium(clutch, K_r=1e9, alpha_max=3.0)


def test_many_springs_at_once(clutch):
    stiff = np.array([0.01, 1.0])
    now, T_e = spring_equilibrium(clutch, K_r=stiff, alpha_max=0.5)
    alone = [float(spring_equilibrium(clutch, K_r=K_r, alpha_max=0.5)[0].N) for K_r in stiff]
    assert pytest.approx(alone, rel=1e-12) == now.N
    assert T_e.shape == (2,)

"""The mean of a logarithmic crown: against the profile, its slopes, its limits, any unit."""

import math

import numpy as np
import pytest

from analytic.contact import crown
from analytic.contact.crown_mean import mean_drop, z_m_share


@pytest.mark.parametrize("z_m", [1e-3, 0.3, 1.0, 5.0, 30.0, 800.0])
def test_the_mean_drop_is_that_of_the_profile(z_m):
    y = 1 - np.linspace(0, 1, 200_001) ** 4  # close to the end
    z = crown.logarithmic(y, K_1=1.0, K_2=0.6, z_m=z_m, load=np.pi, length=2.0, E_star=0.5)
    assert mean_drop(1.0, 0.6, z_m) == pytest.approx(float(np.trapezoid(-z, y)), rel=1e-6)


@pytest.mark.parametrize("z_m", [1e-3, 0.3, 1.0, 5.0, 12.0])
def test_the_share_of_z_m_is_the_slope_of_the_mean(z_m):
    h = 1e-4
    slope = math.log(mean_drop(1.0, 1.0, z_m * (1 + h)) / mean_drop(1.0, 1.0, z_m * (1 - h)))
    assert z_m_share(1.0, z_m) == pytest.approx(slope / (2 * h), rel=1e-4)


def test_z_m_and_k_1_share_one_per_cent():
    h = 1e-5
    by_A = math.log(mean_drop(1 + h, 1.0, 2.0) / mean_drop(1 - h, 1.0, 2.0)) / (2 * h)
    assert z_m_share(1.0, 2.0) + by_A == pytest.approx(1, rel=1e-6)


def test_a_long_logarithm_has_a_mean_that_z_m_does_not_change():
    assert mean_drop(1.0, 1.0, 60.0) == pytest.approx(2 - math.log(4), rel=1e-9)


def test_mean_and_share_are_the_same_in_millimetres():
    assert mean_drop(1.2e-6, 0.7, 8e-6) * 1e3 == pytest.approx(mean_drop(1.2e-3, 0.7, 8e-3))
    assert z_m_share(1.2e-6, 8e-6) == pytest.approx(z_m_share(1.2e-3, 8e-3))

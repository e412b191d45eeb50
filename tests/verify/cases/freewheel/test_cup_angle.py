"""The clamping angle of a cup under torque, from the triangle of axis, flat and roller."""

import math

import pytest

from verify.cases.freewheel.cup.case import FreewheelCup


def test_the_angle_of_an_unloaded_cup_is_larger_than_under_torque():
    q = FreewheelCup()
    half = math.acos((q.X_o - q.r) / (q.R_s + q.r)) / 2
    assert q.alpha_rigid == pytest.approx(half, rel=1e-9)
    # the roller's centre in the triangle of axis and flat, approaches of the state
    centre, height = q.R_s + q.r - q.d_i, q.X_o - q.r + q.d_o
    loaded = math.atan2(math.sqrt(centre**2 - height**2), height) / 2
    assert pytest.approx(q.z * q.R_s * q.N * math.tan(loaded), rel=1e-9) == q.T
    low, high = q.within(q.state).under_torque("alpha")
    assert 0.15 < (1 + low) * half / loaded - 1 < (1 + high) * half / loaded - 1 < 0.25

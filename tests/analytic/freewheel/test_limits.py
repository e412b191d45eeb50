"""Torques of the limits: at each the state is just at it."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.freewheel import state
from analytic.freewheel.geometry import InnerCam
from analytic.freewheel.limits import TOLD, limits


def test_at_each_limit_s_torque_the_state_is_at_the_limit(star):
    found = limits(star, mu=0.1, p_lim=2.5e9)
    now = state.loaded(star, [found.release, found.pressure_inner, found.pressure_outer])
    assert np.tan(now.alpha[0]) == pytest.approx(0.1, rel=1e-9)
    assert now.p_i[1] == pytest.approx(2.5e9, rel=1e-9)
    assert now.p_o[2] == pytest.approx(2.5e9, rel=1e-9)
    assert found.first == "pressure_inner"
    assert float(found.torque) == float(found.pressure_inner)


def test_at_the_corner_s_torque_the_contact_stands_at_the_end_of_the_flat(star):
    far = replace(star, cam=InnerCam(R=16.5e-3, r=2.5e-3, X=10.85e-3, z=8))
    T = limits(far, mu=0.9, p_lim=1e12).corner
    now = state.loaded(far, T)
    x, _ = far.cam.centre(d_i=now.d_i, d_o=now.d_o)
    assert float(x) == pytest.approx(10.85e-3 * np.tan(np.pi / 8), rel=1e-9)


def test_rollers_go_through_at_the_summit_of_the_torque_before_psi_is_zero(cup):
    found = limits(cup, mu=0.1, p_lim=1e11)
    top = float(found.pop_through)
    N = np.linspace(1e3, 2e4, 4000)
    assert top == pytest.approx(float(np.nanmax(state.at_normal_force(cup, N).T)), rel=1e-6)
    now = state.loaded(cup, 0.99999 * top)
    assert float(now.d_i + now.d_o) < 0.8 * float(cup.cam.pop_through)
    assert found.first == "pop_through"
    assert np.isinf(found.pressure_inner)
    assert np.isinf(found.release)


def test_a_clutch_too_steep_for_its_friction_releases_at_once(clutch):
    found = limits(clutch, mu=0.05, p_lim=2.5e9)
    assert float(found.release) == 0
    assert found.first == "release"
    assert found.passed(1.0) == TOLD["release"]


def test_within_all_limits_nothing_is_said(star):
    assert limits(star, mu=0.1, p_lim=2.5e9).passed([1.0, 50.0]).tolist() == [
        "", TOLD["pressure_inner"],
    ]  # fmt: skip


def test_limits_of_many_frictions_at_once(star):
    found = limits(star, mu=np.array([0.06, 0.065, 0.1]), p_lim=2.5e9)
    assert found.first.tolist() == ["release", "release", "pressure_inner"]
    assert found.release[0] == 0
    assert 0 < found.release[1] < found.release[2]


def test_no_state_is_told_with_a_contact_wider_than_half_the_roller_s_radius(star):
    T = float(limits(star, mu=0.9, p_lim=1e13).hertz)
    now = state.loaded(star, [0.9999 * T, 1.0001 * T])
    assert now.a_o[0] == pytest.approx(1.25e-3, rel=1e-3)  # the bore's contact is the wider
    assert np.isnan(now.alpha[1])

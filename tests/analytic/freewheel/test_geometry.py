"""Wedges of both cams against drawn circles; wind-up by the rolling condition; Eqs. 3 to 7."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.freewheel import printed, rolling
from analytic.freewheel.geometry import InnerCam, OuterCam

UM = 1e-3  # lengths in mm here
STAR = InnerCam(R=16.5, r=2.5, X=11.39565, z=8)
CUP = OuterCam(R_s=10.0, r=2.0, X_o=12 * np.cos(np.radians(8)) + 2, z=8)


def contact_points(cam, d_i=0.0, d_o=0.0):
    """Points of the roller nearest to the flat and to the race, from its centre alone."""
    x, y = cam.centre(d_i=d_i, d_o=d_o)
    centre = np.array([x, y])
    outward = cam.sense * centre / np.hypot(x, y)
    return centre - cam.sense * cam.roller * np.array([0.0, 1.0]), centre + cam.roller * outward


@pytest.mark.parametrize("cam", [STAR, CUP], ids=["star", "cup"])
def test_the_line_through_both_contacts_makes_the_same_angle_with_both_normals(cam):
    """Eq. 2: a roller held by two contacts alone; each angle is the clamping angle."""
    on_flat, on_race = contact_points(cam)
    chord = (on_race - on_flat) / np.linalg.norm(on_race - on_flat)
    at_flat = np.arccos(abs(chord[1]))
    at_race = np.arccos(abs(chord @ on_race) / np.linalg.norm(on_race))
    assert at_flat == pytest.approx(float(cam.alpha0), abs=1e-13)
    assert at_race == pytest.approx(float(cam.alpha0), abs=1e-13)
    assert np.linalg.norm(chord @ (on_race - on_flat)) == pytest.approx(
        2 * cam.roller * np.cos(cam.alpha0)
    )


@pytest.mark.parametrize("cam", [STAR, CUP], ids=["star", "cup"])
def test_the_forces_on_the_flat_have_the_race_s_torque_and_z_x_f_t_has_not(cam):
    """Eq. 3, from the cross product at the drawn contact; the lever X needs X = R."""
    F_t = float(np.tan(cam.alpha0))  # F_n = 1
    on_flat, on_race = contact_points(cam)
    chord = (on_race - on_flat) / np.linalg.norm(on_race - on_flat) / np.cos(cam.alpha0)
    moment = cam.count * abs(on_flat[0] * chord[1] - on_flat[1] * chord[0])
    assert cam.torque_on_race(F_t=F_t) == pytest.approx(moment, rel=1e-11)
    assert cam.torque_on_cam(F_n=1.0, F_t=F_t) == pytest.approx(moment, rel=1e-11)
    wrong = printed.torque_on_cam(cam, F_t=F_t) / moment
    assert wrong == pytest.approx(float(cam.flat / cam.race), rel=1e-11)
    assert abs(wrong - 1) > 0.3


def test_eq_4_has_the_ring_s_radius_in_its_numerator():
    root = np.sqrt((16.5 + 11.39565) / (2 * (16.5 - 2.5)))
    assert float(STAR.alpha0) == pytest.approx(np.arccos(root), rel=1e-12)
    assert np.degrees(float(STAR.alpha0)) == pytest.approx(3.5, abs=1e-4)
    assert np.degrees(float(printed.alpha0(STAR))) == pytest.approx(45.2, abs=0.05)


def test_eq_5_returns_to_eq_4_without_load_and_opens_under_load():
    """As printed it starts at 21.5 deg and narrows, although the gap widens."""
    loaded = {"d_i": 16 * UM, "d_o": 24 * UM}
    right = np.arccos((11.39565 - 0.016 + 2.5) / (16.5 + 0.024 - 2.5)) / 2
    assert float(STAR.alpha(**loaded)) == pytest.approx(right, rel=1e-11)
    assert np.degrees(right) == pytest.approx(4.114, abs=1e-3)
    first, then = printed.alpha_1(STAR, d_i=0.0, d_o=0.0), printed.alpha_1(STAR, **loaded)
    assert np.degrees(float(first)) == pytest.approx(21.5, abs=0.01)
    assert then < first


def test_eq_5_with_the_ring_s_outer_radius_does_not_return_to_eq_4():
    cos, rim = float(np.cos(2 * STAR.alpha0)), 21.0
    assert cos == pytest.approx((11.39565 + 2.5) / (16.5 - 2.5), rel=1e-12)
    assert cos != pytest.approx((11.39565 + 2.5) / (rim - 2.5), rel=0.1)


@pytest.mark.parametrize("cam", [STAR, CUP], ids=["star", "cup"])
def test_eq_6_is_the_arc_of_the_centre_from_its_unloaded_place(cam):
    d_i, d_o = 4 * UM, 6 * UM
    (x_0, y_0), (x, y) = cam.centre(d_i=0.0, d_o=0.0), cam.centre(d_i=d_i, d_o=d_o)
    turned = abs(np.arctan2(x, y) - np.arctan2(x_0, y_0))
    assert cam.arc(d_i=0.0, d_o=0.0) == 0
    assert cam.arc(d_i=d_i, d_o=d_o) == pytest.approx(turned * np.hypot(x, y), rel=1e-9)


def test_an_outer_cam_s_roller_moves_between_flat_and_shaft_until_pop_through():
    ends = float(CUP.pop_through)
    assert ends == pytest.approx(10 + 2 * 2 - CUP.X_o, rel=1e-12)
    share = np.array([0.0, 0.5, 0.99, 1.001])
    alpha = CUP.alpha(d_i=0.3 * ends * share, d_o=0.7 * ends * share)
    assert np.all(np.diff(alpha[:3]) < 0)
    assert np.isnan(alpha[3])
    assert np.cos(2 * alpha[1]) == pytest.approx(
        (CUP.X_o - 2 + 0.35 * ends) / (12 - 0.15 * ends), rel=1e-12
    )


D_I, D_O = 4e-3, 6e-3


def worked(cam, d_i, d_o):
    """Turn of the ring from T dphi = dU: R dphi = (dd_i + dd_o)/tan(alpha)."""
    whole = quad(
        lambda u: float((d_i + d_o) / np.tan(cam.alpha(d_i=d_i * u, d_o=d_o * u))), 0, 1,
        epsrel=1e-13,
    )[0]  # fmt: skip
    return whole / float(cam.race)


@pytest.mark.parametrize("cam", [STAR, CUP], ids=["star", "cup"])
def test_torsion_has_the_work_of_the_torque(cam):
    u = np.linspace(0, 1, 2001)
    phi = rolling.torsion(cam, d_i=D_I * u, d_o=D_O * u)
    assert phi[0] == 0
    assert phi[-1] == pytest.approx(worked(cam, D_I, D_O), rel=1e-10)


def test_eq_7_as_printed_is_high_by_r_plus_x_over_2_x():
    right = np.degrees(worked(STAR, D_I, D_O))
    assert right == pytest.approx(0.5548, abs=5e-5)
    factor = (16.5 + 11.39565) / (2 * 11.39565)
    for scale in (0.5, 1.0, 4.0):
        d_i, d_o = scale * D_I, scale * D_O
        high = float(printed.torsion(STAR, d_i=d_i, d_o=d_o)) / worked(STAR, d_i, d_o)
        assert high == pytest.approx(factor, rel=1.2e-3)
        assert high > 1.2

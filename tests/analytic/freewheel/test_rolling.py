"""Torsion by rolling against the rolling condition integrated in steps; Eq. 7 as printed."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.freewheel import printed, rolling
from analytic.freewheel.geometry import InnerCam, OuterCam

STAR = InnerCam(R=16.5, r=2.5, X=11.39565, z=8)
CUP = OuterCam(R_s=10.0, r=2.0, X_o=12 * np.cos(np.radians(8)) + 2, z=8)
D_I, D_O = 4e-3, 6e-3


def rolled(cam, d_i, d_o):
    """Integral of the rolling condition over a straight path, from numerical derivatives."""

    def rate(u, h=1e-5):
        places = [cam.centre(d_i=d_i * v, d_o=d_o * v) for v in (u - h, u + h)]
        dx, dy = (np.array(places[1]) - np.array(places[0])) / (2 * h)
        psi = 2 * cam.alpha(d_i=d_i * u, d_o=d_o * u)
        return float(cam.sense * (dx * (1 + np.cos(psi)) - dy * np.sin(psi)))

    return quad(rate, 0, 1, epsrel=1e-11)[0] / float(cam.race)


def worked(cam, d_i, d_o):
    """The same from T dphi = dU: R dphi = (dd_i + dd_o)/tan(alpha)."""
    whole = quad(
        lambda u: float((d_i + d_o) / np.tan(cam.alpha(d_i=d_i * u, d_o=d_o * u))), 0, 1,
        epsrel=1e-13,
    )[0]  # fmt: skip
    return whole / float(cam.race)


@pytest.mark.parametrize("cam", [STAR, CUP], ids=["star", "cup"])
def test_torsion_is_the_rolling_condition_integrated(cam):
    u = np.linspace(0, 1, 2001)
    phi = rolling.torsion(cam, d_i=D_I * u, d_o=D_O * u)
    assert phi[0] == 0
    assert phi[-1] == pytest.approx(rolled(cam, D_I, D_O), rel=1e-7)
    assert phi[-1] == pytest.approx(worked(cam, D_I, D_O), rel=1e-10)


def test_of_a_path_with_a_turn_every_piece_counts():
    one, two = np.linspace(0, D_I, 501), np.linspace(0, D_O, 501)
    d_i, d_o = np.append(one, np.full(501, D_I)), np.append(np.zeros(501), two)
    direct = worked(STAR, D_I, D_O)
    around = rolling.torsion(STAR, d_i=d_i, d_o=d_o)[-1]
    assert around == pytest.approx(direct, rel=2e-3)  # phi depends little on the way
    assert around != pytest.approx(direct, rel=1e-6)


def test_eq_7_as_printed_is_high_by_r_plus_x_over_2_x():
    right = np.degrees(worked(STAR, D_I, D_O))
    assert right == pytest.approx(0.5548, abs=5e-5)
    factor = (16.5 + 11.39565) / (2 * 11.39565)
    for scale in (0.5, 1.0, 4.0):
        d_i, d_o = scale * D_I, scale * D_O
        high = float(printed.torsion(STAR, d_i=d_i, d_o=d_o)) / worked(STAR, d_i, d_o)
        assert high == pytest.approx(factor, rel=1.2e-3)
        assert high > 1.2


def test_the_small_angle_form_stays_within_a_thousandth_and_1_plus_x_over_r_within_six():
    for scale in (0.5, 1.0, 4.0):
        d_i, d_o = scale * D_I, scale * D_O
        right = worked(STAR, d_i, d_o)
        s_form = float(rolling.small_angle_torsion(STAR, d_i=d_i, d_o=d_o))
        turned = float(STAR.alpha(d_i=d_i, d_o=d_o) - STAR.alpha0)
        assert abs(s_form / right - 1) < 1.2e-3
        assert -6e-3 < (1 + STAR.X / STAR.R) * 2 * turned / right - 1 < -4e-3


def test_torsion_of_many_clutches_at_once_is_that_of_each():
    cams = InnerCam(R=16.5, r=2.5, X=np.array([11.38, 11.39565])[:, None], z=8)
    u = np.linspace(0, 1, 11)
    both = rolling.torsion(cams, d_i=D_I * u, d_o=D_O * u)
    np.testing.assert_allclose(both[1], rolling.torsion(STAR, d_i=D_I * u, d_o=D_O * u), rtol=1e-12)

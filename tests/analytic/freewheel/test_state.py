"""States under torque: equilibrium, energy, limits, and what happens where there is none."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import hertz_line
from analytic.freewheel import state
from analytic.freewheel.clutch import Clutch, Material
from analytic.freewheel.compliance import compliance
from analytic.freewheel.geometry import InnerCam

TORQUES = np.array([0.5, 5.0, 26.0])


def parts(E, nu=0.3):
    steel = Material(E=E, nu=nu)
    return {"roller": steel, "inner": steel, "outer": steel}


def test_the_forces_balance_on_the_roller_and_give_the_torque(clutch):
    """Free body: the resultants of both contacts on one line, their moment about the axis."""
    now, cam = state.loaded(clutch, 20.0), clutch.cam
    x, y = (float(v) for v in cam.centre(d_i=now.d_i, d_o=now.d_o))
    outward = np.array([x, y]) / np.hypot(x, y)
    along = np.array([outward[1], -outward[0]])  # clockwise
    # normal forces squeeze the roller out of the gap, friction at both contacts pulls it in
    on_race = cam.sense * (-now.N * outward + now.F_t * along)
    on_flat = cam.sense * (now.N * np.array([0.0, 1.0]) + now.F_t * np.array([1.0, 0.0]))
    assert np.linalg.norm(on_race + on_flat) < 1e-10 * now.N
    place = cam.race * outward
    moment = cam.count * abs(place[0] * on_race[1] - place[1] * on_race[0])
    assert float(moment) == pytest.approx(20.0, rel=1e-12)
    assert float(now.T) == pytest.approx(20.0, rel=1e-12)


def test_torque_times_torsion_is_the_energy_put_in(clutch):
    """T dphi = dU with U = z int N d(d_i + d_o): phi from rolling against int dU/T."""
    now, cam = state.loaded(clutch, TORQUES), clutch.cam
    bodies = compliance(clutch)

    def rate(u, N):
        d = bodies.approaches(N * u**3 / clutch.L)
        alpha = cam.alpha(d_i=d.d_i, d_o=d.d_o)
        slope = (d.slope_i + d.slope_o) / clutch.L
        return float(3 * u**2 * N * slope / (cam.race * np.tan(alpha)))

    for N, phi in zip(now.N, now.phi, strict=True):
        assert phi == pytest.approx(quad(rate, 0, 1, args=(N,), epsrel=1e-13)[0], rel=1e-10)


def test_the_torsion_is_the_slope_of_energy_over_torque(clutch):
    h = 1e-4
    one, two = state.loaded(clutch, 10 * (1 - h)), state.loaded(clutch, 10 * (1 + h))
    turned = float(two.phi - one.phi)
    approach = float(two.d_i + two.d_o - one.d_i - one.d_o)
    N = float(state.loaded(clutch, 10.0).N)
    assert 10 * turned == pytest.approx(clutch.cam.count * N * approach, rel=1e-6)


def test_angle_normal_force_and_torque_name_the_same_state(clutch):
    now = state.loaded(clutch, TORQUES)
    for other in (state.at_normal_force(clutch, now.N), state.at_angle(clutch, now.psi)):
        np.testing.assert_allclose(other.T, TORQUES, rtol=1e-10)
        np.testing.assert_allclose(other.phi, now.phi, rtol=1e-9)


def test_a_rigid_clutch_keeps_its_unloaded_angle(clutch):
    hard = replace(clutch, **parts(206e9 * 1e8))
    now = state.loaded(hard, TORQUES)
    np.testing.assert_allclose(now.alpha, clutch.cam.alpha0, rtol=1e-7)
    np.testing.assert_allclose(now.phi, 0, atol=1e-8)
    np.testing.assert_allclose(now.F_t, now.N * np.tan(clutch.cam.alpha0), rtol=1e-7)


def test_without_torque_nothing_has_moved(clutch):
    now = state.loaded(clutch, 0.0)
    assert float(now.alpha) == pytest.approx(float(clutch.cam.alpha0), rel=1e-15)
    for value in (now.N, now.d_i, now.d_o, now.a_i, now.p_o, now.s, now.phi):
        assert float(value) == 0


def test_load_widens_the_angle_of_an_inner_cam_and_narrows_that_of_an_outer(star, cup):
    assert np.all(np.diff(state.loaded(star, TORQUES).alpha) > 0)
    assert np.all(np.diff(state.loaded(cup, TORQUES).alpha) < 0)


def test_eq_7_as_printed_overstates_the_torsion_under_every_torque(star):
    now = state.loaded(star, TORQUES)
    cam = star.cam
    np.testing.assert_allclose(now.phi_printed / now.phi, (cam.R + cam.X) / (2 * cam.X), rtol=2e-3)
    np.testing.assert_allclose(now.phi_small / now.phi, 1, atol=1.3e-3)


def test_newton_converges_quadratically(clutch):
    found = state.loaded(clutch, 26.0)
    bodies, F_t = compliance(clutch), float(found.F_t)
    x, errors = np.log(F_t / np.tan(clutch.cam.alpha0)), []
    for _ in range(4):
        tangent, slope = bodies.tangent(np.exp(x))
        x -= (x + np.log(tangent) - np.log(F_t)) / (1 + np.exp(x) * slope / tangent)
        errors.append(abs(float(x) - np.log(float(found.N))))
    assert errors[0] < 0.2
    assert errors[1] < 0.5 * errors[0] ** 1.9
    assert errors[3] < 1e-11


def test_pressures_are_hertz_s(star):
    now = state.loaded(star, 20.0)
    P, E_star = now.N / star.L, 206e9 / 0.91 / 2  # steel on steel
    flat, bore = 2.5e-3, 1 / (1 / 2.5e-3 - 1 / 16.5e-3)
    for R, a, p in ((flat, now.a_i, now.p_i), (bore, now.a_o, now.p_o)):
        assert a == pytest.approx(hertz_line.half_width(P=P, R=R, E_star=E_star), rel=1e-12)
        assert p == pytest.approx(hertz_line.peak_pressure(P=P, R=R, E_star=E_star), rel=1e-12)


def test_a_shaft_touches_less_widely_than_the_cup_s_flat(cup):
    now = state.loaded(cup, 10.0)
    shaft = 1 / (1 / 2e-3 + 1 / 10e-3)
    assert float((now.a_i / now.a_o) ** 2) == pytest.approx(shaft / 2e-3, rel=1e-12)


def test_parts_of_different_stiffness_move_the_approaches(star):
    soft = replace(star, outer=Material(E=110e9, nu=0.3))
    one, other = (state.at_normal_force(c, 2000.0) for c in (star, soft))
    assert other.d_o > 1.3 * one.d_o
    assert other.d_i == pytest.approx(float(one.d_i), rel=1e-14)


def test_beyond_the_summit_of_its_torque_an_outer_cam_has_no_state(cup):
    N = np.linspace(1e3, 2e4, 4000)
    T = state.at_normal_force(cup, N).T
    top = float(np.nanmax(T))
    below, above = state.loaded(cup, [0.999 * top, 1.001 * top]).T
    assert below == pytest.approx(0.999 * top, rel=1e-9)
    assert np.isnan(above)
    assert np.isnan(state.loaded(cup, 2 * top).phi)


def test_no_angle_is_told_that_no_load_reaches(clutch):
    wrong = 2 * clutch.cam.alpha0 - clutch.cam.sense * 1e-3
    assert np.isnan(state.at_angle(clutch, wrong).N)


def test_many_clutches_at_once_are_each_as_alone():
    X = np.linspace(11.386e-3, 11.399e-3, 40)
    more = {"L": 10e-3, "r_b": 7.5e-3, "R_a": 21e-3, **parts(206e9)}
    many = state.loaded(Clutch(cam=InnerCam(R=16.5e-3, r=2.5e-3, X=X, z=8), **more), 20.0)
    for k in (0, 17, 39):
        one = Clutch(cam=InnerCam(R=16.5e-3, r=2.5e-3, X=X[k], z=8), **more)
        assert many.phi[k] == pytest.approx(float(state.loaded(one, 20.0).phi), rel=1e-9)


@pytest.mark.parametrize(
    ("change", "rule"),
    [
        ({"L": 0.0}, "length"), ({"r_b": 12e-3}, "r_b below"), ({"r_b": 0.0}, "clamped"),
        ({"R_a": 16e-3}, "R_a above"), ({"star": "disc"}, "star is one of"),
    ],
)  # fmt: skip
def test_parts_without_a_wall_are_refused(star, change, rule):
    with pytest.raises(ValueError, match=rule):
        replace(star, **change)


@pytest.mark.parametrize("T", [-1.0, np.nan])
def test_torque_against_the_locking_direction_is_refused(star, T):
    with pytest.raises(ValueError, match="torque"):
        state.loaded(star, T)

"""States under torque: equilibrium, energy, limits, largest torque, release of the ring."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact import hertz_line
from analytic.freewheel import state
from analytic.freewheel.compliance import compliance
from analytic.freewheel.let_out import let_out
from analytic.freewheel.limits import MEANINGS, pop_through, roller_torque_limits
from analytic.freewheel.state import at_normal_force, loaded
from analytic.freewheel.summit import summit

TORQUES = np.array([0.5, 5.0, 26.0])


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


def test_angle_normal_force_and_torque_name_the_same_state(clutch):
    now = state.loaded(clutch, TORQUES)
    for other in (state.at_normal_force(clutch, now.N), state.at_angle(clutch, now.psi)):
        np.testing.assert_allclose(other.T, TORQUES, rtol=1e-10)
        np.testing.assert_allclose(other.phi, now.phi, rtol=1e-9)


def test_at_each_limit_s_torque_the_state_is_at_the_limit(star):
    found = roller_torque_limits(star, mu=0.1, p_lim=2.5e9)
    now = state.loaded(star, [found.release, found.pressure_inner, found.pressure_outer])
    assert np.tan(now.alpha[0]) == pytest.approx(0.1, rel=1e-9)
    assert now.p_i[1] == pytest.approx(2.5e9, rel=1e-9)
    assert now.p_o[2] == pytest.approx(2.5e9, rel=1e-9)
    assert found.first == "pressure_inner"
    assert float(found.torque) == float(found.pressure_inner)


def test_a_clutch_too_steep_for_its_friction_releases_at_once(clutch):
    found = roller_torque_limits(clutch, mu=0.05, p_lim=2.5e9)
    assert float(found.release) == 0
    assert found.first == "release"
    assert found.passed(1.0) == MEANINGS["release"]


def test_no_state_near_the_largest_torque_exceeds_it_and_an_inner_cam_has_none(cup, star):
    top = summit(cup)
    near = at_normal_force(cup, float(top.N) * np.linspace(0.9, 1.1, 201)).T
    assert near.max() <= float(top.T)
    assert np.isfinite(loaded(cup, 0.9999 * top.T).N)
    assert np.isnan(loaded(cup, 1.0001 * top.T).N)
    assert pop_through(star) == np.inf  # of an inner cam there is none
    assert summit(star) is None


def test_slip_begins_as_coulomb_s_law_has_it(star):
    slip, torque = let_out(star, T=26.0, mu=0.08)
    ends = [loaded(star, 26.0 * share) for share in torque[-2:]]
    lost = sum(float(getattr(ends[1], d) - getattr(ends[0], d)) for d in ("d_i", "d_o"))
    tan = np.tan(float(ends[1].alpha))
    assert lost / slip[-2] == pytest.approx(tan / np.sqrt((0.08 / tan) ** 2 - 1), rel=5e-3)


def test_pressures_are_hertz_s(star):
    now = state.loaded(star, 20.0)
    P, E_star = now.N / star.L, 206e9 / 0.91 / 2  # steel on steel
    flat, bore = 2.5e-3, 1 / (1 / 2.5e-3 - 1 / 16.5e-3)
    for R, a, p in ((flat, now.a_i, now.p_i), (bore, now.a_o, now.p_o)):
        assert a == pytest.approx(hertz_line.half_width(P=P, R=R, E_star=E_star), rel=1e-12)
        assert p == pytest.approx(hertz_line.peak_pressure(P=P, R=R, E_star=E_star), rel=1e-12)

"""The explicit closure against drawn sprags; compliances, limits, and Eqs. 9 to 16 as printed."""

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

from analytic.contact import hertz_line
from analytic.sprag import printed
from analytic.sprag.closure import at_rotation, at_torque, wedged
from analytic.sprag.clutch import SpragClutch
from analytic.sprag.compression import sprag_compression
from analytic.sprag.limits import pressures, slips, sprag_torque_limits
from analytic.sprag.parts import SpragClutchParts
from analytic.sprag.search import first_reach

N = np.array([50.0, 500.0, 3407.0, 8000.0])


def nearest(sprag, OC_e, alpha_b):
    """Least distance from O of the unstrained spiral, drawn with its pole and turn."""

    def distance(angle):
        rho = sprag.rho_0 * np.exp(sprag.m * angle)
        at = sprag.eta_0 + angle - alpha_b  # seen from the pole, anticlockwise from downwards
        return np.hypot(rho * np.sin(at), OC_e - rho * np.cos(at))

    found = minimize_scalar(
        distance, bounds=(alpha_b - 0.3, alpha_b + 0.3), method="bounded",
        options={"xatol": 1e-9},
    )  # fmt: skip
    return found.fun, found.x


def test_the_turned_spiral_reaches_into_the_inner_race_by_all_that_yields_there(clutch):
    for load in N:
        now = wedged(clutch, load)
        OA_s, angle = nearest(clutch.sprag, now.OC_e, now.alpha_b)
        assert OA_s == pytest.approx(11.11e-3 - float(now.yields.inner), abs=1e-12)
        assert angle == pytest.approx(float(now.turned), abs=1e-5)


def test_explicit_and_iterated_closure_agree(clutch):
    """Eq. 11 as an iteration: the load at which the deflection of the sprag equals its overlap."""
    for load in (500.0, 3407.0):
        alpha_b = float(wedged(clutch, load).alpha_b)

        def lack(N, alpha_b=alpha_b):
            y = clutch.compliance.yields(N)
            OA_s, _ = nearest(clutch.sprag, clutch.sprag.OC_e + y.outer, alpha_b)
            return float(11.11e-3 - y.inner - OA_s)

        assert brentq(lack, 10.0, 2e4, xtol=1e-9) == pytest.approx(load, rel=1e-6)


def test_eq_14_s_statics_hold_with_the_lever_arms_of_eq_15(clutch):
    """b_i T_i + b_e T_e = h_i N - h_e N_e about the centroid, with h_i for the printed h."""
    now = wedged(clutch, N)
    tangential = now.b_i * now.T_i + now.b_e * now.T_e
    assert tangential == pytest.approx(now.h_i * now.N - now.h_e * now.N_e, rel=1e-11)
    across = now.N * np.sin(now.beta + now.gamma) - now.N_e * np.sin(now.gamma)
    along = now.T_i * np.cos(now.beta + now.gamma) - now.T_e * np.cos(now.gamma)
    assert across == pytest.approx(along, rel=1e-10)


def test_gamma_and_alpha_are_angles_of_the_triangle_of_centroid_pole_and_axis(clutch):
    """Errata eq-10-gamma-missing, eq-10-initial-angle: the angle at C_g is theta_i + alpha."""
    first, now = (wedged(clutch, load) for load in (0.0, N))
    at_C_g = []
    for state in (first, now):
        pole = np.array([0.0 * state.OC_e, state.OC_e])
        C_g = state.OC_g * np.array([-np.sin(state.gamma), np.cos(state.gamma)])
        to_pole = pole - C_g
        apart = np.hypot(*to_pole)
        at_C_g.append(np.arccos(np.sum(-C_g * to_pole, axis=0) / (state.OC_g * apart)))
        assert apart == pytest.approx(float(np.hypot(*clutch.centroid)), rel=1e-11)
        sine = apart * np.sin(at_C_g[-1]) / state.OC_e
        assert np.arcsin(sine) == pytest.approx(np.abs(state.gamma), rel=1e-11)
    assert at_C_g[1] - at_C_g[0] == pytest.approx(now.alpha, rel=1e-9)


def test_eq_7_by_hand():
    """A bar of 8.33 mm and 4 x 9 mm² under 3407 N: 3407 x 8.33/(36 x 206 000) mm."""
    d = sprag_compression(N=3407.0, R_i=11.11e-3, R_e=19.44e-3, b=4e-3, l=9e-3, E=206e9)
    assert float(d) == pytest.approx(3.8269026e-6, rel=1e-7)


def test_the_compliance_has_eqs_6_and_7(parts):
    found = parts.palmgren().yields(np.array([0.0, 3407.0]))
    assert found.sprag.tolist() == pytest.approx([0.0, 3.8269026e-6], rel=1e-7)
    scale = 3407 * 12 / (2 * np.pi * 9e-3 * 206e9)
    i, e = (
        (11.11**2 + 7.21**2) / (11.11**2 - 7.21**2),
        (26.23**2 + 19.44**2) / (26.23**2 - 19.44**2),
    )
    assert found.race_i[1] == pytest.approx(scale * (i - 0.3), rel=1e-12)
    assert found.race_e[1] == pytest.approx(scale * (e + 0.3), rel=1e-12)
    assert found.contact_i[1] == pytest.approx(3.84e-8 * 3407**0.9 / 9**0.8, rel=1e-12)
    five = found.contact_i + found.contact_e + found.race_i + found.race_e + found.sprag
    assert pytest.approx(five, rel=1e-14) == found.H


def test_long_bodies_deflect_in_plane_strain_with_the_indentations_of_the_bar(parts):
    """Rings by Lamé in plane strain: Eq. 6 with E/(1 - nu²) and nu/(1 - nu); no Eq. 7."""
    found, scale = parts.plane().yields(3407.0), 3407 * 12 / (2 * np.pi * 9e-3 * 206e9 / 0.91)
    i = (11.11**2 + 7.21**2) / (11.11**2 - 7.21**2)
    e = (26.23**2 + 19.44**2) / (26.23**2 - 19.44**2)
    assert float(found.race_i) == pytest.approx(scale * (i - 3 / 7), rel=1e-12)
    assert float(found.race_e) == pytest.approx(scale * (e + 3 / 7), rel=1e-12)
    assert float(found.sprag) == 0.0


@pytest.fixture
def fast(sprag):
    """The clutch at 1000 rad/s."""
    parts = SpragClutchParts(
        sprag=sprag, n_s=12, l=9e-3, b=4e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3,
        omega=1000.0,
    )  # fmt: skip
    return SpragClutch(sprag=sprag, n_s=12, compliance=parts.palmgren())


def test_the_printed_pole_lets_the_sprag_grow_with_the_outer_race(fast):
    """Erratum eq-9-centrifugal: C_eB is the radius of the sprag less its flattening."""
    now = wedged(fast, 2000.0)
    y = now.yields
    own = fast.sprag.r_e - y.contact_e / 2 - y.sprag / 2
    assert float(now.OB - now.OC_e) == pytest.approx(float(own), rel=1e-12)
    grown = now.OB - printed.pole_distance(fast.sprag, y) - own
    assert float(grown) == pytest.approx(float(y.d_ce), rel=1e-9)
    assert float(y.d_ce) > 4e-7


def test_the_printed_theta_is_no_angle_of_the_spiral():
    """Erratum eq-10-theta: rho grows by m rho a radian; log((rho/a)/m) grows by rho'/rho = m."""
    a, m, theta = 3.5, 0.0892, np.array([0.5, 1.5])
    rho = a * np.exp(m * theta)
    assert np.log(rho / a) / m == pytest.approx(theta, rel=1e-12)
    printed_angle = printed.polar_angle(rho=rho, a=a, m=m)
    assert printed_angle[1] - printed_angle[0] == pytest.approx(
        m * (theta[1] - theta[0]), rel=1e-12
    )


def test_the_printed_lever_arms_are_halves(clutch):
    """Erratum eq-16-lever-arms: 5.6 for 11.1 mm and 9.7 for 19.4 mm double the contact force."""
    now = wedged(clutch, 3407.0)
    inner, outer = printed.lever_arms(clutch.sprag, now.yields)
    assert float(inner / now.OA) == pytest.approx(0.5, abs=1e-3)
    assert float(outer / now.OB) == pytest.approx(0.5, abs=1e-3)
    assert float(inner) == pytest.approx(5.55e-3, abs=5e-5)
    assert float(outer) == pytest.approx(9.73e-3, abs=5e-5)
    moment = now.OA * now.T_i - now.OB * now.T_e
    assert float(moment) == pytest.approx(0.0, abs=1e-12)


def test_a_power_is_inverted_to_round_off_from_any_first_guess():
    goal = np.array([1e-6, 1.0, 1e6])
    for start in (1e-8, 1.0, 1e8):
        found = first_reach(lambda N: N**0.9, goal, start=np.full(3, start))
        assert found == pytest.approx(goal ** (1 / 0.9), rel=1e-12)


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


def test_torque_and_rotation_lead_back_to_the_load_and_rigid_races_need_more(clutch, plane_clutch):
    for some in (clutch, plane_clutch):
        now = wedged(some, N)
        assert pytest.approx(N, rel=1e-12) == at_torque(some, now.T).N
        assert pytest.approx(N, rel=1e-11) == at_rotation(some, now.alpha).N
    stiff = at_rotation(clutch.rigid_races(), 0.1).N
    assert float(stiff / at_rotation(clutch, 0.1).N) > 1.5


def test_limits_are_met_at_their_torque_without_load_or_never(clutch):
    mu = 0.0555
    T = float(sprag_torque_limits(clutch, mu=mu, theta_max=0.5).slip)
    assert float(np.tan(at_torque(clutch, T).nu)) == pytest.approx(mu, rel=1e-10)
    assert slips(at_torque(clutch, [0.99 * T, 1.01 * T]), mu=mu).tolist() == [False, True]
    T = float(sprag_torque_limits(clutch, mu=0.12, theta_max=0.3).end_of_cam)
    assert float(at_torque(clutch, T).turned) == pytest.approx(0.3, rel=1e-10)
    found = sprag_torque_limits(clutch, mu=[0.05, 0.3], theta_max=0.5)
    assert found.slip.tolist() == [0.0, np.inf]
    assert found.torque.tolist() == [0.0, float(found.end_of_cam)]

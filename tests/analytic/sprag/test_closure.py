"""The explicit closure against sprags drawn point by point, and against an iteration."""

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

from analytic.sprag.closure import at_rotation, at_torque, wedged
from analytic.sprag.clutch import Clutch
from analytic.sprag.compliance import Compliance
from analytic.sprag.geometry import LogSprag
from analytic.sprag.parts import Parts

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


def test_forces_act_where_eq_9_has_a_and_b(clutch):
    now, y = wedged(clutch, N), clutch.compliance.yields(N)
    inner, outer = now.OA, now.OB
    assert inner == pytest.approx(11.11e-3 - y.race_i - y.contact_i / 2, rel=1e-14)
    assert outer == pytest.approx(19.44e-3 + y.race_e + y.contact_e / 2, rel=1e-14)
    whole = y.race_e + y.contact_e + y.sprag / 2
    assert now.OC_e == pytest.approx(float(clutch.sprag.OC_e) + whole, rel=1e-14)


def test_explicit_and_iterated_closure_agree(clutch):
    """Eq. 11 as an iteration: the load under which the drawn sprag yields as far as it overlaps."""
    for load in (500.0, 3407.0):
        alpha_b = float(wedged(clutch, load).alpha_b)

        def lack(N, alpha_b=alpha_b):
            y = clutch.compliance.yields(N)
            OA_s, _ = nearest(clutch.sprag, clutch.sprag.OC_e + y.outer, alpha_b)
            return float(11.11e-3 - y.inner - OA_s)

        assert brentq(lack, 10.0, 2e4, xtol=1e-9) == pytest.approx(load, rel=1e-6)


def test_two_forces_in_one_line_hold_the_sprag(clutch):
    """Balance of forces and moments from vectors at A and B."""
    now = wedged(clutch, N)
    zero = np.zeros_like(N)
    A = np.array([now.OA * np.sin(now.beta), now.OA * np.cos(now.beta)])
    B = np.array([zero, now.OB])
    inward_A, drive_A = A / now.OA, np.array([-np.cos(now.beta), np.sin(now.beta)])
    at_A = now.N * inward_A + now.T_i * drive_A
    at_B = np.array([now.T_e, -now.N_e])  # the outer race holds back, to the right
    assert np.abs(at_A + at_B).max() < 1e-9
    moment = A[0] * at_A[1] - A[1] * at_A[0] + B[0] * at_B[1] - B[1] * at_B[0]
    assert np.abs(moment).max() < 1e-12
    on_race = A[0] * at_A[1] - A[1] * at_A[0]
    assert pytest.approx(12 * on_race, rel=1e-12) == now.T


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


def test_torque_and_rotation_lead_back_to_the_load(clutch, plane_clutch):
    for some in (clutch, plane_clutch):
        now = wedged(some, N)
        assert pytest.approx(N, rel=1e-12) == at_torque(some, now.T).N
        assert pytest.approx(N, rel=1e-11) == at_rotation(some, now.alpha).N


def test_without_torque_or_before_contact_there_is_no_load(clutch):
    assert float(at_torque(clutch, 0.0).N) == 0.0
    assert at_rotation(clutch, [-0.1, 0.0]).N.tolist() == [0.0, 0.0]
    assert float(wedged(clutch, 0.0).alpha) == pytest.approx(0.0, abs=1e-13)


def test_a_race_that_rotates_makes_the_sprag_follow_before_it_bears(parts):
    stiff = parts.palmgren()
    grown = Clutch(
        sprag=parts.sprag, n_s=12,
        compliance=Compliance(
            contact_i=stiff.contact_i, contact_e=stiff.contact_e, race_i=0.0, race_e=0.0,
            sprag=0.0, d_ce=5e-6,
        ),
    )  # fmt: skip
    first = float(wedged(grown, 0.0).alpha)
    assert first > 0.01
    assert at_rotation(grown, [0.9 * first, 1.1 * first]).N.tolist()[0] == 0.0
    assert float(at_rotation(grown, 1.1 * first).N) > 0


def test_a_rigid_clutch_does_not_turn(sprag):
    def rigid(N):
        return 0.0 * N

    hard = Compliance(contact_i=rigid, contact_e=rigid, race_i=0.0, race_e=0.0, sprag=0.0)
    now = wedged(Clutch(sprag=sprag, n_s=12, compliance=hard), N)
    assert np.abs(now.alpha).max() < 1e-12
    assert now.nu == pytest.approx(float(sprag.nu_0), rel=1e-12)


def test_rigid_races_need_more_force_at_the_same_rotation(clutch):
    stiff = at_rotation(clutch.rigid_races(), 0.1).N
    assert float(stiff / at_rotation(clutch, 0.1).N) > 1.5


def test_the_less_the_spiral_grows_the_further_it_turns():
    """Alpha times m becomes constant: ln(rho/rho_0) is what the yields ask for."""
    turns = []
    for m in (0.02, 0.01, 0.005):
        sprag = LogSprag(R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3, m=m)
        parts = Parts(
            sprag=sprag, n_s=12, l=9e-3, b=4e-3, R_id=7.21e-3, R_ed=26.23e-3, E=206e9, nu=0.3
        )  # fmt: skip
        some = Clutch(sprag=sprag, n_s=12, compliance=parts.palmgren())
        turns.append(m * float(wedged(some, 1000.0).alpha_b))
    assert turns[1:] == pytest.approx(turns[:-1], rel=2e-3)


def test_yields_beyond_the_clutch_s_size_have_no_state(clutch):
    assert np.isnan(wedged(clutch, 1e8).T)
    assert np.isnan(at_torque(clutch, 1e9).N)


def test_many_sprags_and_loads_are_solved_at_once(parts):
    nu_0 = np.radians([2.5, 3.0, 3.5])
    sprags = LogSprag.from_wedge_angle(nu_0=nu_0, R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3)
    law = parts.palmgren()
    swept = at_torque(Clutch(sprag=sprags, n_s=12, compliance=law), [[10.0], [25.0]]).N
    one = LogSprag.from_wedge_angle(nu_0=nu_0[1], R_i=11.11e-3, R_e=19.44e-3, r_i=4.02e-3)
    alone = at_torque(Clutch(sprag=one, n_s=12, compliance=law), 25.0).N
    assert swept.shape == (2, 3)
    assert swept[1, 1] == pytest.approx(float(alone), rel=1e-12)


def test_wrong_loads_are_refused(clutch):
    for call, told in ((wedged, "normal force"), (at_torque, "torque")):
        with pytest.raises(ValueError, match=told):
            call(clutch, -1.0)
    with pytest.raises(ValueError, match="rotation alpha"):
        at_rotation(clutch, np.nan)

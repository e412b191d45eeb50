"""Motions and initial states; the closure in a table; Eqs. 12 to 16 as printed."""

import numpy as np
import pytest
from scipy.integrate import cumulative_trapezoid

from analytic.sprag.closure import wedged
from analytic.sprag.events import Sprag
from analytic.sprag.motion import Speeds
from analytic.sprag.rest import at_rest
from analytic.sprag.start import spring_equilibrium


def test_the_start_is_the_blades_equilibrium(table, clutch, motion):
    """Against the closed form: N_0 = 8 N, and the outer race's spring holds T_e."""
    now, T_e = spring_equilibrium(clutch, K_r=motion.K_r, alpha_max=motion.alpha_max)
    start = at_rest(table, motion, Speeds(inner=-3.0))
    assert float(table.at(start[3])["N"]) == pytest.approx(float(now.N), rel=1e-7)
    assert start[3] == pytest.approx(float(now.alpha), rel=1e-5)
    assert start[1] == pytest.approx(float(12 * now.OB * T_e / motion.k_out), rel=1e-6)
    assert start[4:].tolist() == [-3.0, 0.0, 0.0, 0.0]


QUICK = {"duration": 0.06}


@pytest.fixture
def locked(engaged):
    return engaged(25.0, **QUICK)


def test_the_printed_sign_of_the_spring_opens_the_clutch(engaged, motion):
    """Eq. 14 prints, mirrored to N > 0 for alpha > 0, the moment -K_r (alpha_max - alpha)."""
    right = engaged(25.0)
    printed = engaged(25.0, alpha_max=-motion.alpha_max)
    assert right.N[0] > 1.0
    assert right.verdict == "locks"
    assert printed.N_max == 0.0
    assert printed.verdict == "disengages"


def test_eq_14_is_at_rest_under_the_strut_s_forces_with_h_i_for_h(clutch):
    """Both lines vanish with T_i = N tan(nu), T_e = N tan(omega), but for N_e = N_i."""
    now = wedged(clutch, 3407.0)
    N, T_i, T_e = now.N, now.T_i, now.N * np.tan(now.omega)
    a, g = now.beta + now.gamma, now.gamma
    along = -N * np.sin(a) + T_i * np.cos(a) + N * np.sin(g) - T_e * np.cos(g)
    moment = now.b_i * T_i + now.b_e * T_e - (now.h_i - now.h_e) * N
    assert abs(float(along)) < 1e-3 * T_i
    assert abs(float(moment)) < 1e-3 * T_i * now.OB
    without = now.b_i * T_i + now.b_e * T_e + now.h_e * N  # no h_i, as it is printed
    assert abs(float(without)) > 100 * abs(float(moment))


def test_mass_times_acceleration_is_a_force_only_without_gravity(locked, table, motion):
    """Second line of Eq. 14 from the recorded history: m_g OC_g phi'' closes it, m g OC_g not."""
    phi = np.gradient(locked.states[:, 6], locked.dt)
    g = table.at(locked.alpha)
    c_i, c_e = g["OA"] + g["b_i"], g["OB"] - g["b_e"]
    moment = c_i * locked.T_i - c_e * locked.T_e - g["h"] * locked.N
    inner = slice(20, -20)
    right = motion.m_g * g["OC_g"] ** 2 * phi
    scale = float(np.abs(right).max())
    assert float(np.abs(moment - right)[inner].max()) < 0.02 * scale
    assert float(np.abs(moment - 9.81 * right)[inner].max()) > scale


def test_forces_at_the_rims_have_the_rims_lever_arms(engaged, table, motion):
    """At rest n_s T_i OA is the torque; with the printed halves T_i would be twice as large.

    On the outer race 0.2 % is lacking: the blades' moment, which Eq. 16 gives to no race.
    """
    rest = engaged(25.0, duration=0.3, dt=2e-5, C_rl=3.0)
    blades = motion.K_r * (motion.alpha_max - rest.alpha[-1])
    OA, OB = (float(table.at(rest.alpha[-1])[name]) for name in ("OA", "OB"))
    assert 12 * rest.T_i[-1] * OA == pytest.approx(25.0, rel=1e-4)
    assert 12 * rest.T_e[-1] * OB == pytest.approx(25.0 - 12 * blades, rel=2e-5)


def test_a_constant_torque_cannot_hold_the_outer_race(locked, table, motion):
    """Under the recorded contact forces -25 N m would turn it a thousand times as far."""
    OB = table.at(locked.alpha)["OB"]
    unbalanced = (12 * OB * locked.T_e - 25.0) / motion.I_be
    turned = cumulative_trapezoid(
        cumulative_trapezoid(unbalanced, locked.t, initial=0), locked.t, initial=0
    )
    assert np.abs(turned).max() > 100 * np.abs(locked.theta_e).max()
    held = motion.k_out * np.abs(locked.theta_e).max()
    assert held > 1.5 * 25.0  # the spring's moment follows the contact force


def test_the_damping_between_the_races_is_what_dissipates(engaged, motion):
    """C_rl of Table 1 (Eq. 16 prints C_ri): half of it, half of the logarithmic decrement."""

    def decay(**other):
        run = engaged(25.0, duration=0.06, **other)
        N = run.N - run.N_static
        tops = np.flatnonzero((N[1:-1] > N[:-2]) & (N[1:-1] >= N[2:]) & (N[1:-1] > 0)) + 1
        main = tops[N[tops] > 0.2 * N[tops].max()][:2]
        return float(np.log(N[main[0]] / N[main[1]]))

    assert decay(C_rl=0.05) == pytest.approx(decay() / 2, rel=0.15)


def test_the_table_has_the_closures_states_between_its_knots(table, clutch):
    N = np.array([0.5, 8.0, 333.0, 3407.0, 9956.0])
    now = wedged(clutch, N)
    found = table.at(now.alpha)
    expected = {"N": N, "OA": now.OA, "OB": now.OB, "OC_g": now.OC_g, "b_i": now.b_i,
                "b_e": now.b_e, "h": now.h_i - now.h_e}  # fmt: skip
    for name, value in expected.items():
        scale = np.maximum(np.abs(value), 1e-3 * np.abs(value).max())
        np.testing.assert_allclose(found[name] / scale, value / scale, rtol=0, atol=3e-7)


def test_with_both_normal_forces_the_moment_about_the_centroid_is_zero(clutch):
    """b_i T_i + b_e T_e = h N with T_i = N tan(nu), T_e = N_e tan(omega): both forces along AB."""
    states = wedged(clutch, 10e3 * np.linspace(0, 1, 101) ** 2)
    one = Sprag(states, 12, balanced=True)
    for k in (20, 60, 90):
        (N, _, _, _, b_i, b_e, h), _ = one.at(float(states.alpha[k] - states.alpha[0]))
        moment = b_i * N * np.tan(states.nu[k]) + b_e * states.T_e[k]
        assert h * N == pytest.approx(float(moment), rel=1e-9)

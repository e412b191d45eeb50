"""The band of sliding speeds in which contacts may stick: wide enough, or refused."""

import numpy as np
import pytest

from analytic.sprag.engagement import APART, SLIP, STICK, Contacts, Law, both, friction, phase
from analytic.sprag.motion import Speeds
from analytic.sprag.transient import NarrowBandError

LIGHT = {"alpha_max": 0.02}  # the blades press with 0.4 N: the sprag slips at the start
WRONG = {"D_V": 1e-3, **LIGHT}  # at 40 N m with steps of 1e-5 s


def test_a_band_too_narrow_loses_more_than_half_of_the_force_and_nothing_tells(engaged):
    """What the guard is for; the right force comes from events, see test_events."""
    wrong, right = engaged(40.0, **WRONG, guard=False), engaged(40.0, **LIGHT)
    assert wrong.N_max < 0.5 * right.N_max
    assert np.mean((wrong.phases[-len(wrong.t) // 4 :] == SLIP).any(axis=1)) > 0.5
    assert wrong.verdict != "locks"
    assert right.verdict == "locks"


def test_the_guard_refuses_it_and_says_what_would_do(engaged):
    with pytest.raises(NarrowBandError) as refused:
        engaged(40.0, **WRONG)
    said, change = str(refused.value), refused.value.change
    assert "\n" not in said
    assert f"{change:.4g} m/s in one step ({change / 1e-5:.4g} m/s² x dt=1e-05 s)" in said
    assert "passes D_V=0.001 m/s unseen" in said
    right = engaged(40.0, **LIGHT)
    wide = engaged(40.0, **LIGHT, D_V=2.0 * change)
    assert wide.N_max == pytest.approx(right.N_max, rel=1e-4)


def test_shorter_steps_cure_it_as_well(engaged):
    right = engaged(40.0, **LIGHT)
    short = engaged(40.0, **LIGHT, D_V=1e-2, dt=1e-6)
    assert short.N_max == pytest.approx(right.N_max, rel=1e-4)


def test_the_band_chosen_is_wide_enough_and_wider_ones_change_nothing(engaged):
    chosen = engaged(40.0, **LIGHT)
    for D_V in (chosen.D_V, 1.0, 100.0):
        run = engaged(40.0, **LIGHT, D_V=D_V)
        assert run.N_max == pytest.approx(chosen.N_max, rel=1e-5)


def test_the_band_grows_where_it_was_too_narrow(engaged):
    """A race that arrives at 10 rad/s: its contact must stop from 0.1 m/s, not from rest."""
    arriving = engaged(25.0, speeds=Speeds(inner=10.0)).D_V
    resting = engaged(25.0).D_V
    assert resting == pytest.approx(2 * 25.0 / 1.41e-3 * 11.11e-3 * 1e-5, rel=1e-9)
    assert arriving > 5 * resting


def test_the_acceleration_from_rest_is_no_measure_for_a_race_that_arrives(engaged):
    """Ten times OA C/I_bi dt: at 10 rad/s two thirds of the force would be lost."""
    arriving = {"speeds": Speeds(inner=10.0), "duration": 0.02}
    narrow = {"D_V": 10 * 5.0 / 1.41e-3 * 11.11e-3 * 1e-5, **arriving}
    right = engaged(5.0, **arriving)
    assert engaged(5.0, **narrow, guard=False).N_max < 0.4 * right.N_max
    with pytest.raises(NarrowBandError):
        engaged(5.0, **narrow)


def test_friction_that_changes_its_sign_within_a_step_is_seen_too(engaged):
    """The sliding keeps its sign from step to step, its stages do not: 83 % of the force lost."""
    narrow = {"dt": 2e-5, "D_V": 3e-4, **LIGHT}
    wrong, right = engaged(25.0, **narrow, guard=False), engaged(25.0, **LIGHT)
    assert wrong.N_max < 0.5 * right.N_max
    with pytest.raises(NarrowBandError):
        engaged(25.0, **narrow)


@pytest.mark.parametrize("dt", [2e-6, 1e-5, 2e-5])
@pytest.mark.parametrize("D_V", [1e-4, 1e-3, 1e-2, 0.1])
@pytest.mark.parametrize("mu", [0.06, 0.12, 0.3])
def test_what_the_guard_lets_pass_is_right(engaged, mu, D_V, dt):
    """Within 1e-3 of the answer with the band chosen, at 15 and at 40 N m."""
    for torque in (15.0, 40.0):
        other = {**LIGHT, "mu_s": mu, "mu_c": 0.7 * mu}
        try:
            run = engaged(torque, dt=dt, D_V=D_V, **other)
        except NarrowBandError:
            continue
        assert run.N_max == pytest.approx(engaged(torque, **other).N_max, rel=1e-3)


def law(**other):
    values = dict.fromkeys(Law._fields, 1.0)
    return Law(**{**values, "D_V": 0.1, "tau": 1e-5, **other})


def contacts(**other):
    values = {"v_i": 0.0, "v_e": 0.0, "d_i": 0.0, "d_e": 0.0, "a_ii": 2.0, "a_ie": 0.5,
              "a_ee": 1.0, "most_i": 1.0, "most_e": 1.0}  # fmt: skip
    return Contacts(**{**values, **other})


def test_two_contacts_that_stick_take_the_forces_that_keep_them_at_rest():
    T = np.array(friction(contacts(d_i=1.0, d_e=0.6), law()))
    np.testing.assert_allclose(np.array([[2.0, 0.5], [0.5, 1.0]]) @ T, [1.0, 0.6], rtol=1e-14)


def test_the_branches_of_friction_join_at_rest_and_at_the_band_s_edge():
    """Eq. 12 with T_bis = mu_s N: no jump from slip to stick, either way round."""
    pulled = {"d_i": 1e3, "a_ie": 0.0}
    stuck, _ = friction(contacts(**pulled), law())
    slid, _ = friction(contacts(**pulled, v_i=1.0), law())
    assert stuck == slid == 1.0
    for v in (0.0999, 0.1001):
        assert friction(contacts(**pulled, v_i=v), law())[0] == 1.0
        assert friction(contacts(d_i=-1e3, a_ie=0.0, v_i=-v), law())[0] == -1.0


def test_bounded_forces_are_the_best_in_the_box():
    """Against many points of the box; d - a T then points out of it."""
    rng = np.random.default_rng(1)
    side = np.linspace(-1, 1, 201)
    x, y = (p.ravel() for p in np.meshgrid(side, side))
    for _ in range(50):
        d_i, d_e = rng.normal(scale=4.0, size=2)
        root = rng.normal(size=(2, 2))
        a = root @ root.T + 0.1 * np.eye(2)
        c = contacts(a_ii=a[0, 0], a_ie=a[0, 1], a_ee=a[1, 1], most_i=0.5, most_e=2.0)

        def cost(T_i, T_e, a=a, d_i=d_i, d_e=d_e):
            square = a[0, 0] * T_i**2 / 2 + a[0, 1] * T_i * T_e + a[1, 1] * T_e**2 / 2
            return square - d_i * T_i - d_e * T_e

        T_i, T_e = both(c, d_i, d_e)
        assert abs(T_i) <= 0.5
        assert abs(T_e) <= 2.0
        assert cost(T_i, T_e) <= cost(0.5 * x, 2.0 * y).min() + 1e-12


def test_phases_tell_contact_rolling_and_sliding():
    assert phase(0.0, 0.0, 0.0, 0.0, 0.1) == APART
    assert phase(5.0, 0.05, 0.3, 0.6, 0.1) == STICK
    assert phase(5.0, 0.05, 0.6, 0.6, 0.1) == SLIP
    assert phase(5.0, 0.20, 0.3, 0.6, 0.1) == SLIP

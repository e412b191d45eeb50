"""The band of sliding speeds in which contacts may stick, and the branches of friction."""

import numpy as np
import pytest
from numba.core.caching import CacheImpl

from analytic.sprag.engagement import (
    OPEN,
    SLIP,
    STICK,
    Contacts,
    Law,
    both,
    compiled,
    friction,
    phase,
)
from analytic.sprag.friction import coefficient, static_limit
from analytic.sprag.motion import Speeds
from analytic.sprag.transient import NarrowBandError

LIGHT = {"alpha_max": 0.02}  # the springs press with 0.4 N: the sprag slips at the start
WRONG = {"D_V": 1e-3, **LIGHT}  # at 40 N m with steps of 1e-5 s


def test_the_guard_refuses_it_and_states_a_sufficient_step(engaged):
    with pytest.raises(NarrowBandError) as refused:
        engaged(40.0, **WRONG)
    message, change = str(refused.value), refused.value.change
    assert "\n" not in message
    assert f"{change:.4g} m/s in one step ({change / 1e-5:.4g} m/s² x dt=1e-05 s)" in message
    assert "passes the band of D_V=0.001 m/s" in message
    right = engaged(40.0, **LIGHT)
    wide = engaged(40.0, **LIGHT, D_V=2.0 * change)
    assert wide.N_max == pytest.approx(right.N_max, rel=1e-4)


def law(**other):
    values = dict.fromkeys(Law._fields, 1.0)
    return Law(**{**values, "D_V": 0.1, "tau": 1e-5, **other})


def contacts(**other):
    values = {"v_i": 0.0, "v_e": 0.0, "d_i": 0.0, "d_e": 0.0, "a_ii": 2.0, "a_ie": 0.5,
              "a_ee": 1.0, "most_i": 1.0, "most_e": 1.0}  # fmt: skip
    return Contacts(**{**values, **other})


def test_the_branches_of_friction_join_at_rest_and_at_the_band_s_edge():
    """Eq. 12 with T_bis = mu_s N: no jump from slip to stick, in both directions."""
    pulled = {"d_i": 1e3, "a_ie": 0.0}
    stuck, _ = friction(contacts(**pulled), law())
    slid, _ = friction(contacts(**pulled, v_i=1.0), law())
    assert stuck == slid == 1.0
    for v in (0.0999, 0.1001):
        assert friction(contacts(**pulled, v_i=v), law())[0] == 1.0
        assert friction(contacts(d_i=-1e3, a_ie=0.0, v_i=-v), law())[0] == -1.0


def test_eq_13_by_hand_for_many_speeds():
    found = coefficient([0.0, 1.0, -1.0, 1e3], mu_c=0.08, mu_s=0.12, gamma_b=1.0)
    fall = 0.04 * np.exp(-1)
    assert found.tolist() == pytest.approx([0.12, 0.08 + fall, 0.08 + fall, 0.08], rel=1e-12)


def test_the_branches_of_eq_12_join_at_the_static_limit():
    at_rest = coefficient(0.0, mu_c=0.08, mu_s=0.12, gamma_b=1.0) * 250.0
    assert float(static_limit(N=250.0, mu_s=0.12)) == pytest.approx(float(at_rest))


def doubled(x: float) -> float:
    return 2.0 * x


def test_where_no_folder_can_be_written_code_is_compiled_again(monkeypatch):
    monkeypatch.setattr(CacheImpl, "_locator_classes", [])
    assert compiled(doubled)(2.0) == 4.0


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


def test_phases_distinguish_contact_rolling_and_sliding():
    assert phase(0.0, 0.0, 0.0, 0.0, 0.1) == OPEN
    assert phase(5.0, 0.05, 0.3, 0.6, 0.1) == STICK
    assert phase(5.0, 0.05, 0.6, 0.6, 0.1) == SLIP
    assert phase(5.0, 0.20, 0.3, 0.6, 0.1) == SLIP


def test_the_band_grows_where_it_was_too_narrow(engaged):
    """A race that arrives at 10 rad/s: its contact must stop from 0.1 m/s, not from rest."""
    arriving = engaged(25.0, speeds=Speeds(inner=10.0)).D_V
    resting = engaged(25.0).D_V
    assert resting == pytest.approx(2 * 25.0 / 1.41e-3 * 11.11e-3 * 1e-5, rel=1e-9)
    assert arriving > 5 * resting

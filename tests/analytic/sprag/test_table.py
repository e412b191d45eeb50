"""The closure tabulated over the rotation: nothing lost, nothing told beyond the end."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.sprag.closure import at_rotation, wedged
from analytic.sprag.course import energy
from analytic.sprag.table import table as tabled
from analytic.sprag.table import tabulated


def test_the_table_tells_the_closures_states_between_its_knots(table, clutch):
    N = np.array([0.5, 8.0, 333.0, 3407.0, 9956.0])
    now = wedged(clutch, N)
    told = table.at(now.alpha)
    expected = {"N": N, "OA": now.OA, "OB": now.OB, "OC_g": now.OC_g, "b_i": now.b_i,
                "b_e": now.b_e, "h": now.h_i - now.h_e}  # fmt: skip
    for name, value in expected.items():
        scale = np.maximum(np.abs(value), 1e-3 * np.abs(value).max())
        np.testing.assert_allclose(told[name] / scale, value / scale, rtol=0, atol=3e-7)


def test_the_motions_elastic_energy_is_the_yields_but_for_the_terms_left_out(table, clutch):
    """U = int N dH against int N h dalpha: 1.3e-5 at 1 kN, less above."""
    N = np.array([1000.0, 3407.0, 9956.0])
    W = table.at(wedged(clutch, N).alpha)["W"]
    np.testing.assert_allclose(W, energy(clutch, N), rtol=2e-5)


def test_at_rest_the_motion_asks_for_the_struts_friction_but_for_equal_normal_forces(table, clutch):
    """N_e = N_i instead of the strut's N_e = N_i cos(omega)/cos(nu): 4e-4."""
    now = wedged(clutch, np.array([8.0, 3407.0, 9956.0]))
    excess = table.static_ratio(now.alpha) / np.tan(now.nu) - 1
    assert np.all((excess > -5.5e-4) & (excess < -3.5e-4))
    np.testing.assert_allclose(table.static_torque(now.alpha), now.T, rtol=6e-4)


def test_beyond_the_end_nothing_is_told_and_before_contact_there_is_no_force(table):
    assert np.isnan(table.at(table.end * 1.001)["N"])
    before, first = table.at(-0.1), table.at(0.0)
    assert before["N"] == 0
    assert before["OA"] == first["OA"]


def test_the_table_ends_with_the_spiral(clutch):
    short = tabulated(clutch, N_end=20e3, theta_max=0.2)
    end = at_rotation(clutch, short.end)
    assert float(end.turned) == pytest.approx(0.2, rel=1e-9)


def test_states_that_turn_back_make_no_table():
    x = np.linspace(0, 1, 50)
    columns = dict.fromkeys(("OA", "OB", "OC_g", "beta", "gamma"), x + 1)
    with pytest.raises(ValueError, match="rise in N and alpha"):
        tabled(n_s=3, alpha=x * (1 - x), N=x, **columns)
    with pytest.raises(ValueError, match="begin at N = 0"):
        tabled(n_s=3, alpha=x, N=x + 1, **columns)


def test_a_table_without_room_says_so(clutch):
    with pytest.raises(ValueError, match="no state"):
        tabulated(clutch, N_end=20e3, theta_max=1e-9)
    with pytest.raises(ValueError, match="normal force at the end must be positive"):
        tabulated(clutch, N_end=0.0)


def test_a_centroid_given_along_one_axis_alone_stays_where_it_was_along_the_other(clutch):
    x, y = clutch.centroid
    assert replace(clutch, c_x=1e-3).centroid == (1e-3, y)
    assert replace(clutch, c_y=1e-3).centroid == (x, 1e-3)


def test_with_balanced_normal_forces_the_motion_rests_exactly_as_the_strut(clutch):
    """Wherever the centroid is; with N_e = N_i half a millimetre changes the force by 1.4e-3."""
    T_i, paper = [], []
    for c_x in (-0.4e-3, 0.1e-3, 0.6e-3):
        moved = replace(clutch, c_x=c_x)
        alpha = wedged(moved, 3407.0).alpha
        T_i.append(float(tabulated(moved, N_end=20e3, balanced=True).static_ratio(alpha)))
        paper.append(float(tabulated(moved, N_end=20e3).static_ratio(alpha)))
    np.testing.assert_allclose(T_i, np.tan(wedged(clutch, 3407.0).nu), rtol=1e-9)
    assert np.ptp(paper) / paper[1] == pytest.approx(2.8e-3, rel=0.05)

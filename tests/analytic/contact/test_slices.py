"""Rollers by slices, coupled or not: hand values, complementarity, Palmgren's law, weights."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import dblquad

from analytic.contact import crown, hertz_line, lamina, palmgren, slice_pivoting, slices
from analytic.contact.slice_compliance import compliance_matrix, love

ROLLER = {"length": 9e-3, "R": 2.952e-3, "E_star": 206e9 / 1.82}  # the paper's, on its inner race
DESIGNS = {"25 N m": (2.1507, 0.6763, 12.1e-6), "best": (1, 0.7, 1e-5), "worst": (5, 0.7, 1.5e-5)}


def crowned(design="25 N m", slices=50, tilt=0.0):
    K_1, K_2, z_m = DESIGNS[design]
    y = crown.slice_centres(length=9e-3, slices=slices)
    steel = {"load": 3400.0, "length": 9e-3, "E_star": ROLLER["E_star"]}
    return crown.logarithmic(y, K_1=K_1, K_2=K_2, z_m=z_m, **steel) + tilt * y


def matrix(load, n):
    """S, written a second time."""
    b = float(hertz_line.half_width(P=load / 9e-3, R=ROLLER["R"], E_star=ROLLER["E_star"]))
    D, j = 9e-3 / n, np.arange(n)
    w = love(np.abs(j[:, None] - j) * D, D, b)
    return n * float(palmgren.compliance(length=9e-3, slices=n)) * w / w.sum()


@pytest.mark.parametrize("design", DESIGNS)
@pytest.mark.parametrize("tilt", [0.0, 5e-4, -3e-3])
@pytest.mark.parametrize("load", [1.0, 300.0, 3400.0, 3e4])
def test_forces_and_gaps_are_complementary(design, tilt, load):
    z = crowned(design, tilt=tilt)
    contact = slices.press_slices(z, load=load, **ROLLER)
    q, delta = contact.force, float(contact.approach)
    after = z + (matrix(load, 50) @ q) ** 0.9 - delta
    assert float(contact.load) == pytest.approx(load, rel=1e-12)
    assert np.all(q >= 0)
    scale = delta - z.min()
    assert np.all(after >= -1e-10 * scale)
    np.testing.assert_allclose(after[q > 0], 0, atol=1e-10 * scale)
    if load <= 300:
        assert np.any(after > 1e-3 * scale)


def test_two_slices_by_hand():
    """S = [[2, 1], [1, 2]]: delta^(10/9) = 3 q with even gaps, 2 q with one slice out of reach."""
    w = [[2.0, 1.0], [1.0, 2.0]]
    roller = {"length": 1.0, "R": 1.0, "E_star": 1.0, "compliance": 3.0, "kernel": w}
    even = slices.press_slices([0.0, 0.0], load=2048.0 / 3, **roller)
    assert float(even.approach) == pytest.approx(512.0, rel=1e-12)
    np.testing.assert_allclose(even.force, 1024 / 3, rtol=1e-12)
    alone = slices.press_slices([0.0, 1e9], load=512.0, **roller)
    assert float(alone.approach) == pytest.approx(512.0, rel=1e-12)
    lifted = slices.press_slices([0.0, 511.0], load=512.0, **roller)  # 1 - 512 < 0: it would pull
    np.testing.assert_allclose(lifted.force, [512.0, 0.0], rtol=1e-12)
    assert lifted.carries.tolist() == [True, False]


@pytest.mark.parametrize("load", [1e-9, 10.0, 3400.0, 1e6])
@pytest.mark.parametrize("tilt", [0.0, 2e-3])
def test_pressing_to_the_approach_returns_the_load(load, tilt):
    z = crowned(tilt=tilt)
    z -= z.min()
    there = slices.press_slices(z, load=load, **ROLLER)
    back = slices.press_slices(z, approach=there.approach, **ROLLER)
    assert float(back.load) == pytest.approx(load, rel=1e-11)
    np.testing.assert_allclose(back.force, there.force, rtol=1e-8, atol=1e-11 * load)


def test_a_flat_rollers_approach_is_palmgrens_but_for_the_ends():
    """Summed over all slices the law is Palmgren's; the ends carry more at the same approach."""
    contact = slices.press_slices(np.zeros(50), load=3400.0, **ROLLER)
    expected = float(palmgren.approach(load=3400.0, length=9e-3))
    assert 0.98 < float(contact.approach) / expected < 1
    row_sums = matrix(3400.0, 50).sum(axis=1)
    assert row_sums[0] < 0.75 * row_sums[25]


def test_a_search_that_does_not_end_is_an_error(monkeypatch):
    monkeypatch.setattr(slice_pivoting, "PIVOTS", 1)
    with pytest.raises(ArithmeticError, match="not found in 1 pivot steps"):
        slices.press_slices(crowned(tilt=1e-3), load=300.0, **ROLLER)
    monkeypatch.undo()
    monkeypatch.setattr(slices, "ITERATIONS", 1)
    with pytest.raises(ArithmeticError, match="the approach for the given load did not converge"):
        slices.press_slices(crowned(), load=300.0, **ROLLER)
    with pytest.raises(
        ArithmeticError, match="the load at the given approach did not converge in 1"
    ):
        slices.press_slices(crowned(), approach=1e-6, **ROLLER)


@pytest.mark.parametrize("slices", [1, 50])
@pytest.mark.parametrize("load", [1e-6, 1e6])
def test_a_flat_roller_has_palmgrens_approach_and_an_even_load(slices, load):
    contact = lamina.press_laminae(np.full(slices, 2e-6), load=load, **ROLLER)
    expected = 2e-6 + palmgren.approach(load=load, length=9e-3)
    assert float(contact.approach) == pytest.approx(float(expected), rel=1e-13)
    np.testing.assert_allclose(contact.force, load / slices, rtol=1e-12)


def test_loves_weight_is_the_integral_of_the_inverse_distance():
    b, D = 0.3, 0.2
    for d in (0.25, 0.6, 3.0):
        expected, _ = dblquad(lambda x, y: 1 / np.hypot(x, y), d - D / 2, d + D / 2, -b, b)
        assert 2 * float(love(d, D, b)) == pytest.approx(expected, rel=1e-9)


@given(n=st.integers(1, 60), load=st.floats(1.0, 1e5))
@settings(deadline=None, max_examples=20)
def test_the_sum_of_s_is_n_s_whatever_the_weights(n, load):
    j = np.arange(n)
    for weights in (
        np.tri(n) @ np.tri(n).T,  # positive definite
        love(np.abs(j[:, None] - j) * 0.1, 0.1, 0.3),
    ):
        S = compliance_matrix(weights, compliance=load)
        assert float(S.sum()) == pytest.approx(n * load, rel=1e-12)
        np.testing.assert_allclose(S / S[0, 0], weights / weights[0, 0], rtol=1e-12)


def test_where_block_exchanges_cycle_single_exchanges_find_the_solution(monkeypatch):
    """Found by search: all leaving and coming back at once never ends for this S and f."""
    root = np.array([[-3.0, 0.0], [-3.0, 1.0], [-1.0, 3.0], [2.0, 2.0]])
    S, f = root @ root.T + 0.05 * np.eye(4), np.array([0.0, 3.0, 4.0, 5.0])
    q, _ = slice_pivoting.carried(S[None], f[None], f[None], np.ones((1, 4), dtype=bool))
    after = S @ q[0] - f
    assert np.all(q >= 0)
    assert np.all(after >= -1e-12)
    np.testing.assert_allclose(after * q[0], 0, atol=1e-12)
    monkeypatch.setattr(slice_pivoting, "PATIENCE", 10**9)
    with pytest.raises(ArithmeticError, match="the set of loaded slices was not found"):
        slice_pivoting.carried(S[None], f[None], f[None], np.ones((1, 4), dtype=bool))


def test_pressures_and_widths_are_hertzs_for_each_slice():
    contact = lamina.press_laminae(crowned(), load=3400.0, **ROLLER)
    on = {"P": contact.force * 50 / 9e-3, "R": ROLLER["R"], "E_star": ROLLER["E_star"]}
    np.testing.assert_allclose(contact.line_load, on["P"], rtol=1e-14)
    np.testing.assert_allclose(contact.peak_pressure, hertz_line.peak_pressure(**on), rtol=1e-13)
    np.testing.assert_allclose(contact.half_width, hertz_line.half_width(**on), rtol=1e-13)

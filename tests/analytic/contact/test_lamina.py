"""Uncoupled slices against Palmgren, closed forms, direct sums and their own inverse."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from analytic.contact import crown, hertz_line, lamina, palmgren

ROLLER = {"length": 9e-3, "R": 2.952e-3, "E_star": 206e9 / 1.82}  # the paper's, on its inner race
UNIT = {"length": 1.0, "R": 1.0, "E_star": 1.0, "compliance": 1.0}


def crowned(slices=50, tilt=0.0):
    y = crown.slice_centres(length=9e-3, slices=slices)
    design = {"K_1": 2.1507, "K_2": 0.6763, "z_m": 12.1e-6, "load": 3400.0}  # Eq. 21
    steel = {"length": 9e-3, "E_star": ROLLER["E_star"]}
    return crown.logarithmic(y, **design, **steel) + tilt * y


@pytest.mark.parametrize("slices", [1, 2, 50])
@pytest.mark.parametrize("load", [1e-6, 3400.0, 1e6])
def test_a_flat_roller_has_palmgrens_approach_and_an_even_load(slices, load):
    contact = lamina.press(np.full(slices, 2e-6), load=load, **ROLLER)
    expected = 2e-6 + palmgren.approach(load=load, length=9e-3)
    assert float(contact.approach) == pytest.approx(float(expected), rel=1e-13)
    np.testing.assert_allclose(contact.force, load / slices, rtol=1e-12)


def test_the_load_that_just_takes_the_second_slice_is_known():
    """Gaps 0 and 1: at delta = 1 the first carries 1; at delta = 513 they carry more by hand."""
    just = lamina.press([0.0, 1.0], load=1.0, **UNIT)
    assert float(just.approach) == pytest.approx(1.0, rel=1e-14)
    assert float(just.force[1]) == pytest.approx(0.0, abs=1e-14)
    both = lamina.press([0.0, 511.0], load=1025.0, **UNIT)  # 512^(10/9) + 1
    assert float(both.approach) == pytest.approx(512.0, rel=1e-14)
    np.testing.assert_allclose(both.force, [1024.0, 1.0], rtol=1e-11)


@settings(deadline=None)
@given(
    gap=st.lists(st.floats(-1e-4, 1e-4), min_size=1, max_size=20),
    load=st.floats(1e-6, 1e6),
)
def test_the_approach_is_that_of_a_bisection(gap, load):
    contact = lamina.press(gap, load=load, **ROLLER)
    s = float(palmgren.compliance(length=9e-3, slices=len(gap)))

    def surplus(above):
        return np.sum(np.maximum(above + min(gap) - np.array(gap), 0) ** (10 / 9)) / s - load

    top = (load * s) ** 0.9
    above = brentq(surplus, 0, 1.001 * top, xtol=1e-14 * top, rtol=1e-14)
    assert float(contact.approach) == pytest.approx(min(gap) + above, rel=1e-10, abs=1e-18)
    assert float(contact.load) == pytest.approx(load, rel=1e-12)


@settings(deadline=None)
@given(tilt=st.floats(-2e-3, 2e-3), load=st.floats(1e-9, 1e5))
def test_pressing_to_the_approach_returns_the_load(tilt, load):
    by_load = lamina.press(crowned(tilt=tilt), load=load, **ROLLER)
    under = float(by_load.approach - crowned(tilt=tilt).min())  # the approach's digits below zero
    again = lamina.press(crowned(tilt=tilt) - crowned(tilt=tilt).min(), approach=under, **ROLLER)
    rounding = 1e-14 * (1 + np.abs(crowned(tilt=tilt)).max() / under)
    assert float(again.load) == pytest.approx(load, rel=20 * rounding)


def test_only_slices_that_the_approach_reaches_carry():
    contact = lamina.press(crowned(tilt=1e-3), load=300.0, **ROLLER)
    reached = crowned(tilt=1e-3) < float(contact.approach)
    np.testing.assert_array_equal(contact.carries, reached)
    assert 0 < reached.sum() < 50
    assert np.all(contact.force >= 0)
    np.testing.assert_array_equal(contact.force[~reached], 0)
    np.testing.assert_array_equal(contact.peak_pressure[~reached], 0)


def test_an_approach_that_reaches_nothing_gives_no_force():
    for approach in (0.0, -1e-6):
        contact = lamina.press(crowned(), approach=approach, **ROLLER)
        assert float(contact.load) == 0
        assert not contact.carries.any()
        assert float(contact.approach) == approach


def test_a_symmetric_gap_carries_symmetrically_and_a_mirrored_one_mirrored():
    even = lamina.press(crowned(), load=3400.0, **ROLLER)
    np.testing.assert_allclose(even.force, even.force[::-1], rtol=1e-10)
    left, right = (lamina.press(crowned(tilt=t), load=3400.0, **ROLLER) for t in (1e-3, -1e-3))
    np.testing.assert_allclose(left.force, right.force[::-1], rtol=1e-9, atol=1e-10)
    assert left.force[0] > 2 * left.force[-1]  # the gap grows with y: -y carries more


def test_pressures_and_widths_are_hertzs_for_each_slice():
    contact = lamina.press(crowned(), load=3400.0, **ROLLER)
    on = {"P": contact.force * 50 / 9e-3, "R": ROLLER["R"], "E_star": ROLLER["E_star"]}
    np.testing.assert_allclose(contact.line_load, on["P"], rtol=1e-14)
    np.testing.assert_allclose(contact.peak_pressure, hertz_line.peak_pressure(**on), rtol=1e-13)
    np.testing.assert_allclose(contact.half_width, hertz_line.half_width(**on), rtol=1e-13)


def test_a_batch_is_its_cases_one_by_one_across_chunks():
    rng = np.random.default_rng(7)
    gap = crowned() + rng.uniform(-1e-3, 1e-3, (40, 50, 1)) * crown.slice_centres(
        length=9e-3, slices=50
    )
    load, R = 10 ** rng.uniform(0, 4, (40, 1)), rng.uniform(1e-3, 5e-3, 50)
    many = lamina.press(gap, load=load, **ROLLER | {"R": R})
    assert many.force.shape == (40, 50, 50)
    assert many.approach.shape == many.load.shape == (40, 50)
    for i, j in ((0, 0), (39, 49), (13, 14), (14, 0)):
        one = lamina.press(gap[i, j], load=load[i, 0], **ROLLER | {"R": R[j]})
        np.testing.assert_allclose(many.force[i, j], one.force, rtol=1e-11, atol=1e-12 * load[i, 0])
        np.testing.assert_allclose(many.peak_pressure[i, j].max(), one.peak_pressure.max())


def test_one_gap_serves_many_loads_and_many_gaps_one_load():
    loads = np.array([10.0, 1000.0])
    many = lamina.press(crowned(), load=loads, **ROLLER)
    np.testing.assert_allclose(many.load, loads, rtol=1e-13)
    gaps = np.stack([crowned(), crowned(tilt=1e-3), np.zeros(50)])
    np.testing.assert_allclose(lamina.press(gaps, load=5.0, **ROLLER).load, 5.0, rtol=1e-13)


@pytest.mark.parametrize("gap", [[0.0, 1e9], [0.0] + 30 * [1e9], [0.0, 1e-12, 1.0], [5.0, 5.0]])
@pytest.mark.parametrize("load", [1e-250, 1e-12, 1.0, 1e12])
def test_loads_and_gaps_of_any_size_are_solved(gap, load):
    contact = lamina.press(gap, load=load, **UNIT)
    assert float(contact.load) == pytest.approx(load, rel=1e-12)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"load": 0.0}, "load must be positive and finite, got 0.0 N"),
        ({"load": np.nan}, "load must be positive and finite, got nan N"),
        ({"load": None}, r"give the load \[N\] or the approach \[m\], one of the two"),
        ({"approach": 1e-6}, r"give the load \[N\] or the approach \[m\], one of the two"),
        ({"load": None, "approach": np.nan}, "approach must be finite, got nan m"),
        ({"gap": 0.0}, r"gap must have a height \[m\] for each slice, got shape \(\)"),
        ({"gap": []}, r"gap must have a height \[m\] for each slice, got shape \(0,\)"),
        ({"gap": [0.0, np.inf]}, "gap must be finite, got"),
        (
            {"gap": np.zeros((3, 5)), "load": [1.0, 2.0]},
            r"the gap's shape without its slices, \(3,\), .* \(2,\), must fit together",
        ),
        ({"length": -1.0}, "length must be positive and finite, got -1.0 m"),
        ({"R": 0.0}, "relative radius must be positive and finite, got 0.0 m"),
        ({"E_star": np.inf}, "contact modulus must be positive and finite, got inf Pa"),
        ({"compliance": 0.0}, r"compliance of a slice .* got 0.0 m\^\(10/9\)/N"),
    ],
)
def test_contacts_that_make_no_sense_are_refused(change, message):
    arguments = {"gap": [0.0, 1e-6], "load": 100.0, **ROLLER, **change}
    with pytest.raises(ValueError, match=message):
        lamina.press(arguments.pop("gap"), **arguments)


def test_with_its_own_compliance_the_model_is_dimensionally_homogeneous():
    k, s = 1e3, 1e-6  # mm, MPa
    compliance = 1.0e-9
    here = lamina.press(crowned(tilt=1e-3), load=500.0, compliance=compliance, **ROLLER)
    there = lamina.press(
        crowned(tilt=1e-3) * k, load=500.0 * s * k**2, length=9e-3 * k, R=ROLLER["R"] * k,
        E_star=ROLLER["E_star"] * s, compliance=compliance * k ** (10 / 9) / (s * k**2),
    )  # fmt: skip
    assert float(there.approach) == pytest.approx(float(here.approach) * k, rel=1e-12)
    np.testing.assert_allclose(there.force, here.force * s * k**2, rtol=1e-10, atol=1e-9)
    np.testing.assert_allclose(there.peak_pressure, here.peak_pressure * s, rtol=1e-10, atol=1e-3)
    np.testing.assert_allclose(there.half_width, here.half_width * k, rtol=1e-10, atol=1e-7)

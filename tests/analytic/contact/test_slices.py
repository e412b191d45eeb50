"""Coupled slices against hand values, quadrature, optimality and their own inverse."""

import numpy as np
import pytest

from analytic.contact import crown, hertz_line, lamina, palmgren, slice_pivoting, slices
from analytic.contact.slice_compliance import love

ROLLER = {"length": 9e-3, "R": 2.952e-3, "E_star": 206e9 / 1.82}  # the paper's, on its inner race
DESIGNS = {"25 N m": (2.1507, 0.6763, 12.1e-6), "best": (1, 0.7, 1e-5), "worst": (5, 0.7, 1.5e-5)}


def crowned(design="25 N m", slices=50, tilt=0.0):
    K_1, K_2, z_m = DESIGNS[design]
    y = crown.slice_centres(length=9e-3, slices=slices)
    steel = {"load": 3400.0, "length": 9e-3, "E_star": ROLLER["E_star"]}
    return crown.logarithmic(y, K_1=K_1, K_2=K_2, z_m=z_m, **steel) + tilt * y


def matrix(load, n):
    """S written out anew."""
    b = float(hertz_line.half_width(P=load / 9e-3, R=ROLLER["R"], E_star=ROLLER["E_star"]))
    D, j = 9e-3 / n, np.arange(n)
    w = love(np.abs(j[:, None] - j) * D, D, b)
    return n * float(palmgren.compliance(length=9e-3, slices=n)) * w / w.sum()


@pytest.mark.parametrize("design", DESIGNS)
@pytest.mark.parametrize("tilt", [0.0, 5e-4, -3e-3])
@pytest.mark.parametrize("load", [1.0, 300.0, 3400.0, 3e4])
def test_forces_and_gaps_are_complementary(design, tilt, load):
    z = crowned(design, tilt=tilt)
    contact = slices.press(z, load=load, **ROLLER)
    q, delta = contact.force, float(contact.approach)
    after = z + (matrix(load, 50) @ q) ** 0.9 - delta
    assert float(contact.load) == pytest.approx(load, rel=1e-12)
    assert np.all(q >= 0)
    scale = delta - z.min()
    assert np.all(after >= -1e-10 * scale)
    np.testing.assert_allclose(after[q > 0], 0, atol=1e-10 * scale)
    if load <= 300:
        assert np.any(after > 1e-3 * scale)


def test_slices_about_to_touch_or_to_leave_are_on_the_right_side():
    """A sweep of loads in small steps, so that some slices are caught within 1e-4 of touching."""
    z, loads = crowned("worst", tilt=1e-3), np.geomspace(1.0, 3e4, 400)
    contact = slices.press(z, load=loads, **ROLLER)
    S = np.stack([matrix(load, 50) for load in loads])
    deflection = np.einsum("ijk,ik->ij", S, contact.force) ** 0.9
    scale = (contact.approach - z.min())[:, None]
    after = (z + deflection - contact.approach[:, None]) / scale
    assert np.all(after >= -1e-10)
    assert np.all(np.abs(after[contact.carries]) <= 1e-10)
    assert np.any((after > 1e-10) & (after < 1e-4))


def test_newtons_slope_is_right_a_few_steps_are_enough(monkeypatch):
    monkeypatch.setattr(slices, "ITERATIONS", 9)
    loads = np.geomspace(1.0, 3e4, 100)
    contact = slices.press(crowned(tilt=1e-3), load=loads, **ROLLER)
    np.testing.assert_allclose(contact.load, loads, rtol=1e-12)


def test_two_slices_by_hand():
    """S = [[2, 1], [1, 2]]: delta^(10/9) = 3 q with even gaps, 2 q with one slice out of reach."""
    w = [[2.0, 1.0], [1.0, 2.0]]
    roller = {"length": 1.0, "R": 1.0, "E_star": 1.0, "compliance": 3.0, "kernel": w}
    even = slices.press([0.0, 0.0], load=2048.0 / 3, **roller)
    assert float(even.approach) == pytest.approx(512.0, rel=1e-12)
    np.testing.assert_allclose(even.force, 1024 / 3, rtol=1e-12)
    alone = slices.press([0.0, 1e9], load=512.0, **roller)
    assert float(alone.approach) == pytest.approx(512.0, rel=1e-12)
    lifted = slices.press([0.0, 511.0], load=512.0, **roller)  # 1 - 512 < 0: it would pull
    np.testing.assert_allclose(lifted.force, [512.0, 0.0], rtol=1e-12)
    assert lifted.carries.tolist() == [True, False]


def test_without_coupling_the_slices_are_laminae():
    for load in (100.0, 3400.0):
        alone = lamina.press(crowned(tilt=1e-3), load=load, **ROLLER)
        coupled = slices.press(crowned(tilt=1e-3), load=load, kernel=np.eye(50), **ROLLER)
        assert float(coupled.approach) == pytest.approx(float(alone.approach), rel=1e-12)
        np.testing.assert_allclose(coupled.force, alone.force, rtol=1e-9, atol=1e-11 * load)


@pytest.mark.parametrize("load", [1e-9, 10.0, 3400.0, 1e6])
@pytest.mark.parametrize("tilt", [0.0, 2e-3])
def test_pressing_to_the_approach_returns_the_load(load, tilt):
    z = crowned(tilt=tilt)
    z -= z.min()
    there = slices.press(z, load=load, **ROLLER)
    back = slices.press(z, approach=there.approach, **ROLLER)
    assert float(back.load) == pytest.approx(load, rel=1e-11)
    np.testing.assert_allclose(back.force, there.force, rtol=1e-8, atol=1e-11 * load)


def test_an_approach_that_reaches_nothing_gives_no_force():
    contact = slices.press(crowned(), approach=[0.0, -1e-6, 1e-6], **ROLLER)
    np.testing.assert_array_equal(contact.load > 0, [False, False, True])


def test_a_symmetric_gap_carries_symmetrically_and_a_mirrored_one_mirrored():
    even = slices.press(crowned(), load=3400.0, **ROLLER)
    np.testing.assert_allclose(even.force, even.force[::-1], rtol=1e-10)
    left, right = (slices.press(crowned(tilt=t), load=3400.0, **ROLLER) for t in (1e-3, -1e-3))
    np.testing.assert_allclose(left.force, right.force[::-1], rtol=1e-9, atol=1e-9)
    assert left.force[0] > 2 * left.force[-1]


def test_the_ends_of_a_flat_roller_carry_more_the_finer_it_is_cut():
    peaks, middles = [], []
    for n in (21, 41, 81, 161):
        contact = slices.press(np.zeros(n), load=3400.0, **ROLLER)
        peaks.append(float(contact.peak_pressure[0]))
        middles.append(float(contact.peak_pressure[n // 2]))
    growth = np.diff(np.log(peaks)) / np.log(2)
    assert np.all(growth > 0.1)
    assert np.ptp(middles[1:]) < 0.005 * middles[-1]


def test_a_flat_rollers_approach_is_palmgrens_but_for_the_ends():
    """Summed over all slices the law is Palmgren's; the ends carry more at the same approach."""
    contact = slices.press(np.zeros(50), load=3400.0, **ROLLER)
    expected = float(palmgren.approach(load=3400.0, length=9e-3))
    assert 0.98 < float(contact.approach) / expected < 1
    row_sums = matrix(3400.0, 50).sum(axis=1)
    assert row_sums[0] < 0.75 * row_sums[25]


def test_a_batch_is_its_cases_one_by_one_across_chunks(monkeypatch):
    monkeypatch.setattr(slices, "CHUNK", 4 * 50**2)
    rng = np.random.default_rng(7)
    y = crown.slice_centres(length=9e-3, slices=50)
    gap = crowned() + rng.uniform(-1e-3, 1e-3, (3, 5, 1)) * y + rng.uniform(0, 3e-6, (3, 5, 50))
    load, R = 10 ** rng.uniform(0, 4, (3, 1)), rng.uniform(1e-3, 5e-3, 5)
    many = slices.press(gap, load=load, **ROLLER | {"R": R})
    assert many.force.shape == (3, 5, 50)
    for i in range(3):
        for j in range(5):
            one = slices.press(gap[i, j], load=load[i, 0], **ROLLER | {"R": R[j]})
            np.testing.assert_allclose(
                many.force[i, j], one.force, rtol=1e-9, atol=1e-11 * load[i, 0]
            )
    back = slices.press(gap, approach=many.approach, **ROLLER | {"R": R})
    np.testing.assert_allclose(back.force, many.force, rtol=1e-7, atol=1e-10 * load.max())


def test_a_light_load_far_from_the_origin_keeps_its_digits():
    """The approach beyond the lowest gap, 1e-19 m, is lost in the sum with a gap of 1 m."""
    near = slices.press([0.0, 0.0, 1e-3], load=1e-12, **ROLLER)
    far = slices.press([1.0, 1.0, 1.001], load=1e-12, **ROLLER)
    np.testing.assert_allclose(far.force, near.force, rtol=1e-11)
    assert float(far.approach) == 1.0


@pytest.mark.parametrize("slope", [-1.0, 1e-3])
def test_a_wrong_slope_leaves_the_bounds_to_find_the_approach(monkeypatch, slope):
    right = slices.press(crowned(), load=3400.0, **ROLLER)
    monkeypatch.setattr(slices, "TOLERANCE", 1e-13 / abs(slope))

    def misled(*arguments):
        q, growth = slice_pivoting.carried(*arguments)
        return q, slope * growth

    monkeypatch.setattr(slices, "carried", misled)
    contact = slices.press(crowned(), load=3400.0, **ROLLER)
    assert float(contact.load) == pytest.approx(3400.0, rel=1e-10)
    np.testing.assert_allclose(contact.force, right.force, rtol=1e-8)


def test_a_search_that_does_not_end_is_an_error(monkeypatch):
    monkeypatch.setattr(slice_pivoting, "PIVOTS", 1)
    with pytest.raises(ArithmeticError, match="not found in 1 exchanges"):
        slices.press(crowned(tilt=1e-3), load=300.0, **ROLLER)
    monkeypatch.undo()
    monkeypatch.setattr(slices, "ITERATIONS", 1)
    with pytest.raises(ArithmeticError, match="the approach under the load was not found in 1"):
        slices.press(crowned(), load=300.0, **ROLLER)
    with pytest.raises(ArithmeticError, match="the load under the approach did not settle in 1"):
        slices.press(crowned(), approach=1e-6, **ROLLER)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"load": 0.0}, "load must be positive and finite, got 0.0 N"),
        ({"load": None}, r"give the load \[N\] or the approach \[m\], one of the two"),
        ({"gap": [np.nan, 0.0]}, "gap must be finite"),
        ({"R": -1.0}, "relative radius must be positive and finite, got -1.0 m"),
        ({"gap": np.zeros((3, 5)), "load": [1.0, 2.0]}, "must fit together"),
    ],
)
def test_contacts_that_make_no_sense_are_refused(change, message):
    arguments = {"gap": [0.0, 1e-6], "load": 100.0, **ROLLER, **change}
    with pytest.raises(ValueError, match=message):
        slices.press(arguments.pop("gap"), **arguments)


def test_with_its_own_compliance_the_model_is_dimensionally_homogeneous():
    k, s = 1e3, 1e-6  # mm, MPa
    here = slices.press(crowned(tilt=1e-3), load=500.0, compliance=1e-9, **ROLLER)
    there = slices.press(
        crowned(tilt=1e-3) * k, load=500.0 * s * k**2, length=9e-3 * k, R=ROLLER["R"] * k,
        E_star=ROLLER["E_star"] * s, compliance=1e-9 * k ** (10 / 9) / (s * k**2),
    )  # fmt: skip
    assert float(there.approach) == pytest.approx(float(here.approach) * k, rel=1e-11)
    np.testing.assert_allclose(there.force, here.force * s * k**2, rtol=1e-8, atol=1e-8)
    np.testing.assert_allclose(there.peak_pressure, here.peak_pressure * s, rtol=1e-8, atol=1e-2)

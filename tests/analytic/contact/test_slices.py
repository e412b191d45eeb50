"""Coupled slices against hand values, quadrature, optimality and their own inverse."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import dblquad, quad
from scipy.optimize import nnls

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
    """S written out anew."""
    b = float(hertz_line.half_width(P=load / 9e-3, R=ROLLER["R"], E_star=ROLLER["E_star"]))
    D, j = 9e-3 / n, np.arange(n)
    w = love(np.abs(j[:, None] - j) * D, D, b)
    return n * float(palmgren.compliance(length=9e-3, slices=n)) * w / w.sum()


def test_loves_weight_is_the_integral_of_the_inverse_distance():
    b, D = 0.3, 0.2
    for d in (0.25, 0.6, 3.0):
        expected, _ = dblquad(lambda x, y: 1 / np.hypot(x, y), d - D / 2, d + D / 2, -b, b)
        assert 2 * float(love(d, D, b)) == pytest.approx(expected, rel=1e-9)


def test_loves_weight_of_a_far_slice_is_that_of_a_point():
    assert 2 * float(love(50.0, 0.2, 0.3)) == pytest.approx(0.2 * 0.6 / 50, rel=1e-5)


@given(n=st.integers(1, 60), load=st.floats(1.0, 1e5))
@settings(deadline=None, max_examples=20)
def test_the_sum_of_s_is_n_s_whatever_the_weights(n, load):
    w = np.linalg.inv(np.eye(n) + np.tri(n) @ np.tri(n).T)  # symmetric, positive definite
    w = (w + w.T) / 2
    for weights in (w, matrix(load, n)):
        S = compliance_matrix(weights, compliance=load)
        assert float(S.sum()) == pytest.approx(n * load, rel=1e-9)
        np.testing.assert_allclose(S, S.T, rtol=1e-9)
        np.testing.assert_allclose(S / S[0, 0], weights / weights[0, 0], rtol=1e-9)


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


def own_width_kernels():
    nodes, shares = np.polynomial.legendre.leggauss(40)

    def ellipse(d, D, b):
        """Hertz's ellipse across in place of the even load, w = int sqrt(1 - x²) asinh(...) dx.

        With x = s² the logarithm at 0 leaves Gauss's rule its digits.
        """
        s = (nodes + 1) / 2
        return sum(
            p * s_i * np.sqrt(1 - s_i**4)
            * (np.arcsinh((d + D / 2) / (b * s_i**2)) - np.arcsinh((d - D / 2) / (b * s_i**2)))
            for s_i, p in zip(s, shares, strict=True)
        )  # fmt: skip

    def averaged(d, D, b):
        """Love's displacement averaged over the slice that sinks."""
        return sum(
            p * love(np.abs(d + D * x / 2), D, b) for x, p in zip(nodes, shares, strict=True)
        )

    return {"ellipse": ellipse, "averaged": averaged}


@pytest.mark.parametrize("design", DESIGNS)
@pytest.mark.parametrize("kernel", ["ellipse", "averaged"])
def test_another_kernel_of_the_contacts_width_moves_a_crowned_peak_by_a_fifth_of_a_percent(
    design, kernel
):
    for n in (41, 81):
        z = crowned(design, slices=n)
        ours = slices.press(z, load=3400.0, **ROLLER).peak_pressure.max()
        other = slices.press(z, load=3400.0, kernel=own_width_kernels()[kernel], **ROLLER)
        assert 1e-6 < abs(other.peak_pressure.max() / ours - 1) < 2e-3


def test_a_kernel_of_another_width_moves_it_by_more():
    z = crowned("best", slices=41)
    ours = slices.press(z, load=3400.0, **ROLLER).peak_pressure.max()
    wide = slices.press(z, load=3400.0, kernel=lambda d, D, b: love(d, D, 2 * b), **ROLLER)
    assert 0.005 < wide.peak_pressure.max() / ours - 1 < 0.03


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


@settings(deadline=None, max_examples=60)
@given(seed=st.integers(0, 2**32 - 1), n=st.integers(1, 30), softness=st.floats(1e-3, 1e3))
def test_the_carrying_slices_are_those_of_non_negative_least_squares(seed, n, softness):
    """Any positive definite S, not contacts alone: there the block exchange may run in circles."""
    rng = np.random.default_rng(seed)
    root = rng.normal(size=(n, n))
    S = root @ root.T + softness * np.eye(n)
    f = rng.uniform(0, 1, n) ** 3 * (rng.uniform(size=n) < 0.8)
    start = rng.uniform(size=(1, n)) < 0.5
    q, _ = slice_pivoting.carried(S[None], f[None], f[None], start)
    factor = np.linalg.cholesky(S)
    expected, _ = nnls(factor.T, np.linalg.solve(factor, f))
    np.testing.assert_allclose(q[0], expected, atol=1e-9 * max(expected.max(), 1e-300))


def test_where_blocks_run_in_circles_single_exchanges_find_the_way(monkeypatch):
    """Without patience for blocks at all Murty's rule alone ends, too, in more exchanges."""
    monkeypatch.setattr(slice_pivoting, "PATIENCE", 0)
    S, f = matrix(3400.0, 20), np.linspace(-1, 1, 20)[None] ** 3
    start = np.zeros((1, 20), dtype=bool)
    q, _ = slice_pivoting.carried(S[None], np.maximum(f, 0), np.maximum(f, 0), start)
    y = S @ q[0] - np.maximum(f[0], 0)
    assert np.all(q >= 0)
    assert np.all(y >= -1e-12)
    np.testing.assert_allclose(y * q[0], 0, atol=1e-12 * q.max())


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
    ("kernel", "message"),
    [
        (np.eye(3), r"weights must be \(2, 2\), as many as slices, got \(3, 3\)"),
        ([[2.0, 1.0], [0.5, 2.0]], "weights must be symmetric"),
        ([[1.0, 2.0], [2.0, 1.0]], "weights must be positive definite"),
        ([[1.0, np.nan], [np.nan, 1.0]], "weights must be finite"),
        (lambda d, D, b: 1 / (d + D) ** 0 - 2.0, "weights must be positive definite"),
    ],
)
def test_weights_that_make_no_sense_are_refused(kernel, message):
    with pytest.raises(ValueError, match=message):
        slices.press([0.0, 1e-6], load=100.0, kernel=kernel, **ROLLER)


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
    with pytest.raises(ValueError, match=r"weights must be a matrix \(n, n\), got shape \(2,\)"):
        compliance_matrix([1.0, 2.0], compliance=1.0)


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


def test_the_ellipse_of_the_kernel_test_is_hertzs():
    """Its normalisation against quadrature, at the slice itself and beside it."""
    ellipse = own_width_kernels()["ellipse"]
    for d in (0.0, 0.3):

        def across(x, d=d):
            return np.sqrt(1 - x**2) * (
                np.arcsinh((d + 0.1) / (0.3 * x)) - np.arcsinh((d - 0.1) / (0.3 * x))
            )

        assert ellipse(d, 0.2, 0.3) == pytest.approx(quad(across, 0, 1)[0], rel=1e-4)

"""Weights and the matrix S against quadrature, and how little a crowned peak depends on them."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import dblquad, quad

from analytic.contact import crown, slices
from analytic.contact.slice_compliance import compliance_matrix, love

ROLLER = {"length": 9e-3, "R": 2.952e-3, "E_star": 206e9 / 1.82}  # the paper's, on its inner race
DESIGNS = {"25 N m": (2.1507, 0.6763, 12.1e-6), "best": (1, 0.7, 1e-5), "worst": (5, 0.7, 1.5e-5)}


def crowned(design, slices):
    K_1, K_2, z_m = DESIGNS[design]
    y = crown.slice_centres(length=9e-3, slices=slices)
    steel = {"load": 3400.0, "length": 9e-3, "E_star": ROLLER["E_star"]}
    return crown.logarithmic(y, K_1=K_1, K_2=K_2, z_m=z_m, **steel)


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
    j = np.arange(n)
    for weights in (
        np.tri(n) @ np.tri(n).T,  # positive definite
        love(np.abs(j[:, None] - j) * 0.1, 0.1, 0.3),
    ):
        S = compliance_matrix(weights, compliance=load)
        assert float(S.sum()) == pytest.approx(n * load, rel=1e-12)
        np.testing.assert_allclose(S / S[0, 0], weights / weights[0, 0], rtol=1e-12)


def test_the_ellipse_of_the_kernel_test_is_hertzs():
    """Its normalisation against quadrature, at the slice itself and beside it."""
    ellipse = own_width_kernels()["ellipse"]
    for d in (0.0, 0.3):

        def across(x, d=d):
            return np.sqrt(1 - x**2) * (
                np.arcsinh((d + 0.1) / (0.3 * x)) - np.arcsinh((d - 0.1) / (0.3 * x))
            )

        assert ellipse(d, 0.2, 0.3) == pytest.approx(quad(across, 0, 1)[0], rel=1e-4)


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
    with pytest.raises(ValueError, match=r"weights must be a matrix \(n, n\), got shape \(2,\)"):
        compliance_matrix([1.0, 2.0], compliance=1.0)

"""Lines, kinks and reversal that are read off curves of force over displacement."""

import numpy as np
import pytest

from fem.beam.two_lines import fitted, on_common, retraced, touching

mm = 1e-3


def kinked(U, U_A=12 * mm, k1=600.0, k2=750.0):
    """Two straight lines and the normal force that grows from the kink on."""
    F = np.where(U > U_A, k1 * U_A + k2 * (U - U_A), k1 * U)
    return np.array([U, F, np.maximum(0, 300 * (U - U_A))])


def test_two_lines_are_found_again():
    found = fitted(kinked(np.arange(1, 18) * mm), 17 * mm)
    assert (found.k1, found.k2) == pytest.approx((600, 750), rel=1e-12)
    assert pytest.approx((12 * mm, 12 * mm), rel=1e-12) == (found.U_A, found.U)
    assert (found.F_A, found.c1, found.c2) == pytest.approx((7.2, 0, -1.8), abs=1e-12)


def test_a_stroke_that_ends_before_a_has_one_line():
    found = fitted(kinked(np.arange(1, 11) * mm), 17 * mm)
    assert found.k1 == pytest.approx(600, rel=1e-12)
    assert np.isnan([found.k2, found.c2, found.U_A, found.F_A, found.U]).all()


def test_a_curve_that_touches_at_its_end_has_no_second_slope():
    found = fitted(kinked(np.arange(1, 15) * mm), 17 * mm)
    assert pytest.approx(12 * mm) == found.U_A
    assert np.isnan(found.k2)
    assert np.isnan(fitted(kinked(np.arange(1, 3) * mm), 17 * mm).k1)


def test_touching_is_read_from_two_states_past_it():
    U = np.array([11, 11.5, 12.2, 12.4, 13]) * mm
    assert touching(*kinked(U)) == pytest.approx((12 * mm, 7.2, 750), rel=1e-12)
    assert np.isnan(touching(*kinked(U[:2]))).all()
    assert np.isnan(touching(*kinked(U[:3]))).all(), "one state gives no slope"


def test_curves_are_compared_in_the_states_that_both_have():
    fine, coarse = kinked(np.arange(1, 18) * mm), kinked(np.arange(2, 24, 2) * mm * (1 + 1e-12))
    one, other = on_common(fine, coarse, 17 * mm)
    assert one[0] == pytest.approx(np.arange(2, 17, 2) * mm)
    assert other == pytest.approx(one, rel=1e-9, abs=1e-9)
    assert fitted(one, 17 * mm).apart(fitted(other, 17 * mm)) < 1e-9


def test_forces_that_are_not_retraced_are_found():
    U = np.array([1, 2, 3, 2, 1]) * mm
    assert retraced(U, 600 * U) < 1e-14
    assert retraced(U, np.where(np.arange(5) > 2, 1.01, 1.0) * U) == pytest.approx(0.01)

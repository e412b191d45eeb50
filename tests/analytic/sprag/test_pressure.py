"""Pressure along a sprag in time, through slices solved at few loads."""

import numpy as np
import pytest

from analytic.contact import slices
from analytic.contact.crown import logarithmic, slice_centres
from analytic.sprag import pressure

CONTACT = {"length": 9e-3, "R": 2.95e-3, "E_star": 113.2e9}  # the inner contact of Huang 2018
N = np.array([0.0, 50.0, 900.0, 3407.0, 6238.0, 5000.0])


def test_the_largest_pressure_is_that_of_slices_solved_at_each_load():
    y = slice_centres(length=9e-3, slices=41)
    gap = logarithmic(y, K_1=1, K_2=0.7, z_m=0.01e-3, load=3407, length=9e-3, E_star=113.2e9)
    p = pressure.along(N, gap, **CONTACT)
    exact = slices.press(gap, load=N[1:], **CONTACT).peak_pressure
    assert p.shape == (6, 41)
    assert np.all(p[0] == 0)
    np.testing.assert_allclose(p[1:].max(axis=1), exact.max(axis=1), rtol=2e-3)
    assert np.abs(p[1:] - exact).max() < 0.05 * exact.max()


def test_without_a_crown_pressures_grow_with_the_root_of_the_force():
    """But for 2 %: the ends carry more under larger half-widths (Love's weights)."""
    p = pressure.along(N, np.zeros(21), **CONTACT)
    middle = p[:, 10] / np.sqrt(np.maximum(N, 1.0))
    np.testing.assert_allclose(middle[1:], middle[1], rtol=0.03)


def test_no_force_no_pressure():
    assert pressure.along([0.0, 0.0], np.zeros(5), **CONTACT).tolist() == [[0.0] * 5] * 2
    with pytest.raises(ValueError, match="normal force must be finite and not negative"):
        pressure.along([-1.0], np.zeros(5), **CONTACT)

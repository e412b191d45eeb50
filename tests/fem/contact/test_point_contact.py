"""Readings of a point contact on fields that are known."""

import numpy as np
import pytest

from analytic.contact import hertz_point
from fem.contact.point_contact import largest_axis_shear, middle_pressure


def test_the_peak_of_an_ellipse_is_found_from_its_nodes():
    r = np.linspace(0, 1, 40)
    p = 3.0 * np.sqrt(1 - r**2)
    assert middle_pressure(r, p, 1.01) == pytest.approx(3.0, rel=1e-4)


def test_the_largest_shear_stress_of_exact_stresses_is_hertz_s():
    z = np.linspace(0.1, 0.9, 81)
    radial, axial = hertz_point.axis_stresses(z, a=1.0, p_0=1.0, nu=0.3)
    x = np.array([np.repeat([0.0, 0.1, 0.2], 81), np.tile(z, 3)])
    stress = np.tile([radial, axial], 3)
    found = largest_axis_shear(x, stress, 1.0)
    assert found == pytest.approx((0.310, 0.481), abs=6e-4)

"""Bounds of a race under its loads: the dent by integration, and the interval about it."""

import numpy as np
import pytest

from analytic.bounds.ring import PART, integrated_dent, smeared_error
from analytic.contact.hertz_line_approach import approach_to_depth


@pytest.mark.parametrize("depth", [0.3, 1.0, 20.0])
@pytest.mark.parametrize("nu", [0.0, 0.3])
def test_the_dent_by_integration_is_that_in_closed_form(depth, nu):
    load = {"P": 2.0, "a": 0.7, "E": 3.0, "nu": nu}
    closed = approach_to_depth(depth, **load, assumption="plane stress")
    assert integrated_dent(depth, **load) == pytest.approx(float(closed), rel=1e-9)


def test_the_interval_lies_about_the_error_and_is_none_where_nothing_is_left():
    low, high = smeared_error(mean=1.2, at=2.0, load=2.0, dent=1.0, added=0.3)
    assert np.mean([low, high]) == pytest.approx(0.5)
    assert high - low == pytest.approx(2e-3 * 1.5)
    assert smeared_error(mean=1.2, at=2.0, load=2.0, dent=2.0 - 1.9 * PART) is None

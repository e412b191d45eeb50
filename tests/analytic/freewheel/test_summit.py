"""The largest torque of an outer cam."""

import numpy as np
import pytest

from analytic.freewheel.limits import limits, pop_through
from analytic.freewheel.state import at_normal_force, loaded
from analytic.freewheel.summit import summit


def test_no_state_near_the_summit_bears_more(cup):
    top = summit(cup)
    near = at_normal_force(cup, float(top.N) * np.linspace(0.9, 1.1, 201)).T
    assert near.max() <= float(top.T)
    assert np.isfinite(loaded(cup, 0.9999 * top.T).N)
    assert np.isnan(loaded(cup, 1.0001 * top.T).N)


def test_its_torque_is_the_limit_among_the_limits(cup):
    found = limits(cup, mu=0.1, p_lim=4e9)
    assert float(pop_through(cup)) == float(found.pop_through)
    assert float(summit(cup).T) == pytest.approx(float(found.pop_through), rel=1e-9)


def test_an_inner_cam_has_none(star):
    assert pop_through(star) == np.inf
    assert summit(star) is None

"""The ring that is held and slips: limits, and energy that friction takes."""

import numpy as np
import pytest

from analytic.freewheel.let_out import let_out
from analytic.freewheel.state import loaded


def test_the_torque_that_is_left_falls_to_nothing_over_the_axial_slip(star):
    slip, torque = let_out(star, T=26.0, mu=0.08)
    assert (slip[-1], torque[-1], torque[0]) == (0.0, 1.0, 0.0)
    assert np.all(np.diff(slip) < 0)
    assert np.all(np.diff(torque) > 0)


def test_much_friction_turns_slip_along_the_axis(star):
    """F_a/F_t and with it the slip that lets the rollers out grow as mu/tan(alpha)."""
    few, many = (let_out(star, T=26.0, mu=mu)[0][0] for mu in (2.0, 4.0))
    assert many / few == pytest.approx(2, rel=1e-3)


def test_slip_begins_as_coulomb_s_law_has_it(star):
    slip, torque = let_out(star, T=26.0, mu=0.08)
    ends = [loaded(star, 26.0 * share) for share in torque[-2:]]
    lost = sum(float(getattr(ends[1], d) - getattr(ends[0], d)) for d in ("d_i", "d_o"))
    tan = np.tan(float(ends[1].alpha))
    assert lost / slip[-2] == pytest.approx(tan / np.sqrt((0.08 / tan) ** 2 - 1), rel=5e-3)

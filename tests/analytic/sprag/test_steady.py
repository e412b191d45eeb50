"""Readings of histories that are made by hand: a steady force with a swing, the time of a slip."""

from types import SimpleNamespace

import numpy as np
import pytest

from analytic.sprag.history import Phase
from analytic.sprag.readings import first_slip, steady


@pytest.mark.parametrize("periods", [20.0, 20.5])
def test_the_mean_of_a_swing_does_not_depend_on_parts_of_a_period(periods):
    t = np.linspace(0, 1, 4001)
    found = SimpleNamespace(N=100 + 30 * np.sin(2 * np.pi * periods * t))
    late, wander = steady(found)
    assert late == pytest.approx(100, abs=0.01)
    assert wander < 0.02


def test_a_force_that_still_rises_wanders():
    late, wander = steady(SimpleNamespace(N=100 * np.linspace(0, 1, 4001)))
    assert late == pytest.approx(75, rel=1e-3)
    assert wander == pytest.approx(25, rel=1e-2)


def test_a_slip_begins_between_the_steps_where_friction_is_reached():
    t, N = 1e-3 * np.arange(6), np.full(6, 200.0)
    phases = np.full((6, 2), Phase.STICK)
    phases[4:, 0] = Phase.SLIP
    found = SimpleNamespace(t=t, N=N, T_i=N * 0.02 * np.arange(6), phases=phases, dt=1e-3)
    assert first_slip(found, 0.065) == pytest.approx(3.25e-3)

"""The tutorial runs unchanged, and its statements on a pin in a hole are true."""

import runpy
from pathlib import Path

import numpy as np
import pytest

TUTORIAL = Path(__file__).parents[1] / "docs" / "contact_tutorial.py"


def test_the_foot_takes_the_load_the_pressure_has_its_bounds_and_friction_its_limit():
    names = runpy.run_path(str(TUTORIAL))
    touch, R, play, F = names["touch"], names["R"], names["PLAY"], names["LOAD"]
    x, y, _ = names["step"].plane.reaction("foot")
    assert abs(x) < 1e-8 * F + abs(touch.force[0])
    assert y == pytest.approx(-touch.force[1], rel=1e-8)
    assert y == pytest.approx(F, rel=1e-5)  # the parabolas' pin is not quite a circle
    # play makes the contact narrower than a fitting pin's half circle with p = 2F/(pi R) cos, and
    # two parabolas would conform less than two circles do
    E_star = 1 / (1 / 70e3 + 1 / 210e3)
    hertz = np.sqrt(F * E_star / (np.pi * R * (R - play) / play))
    assert 2 * F / (np.pi * R) < touch.peak < 1.5 * hertz
    assert np.all(np.abs(touch.traction) <= 0.15 * touch.pressure + 1e-9 * touch.peak)
    assert np.any(touch.sticks)
    assert np.any(touch.closed & ~touch.sticks)  # it slips at the edge

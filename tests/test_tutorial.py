"""The tutorial runs as it stands, and what it says of its pin in a hole is true."""

import runpy
from pathlib import Path

import numpy as np
import pytest

TUTORIAL = Path(__file__).parents[1] / "docs" / "contact_tutorial.py"


@pytest.fixture(scope="module")
def told() -> dict:
    return runpy.run_path(str(TUTORIAL))


def test_the_foot_takes_what_the_hole_carries(told):
    x, y, _ = told["step"].plane.reaction("foot")
    assert abs(x) < 1e-8 * told["LOAD"] + abs(told["touch"].force[0])
    assert y == pytest.approx(-told["touch"].force[1], rel=1e-8)
    assert y == pytest.approx(told["LOAD"], rel=1e-5)  # the parabolas' pin is not quite a circle


def test_the_pressure_lies_between_the_cosine_of_a_fitting_pin_and_hertz_of_a_loose_one(told):
    # play makes the contact narrower than a fitting pin's half circle with p = 2F/(pi R) cos, and
    # two parabolas would conform less than two circles do
    R, play, F = told["R"], told["PLAY"], told["LOAD"]
    E_star = 1 / (1 / 70e3 + 1 / 210e3)
    relative = R * (R - play) / play
    hertz = np.sqrt(F * E_star / (np.pi * relative))
    assert 2 * F / (np.pi * R) < told["touch"].peak < 1.5 * hertz


def test_the_pin_slips_at_the_edge_and_friction_keeps_to_its_limit(told):
    touch = told["touch"]
    assert np.all(np.abs(touch.traction) <= 0.15 * touch.pressure + 1e-9 * touch.peak)
    assert np.any(touch.sticks)
    assert np.any(touch.closed & ~touch.sticks)

"""A wedged roller: what its balance says, what sticks, and a bracket beside the limit."""

import math

import pytest

from fem.contact.wedged import Geometry, Wedge
from fem.contact.wedged_states import least_friction, slipping, uneven
from meshes.contact.block import full_block
from meshes.contact.tilted import placed, tilted_half_disc
from meshes.join import join

HALF, A = math.radians(3), 0.05
N = math.pi * A**2 / (8 * (1 - 0.3**2))  # Hertz, E = 1, both bodies alike


@pytest.fixture(scope="module")
def free():
    geometry = Geometry(1.0, HALF, A)
    fine = {"zone": 1.15 * A, "cells": 7, "refine": 1}
    x, y = geometry.normal
    race = full_block(width=1.0, depth=1.0, above=True, **fine)
    roller = tilted_half_disc(R=1.0, tilt=HALF, **fine)
    mesh = join({"roller": roller, "race": placed(race, turn=-HALF, shift=(float(x), float(y)))})
    return Wedge(geometry, mesh, E=1.0, nu=0.3, mu=0.2)


def test_a_free_roller_uses_what_its_balance_asks_for(free):
    state, down = free.pressed(N)
    found, tangential = free.forces(state)
    assert found == pytest.approx(N, rel=1e-11)
    assert tangential / found == pytest.approx(math.tan(HALF), rel=1e-8)
    assert 0 < down < A


def test_what_grows_in_proportion_sticks(free):
    """All in one step a part slips, in many steps next to nothing: q is tan(alpha/2) p then."""
    state, down = free.pressed(N)
    at_once, grown = (one.touches[0] for one in (state, free.at(down, steps=20)))
    assert slipping(grown) < 0.03 < slipping(at_once)
    assert uneven(grown, math.tan(HALF)) < 0.2 < uneven(at_once, math.tan(HALF))


def test_a_push_that_balances_the_normal_force_leaves_no_friction(free):
    state, _ = free.pressed(N, push=N * math.sin(HALF))
    found, tangential = free.forces(state)
    assert abs(tangential) < 1e-8 * found


def test_a_bracket_that_misses_the_limit_finds_none():
    value, half = least_friction(lambda mu: float(mu > 0.05), 0.0505)
    assert math.isnan(value)
    assert half == 0.0

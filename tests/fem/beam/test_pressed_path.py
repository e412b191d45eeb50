"""Paths of a pressed frame meet its linear stiffness where displacements are small."""

import numpy as np
import pytest

from fem.beam.pressed import PressedFrame
from fem.beam.pressed_path import (
    both_paths,
    drifts,
    free_force,
    slanted_force,
    stable_forces,
)
from fem.beam.section import Section
from meshes.spring.centre_line import centre_line

LENGTH = 6.3e-3


@pytest.fixture(scope="module")
def spring():
    """A short accordion spring of steel, 0.2 mm thick and 10 mm wide."""
    line = centre_line(n=6, L1=8e-3, radius=0.8e-3, alpha=1.4, tail="arc", per_arc=4, per_leaf=2)
    EA = 206e9 * 10e-3 * 0.2e-3
    section = Section(EA=EA, EI=EA * 0.2e-3**2 / 12, GA=5 / 6 * EA / 2.6)
    return PressedFrame(
        line.points, line.elements, section, int(line.nodes["head"]), int(line.nodes["tail"])
    )


def test_a_free_head_that_hardly_moves_has_the_linear_stiffness(spring):
    U = 1e-5 * LENGTH
    assert free_force(spring, np.array([U])) == pytest.approx(spring.stiffness * U, rel=1e-3)


def test_a_straight_way_is_the_guided_path(spring):
    (guided,) = stable_forces(spring, LENGTH, (0.02,))
    F_x, _ = slanted_force(spring, 0.02 * LENGTH, 0.0)
    assert F_x == pytest.approx(guided, rel=1e-9)
    assert guided > spring.stiffness * 0.02 * LENGTH  # the guide stiffens it


def test_small_loads_drift_in_proportion(spring):
    half, whole = drifts(spring, 1e-6 * spring.stiffness * LENGTH, (0.5, 1.0))
    assert whole == pytest.approx(2 * half, rel=1e-4)


def test_paths_begin_with_the_determinants_at_rest(spring):
    paths = both_paths(spring, LENGTH, 0.1)
    assert paths["free"][0, 3] == pytest.approx(1.0, abs=0.1)
    assert paths["guided"][0, 3] == pytest.approx(1.0, abs=0.1)
    assert paths["free"][0, 1] == pytest.approx(0.01 * LENGTH)
    assert paths["free_shape"].shape == (len(spring.elements), 3, 2)

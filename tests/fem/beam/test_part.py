"""Stiffness of a part of a frame about its centre: a straight strip in closed form."""

import numpy as np
import pytest

from fem.beam.part import part_stiffness
from fem.beam.section import Section

L, STRIP = 2.0, Section(EA=300.0, EI=5.0, GA=70.0)


def line(cells):
    x = np.linspace(0.0, L, 2 * cells + 1)
    ends = 2 * np.arange(cells)
    points = np.column_stack([x, 0.0 * x])
    return points, np.column_stack([ends, ends + 2, ends + 1])


def test_a_straight_strip_has_the_stiffnesses_of_its_ends_about_its_middle():
    """Across, the moment changes its sign in the middle: L^3/(12 E I) and shear."""
    points, elements = line(4)
    found = part_stiffness(points, elements, STRIP, (0.0, 0.0), (L, 0.0))
    assert found["turn"] == pytest.approx(STRIP.EI / L, rel=1e-9)
    assert found["axial"] == pytest.approx(STRIP.EA / L, rel=1e-9)
    across = L**3 / (12 * STRIP.EI) + L / STRIP.GA
    assert found["lateral"] == pytest.approx(1 / across, rel=1e-6)
    # elements outside the part do not count
    half = part_stiffness(points, elements[:2], STRIP, (0.0, 0.0), (L / 2, 0.0))
    assert half["turn"] == pytest.approx(2 * STRIP.EI / L, rel=1e-9)

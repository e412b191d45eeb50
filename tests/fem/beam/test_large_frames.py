"""Frames at large displacement: squares by elliptic integrals, strips side by side."""

from itertools import pairwise
from math import pi, sqrt

import numpy as np
import pytest

from fem.beam.large import LargeFrame
from fem.beam.section import Section
from tests.fem.beam.large_reference import cantilever

THIN = Section(EA=1e8, EI=1.0, GA=4e7)


def square(count=16):
    """A square of sides 1 on its corner, nodes on the corners 0, 2 count, ...; the foot is 0."""
    corners = np.array([[0, -1], [1, 0], [0, 1], [-1, 0], [0, -1]]) / sqrt(2)
    sides = 2 * count
    along = np.linspace(0, 1, sides, endpoint=False)[:, None]
    points = np.vstack([a + along * (b - a) for a, b in pairwise(corners)])
    k, n = 2 * np.arange(4 * count), len(points)
    elements = np.column_stack([k, (k + 2) % n, k + 1])
    return points, elements, sides


@pytest.mark.parametrize("pull", [5.0, -4.0])
def test_a_square_pulled_or_pressed_on_its_corners_follows_elliptic_integrals(pull):
    """Half of a side is a cantilever from the loaded corner to the point of inflection.

    Its end bears half the load at 45 deg (pull) or 135 deg (press) to its axis. Mattiasson,
    Int. J. Numer. Meth. Eng. 17 (1981) 145-153.
    """
    points, elements, side = square()
    frame = LargeFrame(points, elements, sections=THIN, supports={0: "xyr"})
    path = frame.under_loads({2 * side: (0.0, pull, 0.0)}, [0.25, 1.0])
    half = 0.5
    angle = pi / 4 if pull > 0 else 3 * pi / 4
    x, y, _ = cantilever(abs(pull) / 2 * half**2, angle)  # in units of half a side
    axis = np.array([np.cos(angle), np.sin(angle)])
    along = half * axis @ [x, y] * np.sign(pull)
    across = half * abs(np.array([-axis[1], axis[0]]) @ [x, y])
    top, right = path.u[-1, 2 * side], path.u[-1, side]
    assert points[2 * side, 1] - points[0, 1] + top[1] == pytest.approx(4 * along, abs=5e-6)
    assert points[side, 0] + right[0] == pytest.approx(2 * across, abs=5e-6)
    assert abs(top[[0, 2]]).max() < 1e-9


def test_sections_and_bodies_share_the_load():
    """Two parallel guided strips of EI and 2 EI: forces 1 : 2 at every deflection."""
    count = 8
    x = np.linspace(0, 1, 2 * count + 1)
    lower, upper = np.column_stack([x, 0 * x]), np.column_stack([x, 0 * x + 1])
    k = 2 * np.arange(count)
    one = np.column_stack([k, k + 2, k + 1])
    two = one + 2 * count + 1
    frame = LargeFrame(
        np.vstack([lower, upper]), np.vstack([one, two]),
        sections={"soft": THIN, "stiff": Section(EA=2e8, EI=2.0, GA=8e7)},
        bodies={"soft": np.arange(count), "stiff": np.arange(count, 2 * count)},
        supports={0: "xyr", 2 * count + 1: "xyr", 2 * count: "r", 4 * count + 1: "r"},
    )  # fmt: skip
    path = frame.displaced({2 * count: {"y": 0.6}, 4 * count + 1: {"y": 0.6}}, [0.5, 1.0])
    soft, stiff = path.reactions[:, 2 * count, 1], path.reactions[:, 4 * count + 1, 1]
    np.testing.assert_allclose(stiff, 2 * soft, rtol=1e-9)

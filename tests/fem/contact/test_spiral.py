"""The logarithmic spiral as the exact shape of a contact surface."""

from math import atan, cos, hypot, nan, radians, sin

import numpy as np
import pytest

from fem.contact.shapes import Circle, Motion, Spiral

POLE, RADIUS, START, GROWTH = (0.3, -0.2), 2.0, radians(-80), 0.15


@pytest.fixture
def spiral():
    return Spiral(POLE, RADIUS, START, GROWTH)


def point(angle, off=0.0):
    """Points (2, m) of the spiral at angles (m,), or `off` outwards along the normals."""
    rho = RADIUS * np.exp(GROWTH * (angle - START))
    normal = angle - atan(GROWTH)
    x = rho * np.cos(angle) + off * np.cos(normal)
    y = rho * np.sin(angle) + off * np.sin(normal)
    return np.array([x, y]) + np.array(POLE)[:, None]


ANGLES = START + np.linspace(-2.5, 2.5, 41)


@pytest.mark.parametrize("off", [-0.5, 0.5])
def test_the_nearest_point_of_a_point_on_a_normal_is_its_foot(spiral, off):
    feet = point(ANGLES)
    np.testing.assert_allclose(spiral.project(point(ANGLES, off)), feet, rtol=0, atol=1e-14)


def test_the_curvature_is_that_of_the_circle_through_three_near_points(spiral):
    a, b, c = (point(np.array([START + k * 1e-3]))[:, 0] for k in (-1, 0, 1))
    area = abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
    sides = np.prod([hypot(*(p - q)) for p, q in ((a, b), (b, c), (a, c))])
    assert spiral.curvature == pytest.approx(4 * area / sides, rel=1e-5)


def test_without_growth_it_is_a_circle():
    x = np.array([[0.5, 3.0, -1.0], [-3.0, 0.1, 2.0]])
    spiral, circle = Spiral(POLE, RADIUS, START, 0.0), Circle(POLE, RADIUS)
    np.testing.assert_allclose(spiral.project(x), circle.project(x), atol=1e-14)
    np.testing.assert_allclose(spiral.normal(x), circle.normal(x), atol=1e-14)
    assert spiral.curvature == circle.curvature


def test_a_moved_spiral_runs_through_the_moved_points(spiral):
    motion = Motion((0.4, -0.1), 0.3, (1.0, 2.0))
    x = point(ANGLES)
    moved = x + motion.displacement(x)
    np.testing.assert_allclose(spiral.moved(motion).project(moved), moved, atol=1e-14)
    turned = np.array([[cos(0.3), -sin(0.3)], [sin(0.3), cos(0.3)]]) @ spiral.normal(x)
    np.testing.assert_allclose(spiral.moved(motion).normal(moved), turned, atol=1e-14)


@pytest.mark.parametrize(
    ("changed", "rule"),
    [
        ({"radius": 0.0}, "radius must be positive"),
        ({"growth": nan}, "finite"),
    ],
)
def test_a_spiral_that_cannot_be_is_refused(changed, rule):
    with pytest.raises(ValueError, match=rule):
        Spiral(**{"pole": POLE, "radius": RADIUS, "start": START, "growth": GROWTH} | changed)

"""Exact shapes of contact surfaces, and their rigid motions."""

from math import atan, cos, hypot, nan, radians, sin

import numpy as np
import pytest

from fem.contact.shapes import Circle, Motion, Spiral

POLE, RADIUS, START, GROWTH = (0.3, -0.2), 2.0, radians(-80), 0.15


SPIRAL = Spiral(POLE, RADIUS, START, GROWTH)


def point(angle, off=0.0):
    """Points (2, m) of the spiral at angles (m,), or `off` outwards along the normals."""
    rho = RADIUS * np.exp(GROWTH * (angle - START))
    normal = angle - atan(GROWTH)
    x = rho * np.cos(angle) + off * np.cos(normal)
    y = rho * np.sin(angle) + off * np.sin(normal)
    return np.array([x, y]) + np.array(POLE)[:, None]


ANGLES = START + np.linspace(-2.5, 2.5, 41)


@pytest.mark.parametrize("off", [-0.5, 0.5])
def test_the_nearest_point_of_a_point_on_a_normal_is_its_foot(off):
    feet = point(ANGLES)
    np.testing.assert_allclose(SPIRAL.project(point(ANGLES, off)), feet, rtol=0, atol=1e-14)


def test_the_curvature_is_that_of_the_circle_through_three_near_points():
    a, b, c = (point(np.array([START + k * 1e-3]))[:, 0] for k in (-1, 0, 1))
    area = abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
    sides = np.prod([hypot(*(p - q)) for p, q in ((a, b), (b, c), (a, c))])
    assert SPIRAL.curvature == pytest.approx(4 * area / sides, rel=1e-5)
    flat, circle = Spiral(POLE, RADIUS, START, 0.0), Circle(POLE, RADIUS)  # no growth
    assert flat.curvature == circle.curvature


def test_a_moved_spiral_runs_through_the_moved_points():
    motion = Motion((0.4, -0.1), 0.3, (1.0, 2.0))
    x = point(ANGLES)
    moved = x + motion.displacement(x)
    np.testing.assert_allclose(SPIRAL.moved(motion).project(moved), moved, atol=1e-14)
    turned = np.array([[cos(0.3), -sin(0.3)], [sin(0.3), cos(0.3)]]) @ SPIRAL.normal(x)
    np.testing.assert_allclose(SPIRAL.moved(motion).normal(moved), turned, atol=1e-14)


@pytest.mark.parametrize(
    ("changed", "rule"),
    [
        ({"radius": 0.0}, "radius of a spiral must be positive"),
        ({"growth": nan}, "finite"),
    ],
)
def test_a_spiral_that_cannot_be_is_refused(changed, rule):
    with pytest.raises(ValueError, match=rule):
        Spiral(**{"pole": POLE, "radius": RADIUS, "start": START, "growth": GROWTH} | changed)


def test_a_circle_that_turns_about_one_of_its_points_still_contains_it():
    about = (0.3 + 40 * np.cos(0.2), 40 * np.sin(0.2))
    motion = Motion((0.5, -0.25), 0.1, about)
    moved = Circle((0.3, 0.0), 40.0, hollow=True).moved(motion)
    assert np.hypot(*np.subtract(motion.of(about), moved.centre)) == pytest.approx(40, rel=1e-14)


@pytest.mark.parametrize("angle", [1e-12, -2.0])
def test_a_rigid_motion_is_found_from_what_it_does_to_points(angle):
    x = np.random.default_rng(6).normal(size=(2, 7))
    motion = Motion((0.1, -0.2), angle, tuple(x.mean(axis=1)))
    assert Motion.fitted(x, motion.displacement(x)).angle == pytest.approx(angle, abs=1e-15)

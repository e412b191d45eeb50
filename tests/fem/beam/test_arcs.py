"""Arcs and rings by Castigliano's integrals: chords converge at order 2, curved elements at 4.

M, N and V of the centre line count through EI, EA and GA, without the coupling of thick bars.
"""

from math import pi

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.section import Section
from fem.beam.straight import solve_frame

R, P = 1.5, 7.0
THICK = Section(EA=300.0, EI=20.0, GA=100.0)  # every part counts
THIN = Section(EA=20e6, EI=20.0, GA=8e6)  # as of a strip 1/1000 of the radius thick
ORDER = {"chords": 2, "curves": 4}
SPREAD = 0.1  # of an order observed between 8 and 16 elements a quarter
both_geometries = pytest.mark.parametrize("geometry", ORDER)
both_sections = pytest.mark.parametrize("section", [THICK, THIN], ids=["thick", "thin"])


def compliances(section):
    """R^3 / EI, R / EA and R / GA."""
    return R**3 / section.EI, R / section.EA, R / section.GA


def quarter_compliance(section):
    """Of a quarter built in at (0, R), for a force (x, y) and a couple on its end at (R, 0).

    At the angle t from the end M = (R sin t, R (1 - cos t), 1), N = (-sin t, cos t, 0) and
    V = (cos t, sin t, 0) for the three unit loads; int sin^2 = pi/4, int (1 - cos)^2 = 3 pi/4 - 2.
    """
    a, b, c = compliances(section)
    both = pi / 4 * (b + c)
    return np.array([
        [a * pi / 4 + both, a / 2 - b / 2 + c / 2, a / R],
        [a / 2 - b / 2 + c / 2, a * (3 * pi / 4 - 2) + both, a / R * (pi / 2 - 1)],
        [a / R, a / R * (pi / 2 - 1), a / R**2 * pi / 2],
    ])  # fmt: skip


def solve(geometry, count, angle, **problem):
    """An arc of `angle` [rad] from (R, 0) on; nodes 0 to `count` are its elements' ends."""
    phi = np.linspace(0, angle, 2 * count + 1)
    points = R * np.column_stack([np.cos(phi), np.sin(phi)])
    points = np.vstack([points[::2], points[1::2]])
    k = np.arange(count)
    if angle == 2 * pi:  # the last end is the first
        points = np.delete(points, count, axis=0)
        ring = np.column_stack([k, (k + 1) % count])
        elements = np.column_stack([ring, count + k])
    else:
        elements = np.column_stack([k, k + 1, count + 1 + k])
    if geometry == "curves":
        return solve_curved_frame(points, elements, **problem)
    ends = elements[:, :2]
    return solve_frame(points[: ends.max() + 1], ends, **problem)


def assert_order(error, geometry):
    """`error` of 8 and of 16 elements a quarter."""
    coarse, fine = np.linalg.norm(error(8)), np.linalg.norm(error(16))
    assert np.log2(coarse / fine) == pytest.approx(ORDER[geometry], abs=SPREAD), (coarse, fine)


@both_sections
@both_geometries
def test_the_end_of_a_quarter_moves_as_its_integrals_say(geometry, section):
    load = (1.0, -0.7, 0.4)
    exact = quarter_compliance(section) @ load

    def error(count):
        s = solve(
            geometry, count, pi / 2, sections=section, supports={count: "xyr"}, loads={0: load}
        )
        return s.u[0] - exact

    assert_order(error, geometry)


@both_sections
@both_geometries
def test_a_two_hinged_semicircle_pushes_its_feet_apart(geometry, section):
    # P down on the crown: dU/dH = 0 of the quarter under (-H, P/2) gives
    # H = P/pi (a - b + c) / (a + b + c); P/pi = 0.318 P when thin
    a, b, c = compliances(section)
    thrust = P / pi * (a - b + c) / (a + b + c)

    def arch(count):
        return solve(
            geometry, 2 * count, pi, sections=section, supports={0: "xy", 2 * count: "xy"},
            loads={count: (0.0, -P, 0.0)},
        )  # fmt: skip

    assert_order(lambda count: np.array(arch(count).reaction(0)[0] + thrust), geometry)
    force = np.array([-thrust, P / 2, 0])
    sink = 2 * force @ quarter_compliance(section) @ force / P  # Clapeyron: two quarters' energy
    assert_order(lambda count: arch(count).u[count, 1] + sink, geometry)


def ring(geometry, count, section):
    """Held at its foot (0, -R), pulled by P at its head."""
    return solve(
        geometry, 4 * count, 2 * pi, sections=section, supports={3 * count: "xyr"},
        loads={count: (0.0, P, 0.0)},
    )  # fmt: skip


@both_sections
@both_geometries
def test_a_ring_pulled_by_two_opposite_forces_grows_along_and_shrinks_across(geometry, section):
    # M = P R / 2 (cos t - 2/pi), N = P/2 cos t, V = -P/2 sin t from the waist on
    a, b, c = compliances(section)
    along = P * (a * (pi / 4 - 2 / pi) + pi / 4 * (b + c))
    across = -P * (a * (2 / pi - 1 / 2) - b / 2 + c / 2)

    def error(count):
        u = ring(geometry, count, section).u
        return u[count, 1] - along, u[0, 0] - u[2 * count, 0] - across

    assert_order(error, geometry)

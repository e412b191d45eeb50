"""Arcs by Castigliano's integrals: chords converge at order 2, curved elements at 4.

M, N and V of the centre line count through EI, EA and GA, without the coupling of thick bars.
"""

from math import pi

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.section import Section
from fem.beam.straight import solve_frame

R = 1.5
THICK = Section(EA=300.0, EI=20.0, GA=100.0)  # every part counts
THIN = Section(EA=20e6, EI=20.0, GA=8e6)  # as of a strip 1/1000 of the radius thick
ORDER = {"chords": 2, "curves": 4}
SPREAD = 0.1  # of an order observed between 8 and 16 elements a quarter


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


def quarter(geometry, count, **problem):
    """From (R, 0) to (0, R); nodes 0 to `count` are its elements' ends."""
    phi = np.linspace(0, pi / 2, 2 * count + 1)
    points = R * np.column_stack([np.cos(phi), np.sin(phi)])
    k = np.arange(count)
    if geometry == "curves":
        points = np.vstack([points[::2], points[1::2]])
        return solve_curved_frame(points, np.column_stack([k, k + 1, count + 1 + k]), **problem)
    return solve_frame(points[::2], np.column_stack([k, k + 1]), **problem)


@pytest.mark.parametrize("section", [THICK, THIN], ids=["thick", "thin"])
@pytest.mark.parametrize("geometry", ORDER)
def test_the_end_of_a_quarter_moves_as_its_integrals_say(geometry, section):
    load = (1.0, -0.7, 0.4)
    errors = []
    for count in (8, 16):
        s = quarter(geometry, count, sections=section, supports={count: "xyr"}, loads={0: load})
        errors.append(np.linalg.norm(s.u[0] - quarter_compliance(section) @ load))
    assert np.log2(errors[0] / errors[1]) == pytest.approx(ORDER[geometry], abs=SPREAD)


def test_section_forces_of_a_quarter_under_a_force_follow_the_sine():
    F, n = 7.0, 12
    s = quarter("curves", n, sections=THIN, supports={0: "xyr"}, loads={n: (F, 0.0, 0.0)})
    angle = np.arctan2(s.stations[..., 1], s.stations[..., 0])
    # the force F along x at height R bends the section at height R sin(angle) by -F (R - R sin)
    N, _, M = np.moveaxis(s.section_forces, -1, 0)
    assert pytest.approx(-F * R * (1 - np.sin(angle)), abs=2e-3 * F * R) == M
    assert pytest.approx(-F * np.sin(angle), abs=2e-2 * F) == N

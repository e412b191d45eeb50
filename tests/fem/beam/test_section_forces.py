"""Section forces against statics: what equilibrium alone says, for both kinds of frames."""

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.section import Section
from fem.beam.straight import solve_frame

STRIP = Section(EA=2e6, EI=3e3, GA=8e5)
F, L = 7.0, 0.9


def straight(points, supports, loads, **more):
    line = np.column_stack([np.arange(len(points) - 1), np.arange(1, len(points))])
    return solve_frame(points, line, sections=STRIP, supports=supports, loads=loads, **more)


def curved(points, supports, loads):
    """The same line as elements with a middle node, in the order of `points`."""
    middle = (points[:-1] + points[1:]) / 2
    n = len(points)
    elements = np.column_stack([np.arange(n - 1), np.arange(1, n), n + np.arange(n - 1)])
    nodes = np.vstack([points, middle])
    return solve_curved_frame(nodes, elements, sections=STRIP, supports=supports, loads=loads)


@pytest.mark.parametrize("solve", [straight, curved])
def test_a_cantilever_carries_force_times_distance(solve):
    points = np.column_stack([np.linspace(0, L, 7), np.zeros(7)])
    s = solve(points, {0: "xyr"}, {6: (5.0, F, 0.0)})
    x = s.stations[..., 0]
    N, V, M = np.moveaxis(s.section_forces, -1, 0)
    assert pytest.approx(5.0) == N.ravel()
    assert pytest.approx(F) == V.ravel()  # dM/dx = -V
    assert pytest.approx(F * (L - x).ravel(), abs=1e-9) == M.ravel()


def test_a_quarter_arc_under_a_force_follows_the_sine():
    R, n = 0.3, 12
    t = np.linspace(0, np.pi / 2, 2 * n + 1)  # from the clamp at (R, 0) to the tip at (0, R)
    nodes = R * np.column_stack([np.cos(t), np.sin(t)])
    elements = np.column_stack([np.arange(0, 2 * n, 2), np.arange(2, 2 * n + 1, 2),
                                np.arange(1, 2 * n, 2)])  # fmt: skip
    s = solve_curved_frame(
        nodes, elements, sections=STRIP, supports={0: "xyr"}, loads={2 * n: (F, 0.0, 0.0)}
    )
    angle = np.arctan2(s.stations[..., 1], s.stations[..., 0])
    # the force F along x at height R bends the section at height R sin(angle) by -F (R - R sin)
    exact = -F * R * (1 - np.sin(angle))
    assert pytest.approx(exact, abs=2e-3 * F * R) == s.section_forces[..., 2]
    assert pytest.approx(-F * np.sin(angle), abs=2e-2 * F) == s.section_forces[..., 0]

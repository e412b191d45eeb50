"""Steps that would carry a line through another, or through an obstacle, are given up."""

import pytest

from fem.beam.large_balance import ConvergenceError
from fem.beam.touching import Obstacle, SelfContact
from fem.beam.touching_rigid import Disc
from tests.fem.beam.touching_shapes import at_rest, line, rotated, together

B, R = 1.0, 10.0
refused = pytest.raises(ConvergenceError, match="parts of the frame would pass through each other")


def two_lines(nodes=3):
    """Two lines 3 b apart, their contact and the first node of the upper."""
    points, elements, (_, upper) = together(
        line((0, 0), (30, 0), 10, nodes), line((5.3, 3 * B), (24.6, 3 * B), 6, nodes)
    )
    term = SelfContact(points, elements, thickness=B, EA=1.0)
    term.start(at_rest(points))
    return term, at_rest(points), upper


@pytest.mark.parametrize("nodes", [2, 3], ids=["straight", "quadratic"])
def test_a_line_beyond_another_did_not_get_there(nodes):
    term, x, upper = two_lines(nodes)
    x[upper:, 1] -= 20 * B
    with refused:
        term.settle(x)
    assert not term.evaluate(x)[1].any()
    # half through: beside probes that are near enough to be pushed back
    term, x, upper = two_lines(nodes)
    x[upper:, 1] -= 1.5 * (x[upper:, 0] - 5)
    assert term.passing.passed(x)


def test_lines_may_turn_together_and_go_round_each_others_ends_step_by_step():
    term, x, upper = two_lines()
    for angle in (0.5, -2.0, 3.0):
        assert not term.settle(rotated(x, angle))
    for move in ((60.0, 0.0), (0.0, -20.0), (-60.0, 0.0)):  # from the last accepted state on
        x[upper:, :2] += move
        assert not term.settle(x)
        term.accept(x)


@pytest.mark.parametrize("carried", [False, True], ids=["beam moves", "disc moves"])
def test_a_line_does_not_leap_over_a_disc(carried):
    points, elements, (_, stub) = together(line((0, 0), (30, 0), 10), line((15, 9), (16, 9), 1))
    disc = Disc((15, 5), 2.0)
    term = Obstacle(
        points, elements[:10], disc, thickness=B, EA=1.0, carrier=stub if carried else None
    )
    x = at_rest(points)
    moving, way = (slice(stub, None), -1) if carried else (slice(0, stub), 1)
    term.start(x)
    aside = x.copy()
    aside[moving, :2] += 40.0 * way, 3.0 * way
    assert not term.settle(aside)
    x[moving, 1] += 20.0 * way
    with refused:
        term.settle(x)
    assert not term.evaluate(x)[1].any()

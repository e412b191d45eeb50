"""Frames in contact against closed forms of thin beams; steps that would penetrate."""

import numpy as np
import pytest

from fem.beam.large import LargeFrame
from fem.beam.large_balance import ConvergenceError
from fem.beam.section import Section
from fem.beam.touching import BeamObstacle, SelfContact
from fem.beam.touching_passing import _times
from fem.beam.touching_rigid import DiscObstacle, FlatObstacle
from tests.fem.beam.touching_shapes import at_rest, chain, line, rotated, together

L, B, EI = 1.0, 0.01, 1.0
EA = 12 * EI / B**2
SECTION = Section(EA=EA, EI=EI, GA=EA)
GAP = 3e-3


def cantilevers(reach):
    """An upper cantilever of length L and a lower one of length `reach`, both clamped at x = 0."""
    points, elements, (_, second) = together(
        line((0, 0), (reach, 0), 8), line((0, B + GAP), (L, B + GAP), 8)
    )
    contact = SelfContact(points, elements, thickness=B, EA=EA)
    frame = LargeFrame(
        points, elements, sections=SECTION, supports={0: "xyr", second: "xyr"}, terms=[contact]
    )
    return frame, contact, second, len(points) - 1


def touching(reach):
    """Load at the upper tip at which the lower tip touches."""
    return 6 * EI * GAP / (reach**2 * (3 * L - reach))


def test_two_cantilevers_share_a_load_once_they_touch():
    reach = 0.7
    # with l = reach, at the lower tip: F l^2 (3L - l)/6EI - N l^3/3EI = gap + N l^3/3EI
    frame, contact, _, tip = cantilevers(reach)
    state, before = frame.rest(), 0.0
    for factor in (0.9, 1.5, 2.0, 3.0):
        force = factor * touching(reach)
        state = frame.under_loads({tip: (0.0, before - force, 0.0)}, [1.0], since=state).last
        before = force
        exact = max(0.0, (factor - 1) * GAP * 3 * EI / (2 * reach**3))
        # slopes of some thousandths squared, and where on the round end of b/2 they touch
        assert contact.record.normal.sum() == pytest.approx(exact, rel=2e-3), factor
        assert contact.record.penetration < 1e-3 * B
    lower, bodies = state.u[: len(state.u) // 2, 1].min(), {"low": range(8), "up": range(8, 16)}
    assert contact.record.pressing(bodies) == {("low", "up"): pytest.approx(exact, rel=2e-3)}
    _, y = contact.record.between(bodies)["low", "up"]
    assert y == pytest.approx(-exact, rel=2e-3)
    assert lower == pytest.approx(-exact * reach**3 / (3 * EI), rel=2e-3)


MU, WEIGHT = 0.2, 5.0


def lying(support):
    """A beam on a rough flat, held by `support` at its left end, under its weight."""
    points, elements = line((0, B / 2), (L, B / 2), 4)
    flat = BeamObstacle(
        points, elements, FlatObstacle((0, 0), (0, 1)), thickness=B, EA=EA, friction=MU
    )
    frame = LargeFrame(
        points, elements, sections=SECTION, supports={0: support} if support else {}, terms=[flat]
    )
    weight = dict.fromkeys(range(len(elements)), (0.0, -WEIGHT / L))
    return frame, flat, frame.under_loads(None, [0.5, 1.0], distributed=weight).last


def test_a_beam_is_dragged_by_friction_times_its_weight():
    frame, flat, pressed = lying("x")
    assert flat.record.normal.sum() == pytest.approx(WEIGHT, rel=1e-9)
    path = frame.displaced({0: {"x": 0.3 * L}}, [1e-5, 1e-4, 0.5, 1.0], since=pressed)
    np.testing.assert_allclose(path.reactions[1:, 0, 0], MU * WEIGHT, rtol=1e-9)
    assert not flat.record.sticking.any()
    last = path.last
    assert flat.dissipated == pytest.approx(MU * WEIGHT * 0.3 * L, rel=1e-4)
    stored = last.strain_energy - pressed.strain_energy + last.term_energy - pressed.term_energy
    assert last.work - pressed.work == pytest.approx(stored + flat.dissipated, rel=1e-5)


def test_a_pull_below_the_friction_does_not_move_a_beam():
    frame, flat, pressed = lying("")
    end = len(frame.points) - 1
    pull = {end: (MU * WEIGHT, 0.0, 0.0)}
    held = frame.under_loads(pull, [0.5, 0.95], since=pressed).last
    moved = held.u[:, 0] - pressed.u[:, 0]
    assert np.abs(moved).max() < MU * WEIGHT * L / EA  # its elongation, not a slide
    assert flat.record.tangential.sum() == pytest.approx(0.95 * MU * WEIGHT, rel=1e-6)
    with pytest.raises(ArithmeticError, match="no equilibrium"):
        frame.under_loads(pull, [0.1], since=held)


THICK, R = 1.0, 10.0
refused = pytest.raises(
    ConvergenceError, match="the step moves parts of the frame through each other"
)


def two_lines(nodes=3):
    """Two lines at a distance of 3 b, their contact and the first node of the upper."""
    points, elements, (_, upper) = together(
        line((0, 0), (30, 0), 10, nodes), line((5.3, 3 * THICK), (24.6, 3 * THICK), 6, nodes)
    )
    term = SelfContact(points, elements, thickness=THICK, EA=1.0)
    term.start(at_rest(points))
    return term, at_rest(points), upper


@pytest.mark.parametrize("nodes", [2, 3], ids=["straight", "quadratic"])
def test_a_line_beyond_another_did_not_get_there(nodes):
    term, x, upper = two_lines(nodes)
    x[upper:, 1] -= 20 * THICK
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
    past = x.copy()
    past[upper:, :2] += 60.0, -5.0
    assert not term.settle(past)
    for move in ((60.0, 0.0), (0.0, -20.0), (-60.0, 0.0)):  # from the last accepted state on
        x[upper:, :2] += move
        assert not term.settle(x)
        term.accept(x)


@pytest.mark.parametrize("carried", [False, True], ids=["beam moves", "disc moves"])
def test_a_line_does_not_leap_over_a_disc(carried):
    points, elements, (_, stub) = together(line((0, 0), (30, 0), 10), line((15, 9), (16, 9), 1))
    disc = DiscObstacle((15, 5), 2.0)
    term = BeamObstacle(
        points, elements[:10], disc, thickness=THICK, EA=1.0, carrier=stub if carried else None
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


def test_the_times_at_which_a_moving_place_is_in_line_with_a_moving_chord():
    """Two times where both are parallel; a place that has none stays on one side of the chord."""
    along, off = np.random.default_rng(3).uniform(-1, 1, (2, 2, 200, 2))

    def side(time, which):
        return np.linalg.det(np.stack([
            (1 - time) * v[0, which] + time * v[1, which] for v in (along, off)
        ], axis=1))  # fmt: skip

    found = np.array(_times(along, off))
    twice = np.isfinite(found).all(axis=0)
    assert 50 < twice.sum() < 200
    assert abs(found[0] - found[1])[twice].min() > 1e-6
    for time in found[:, twice]:
        scale = 1 + time**2  # of the place and of the chord at this time
        assert side(time[:, None], twice) / scale == pytest.approx(0, abs=1e-12)
    for time in np.linspace(-5, 6, 45):
        assert (side(time, ~twice) * side(0.0, ~twice) > 0).all()


def test_corners_that_move_towards_each_other_meet_before_the_next_look_round():
    """Each by half a thickness in x and in y: others are searched for in a wider range."""
    gap, step = 2.3 * THICK, 0.49 * THICK
    assert gap - 2 * np.sqrt(2) * step < THICK
    side = np.linspace(4, 0, 17)  # elements of half a thickness
    bent = np.concatenate([np.column_stack([side, 0 * side]),
                           np.column_stack([0 * side, side])[::-1][1:]])  # fmt: skip
    points, elements, (_, second) = together(
        (-bent, chain(len(bent))), (bent + gap / np.sqrt(2), chain(len(bent)))
    )
    term = SelfContact(points, elements, thickness=THICK, EA=1.0)
    term.start(at_rest(points))
    nearer = at_rest(points)
    nearer[:second, :2] += step
    nearer[second:, :2] -= step
    assert term.evaluate(nearer)[1].any()

"""Contact terms alone: their force is the energy's slope, their tangent the force's.

States are random, near those in which lines overlap by a few hundredths of the thickness.
"""

import numpy as np
import pytest

from fem.beam.touching import Obstacle, SelfContact
from fem.beam.touching_rigid import Disc, Flat
from tests.fem.beam.touching_shapes import (
    at_rest,
    couples,
    differences,
    line,
    ring,
    rotated,
    together,
)

B = 0.3
SHAPES = {
    "flat": Flat((0.0, 0.25), (0.1, -1.0)),
    "disc": Disc((1.0, 2.0), 1.6),
    "bore": Disc((2.0, -1.0), 3.0, inside=True),
}


def crossing(nodes, friction=0.0, slide=0.002):
    """Two bowed lines that overlap by 0.01 after a random movement and a slide."""
    lower, cells = line((0, 0), (4, 0.3), 4, nodes, bulge=0.3)
    upper, _ = line((0.3, 1.3), (4.5, 0.9), 4, nodes, bulge=-0.15)
    points, elements, (_, second) = together((lower, cells), (upper, cells))
    term = SelfContact(points, elements, thickness=B, EA=1.0, friction=friction)
    x = at_rest(points)
    term.start(x)
    y = x + 1e-3 * np.random.default_rng(1).normal(size=x.shape)
    y[:second, 0] += slide
    for _ in range(20):
        met = term.pairs.nearest(y)
        y[second:, 1] -= met.distance.min() - B + 0.01
    term.settle(y)  # which places stick
    term.law.normal[:] = 0.0
    return term, x, y


def on_obstacle(shape, friction=0.0, carrier=None):
    points, elements, _ = together(line((0, 0), (4, 0.1), 4, bulge=-0.2), line((6, 6), (7, 7), 1))
    term = Obstacle(
        points, elements[:4], shape, thickness=B, EA=1.0, friction=friction, carrier=carrier
    )
    x = at_rest(points)
    x0 = x.copy()
    for _ in range(30):  # touch at rest
        term.start(x0)
        _, surface = term.body.nearest(x0)
        gap = surface.distance - B / 2
        x0[:9, :2] -= (gap.min()) * term.body.normals(x0, surface)[gap.argmin()]
    term.start(x0)
    y = x0 + 3e-3 * np.random.default_rng(2).normal(size=x.shape)
    y[9:, 2] += 0.02
    for _ in range(30):
        _, surface = term.body.nearest(y)
        gap = surface.distance - B / 2
        y[:9, :2] -= (gap.min() + 0.01) * term.body.normals(y, surface)[gap.argmin()]
    term.settle(y)  # which places stick
    term.law.normal[:] = 0.0
    return term, x0, y


@pytest.mark.parametrize("nodes", [2, 3], ids=["straight", "quadratic"])
def test_the_force_of_lines_is_the_slope_of_their_energy(nodes):
    term, _, y = crossing(nodes)
    _, force, _ = term.evaluate(y)
    energy, _ = differences(term, y)
    assert np.abs(force).max() > 0
    np.testing.assert_allclose(energy, force, atol=1e-7 * np.abs(force).max())


@pytest.mark.parametrize(
    ("nodes", "friction", "slide"), [(2, 0.0, 0.02), (3, 0.3, 0.0002), (3, 0.3, 0.02)],
    ids=["smooth", "sticks", "slides"],
)  # fmt: skip
def test_the_tangent_of_lines_is_the_slope_of_their_force(nodes, friction, slide):
    term, _, y = crossing(nodes, friction, slide=slide)
    _, _, K = term.evaluate(y)
    _, force = differences(term, y)
    np.testing.assert_allclose(K.toarray(), force, atol=1e-7 * np.abs(force).max())


@pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES)
def test_the_force_of_an_obstacle_is_the_slope_of_its_energy(shape):
    term, _, y = on_obstacle(shape, carrier=10)
    _, force, _ = term.evaluate(y)
    energy, _ = differences(term, y)
    assert np.abs(force).max() > 0
    np.testing.assert_allclose(energy, force, atol=1e-7 * np.abs(force).max())


@pytest.mark.parametrize(
    ("shape", "friction", "carrier"),
    [("flat", 0.3, 10), ("disc", 0.0, 10), ("disc", 0.3, None), ("bore", 0.3, 10)],
)
def test_the_tangent_of_an_obstacle_is_the_slope_of_its_force(shape, carrier, friction):
    term, _, y = on_obstacle(SHAPES[shape], friction, carrier)
    _, _, K = term.evaluate(y)
    _, force = differences(term, y)
    np.testing.assert_allclose(K.toarray(), force, atol=1e-7 * np.abs(force).max())


def test_lines_act_on_each_other_without_resultant():
    term, _, y = crossing(3, 0.3)
    _, force, _ = term.evaluate(y)
    assert np.abs(force).max() > 0
    np.testing.assert_allclose(couples(y, force), 0, atol=1e-13 * np.abs(force).max())


@pytest.mark.parametrize("shape", SHAPES.values(), ids=SHAPES)
def test_a_carried_obstacle_takes_what_the_line_gives(shape):
    term, _, y = on_obstacle(shape, 0.3, carrier=10)
    _, force, _ = term.evaluate(y)
    assert np.abs(force).max() > 0
    np.testing.assert_allclose(couples(y, force), 0, atol=1e-12 * np.abs(force).max())


def test_contact_is_the_same_after_a_rigid_rotation():
    angle = -2.5
    term, _, y = crossing(3, 0.3)
    energy, force, _ = term.evaluate(y)
    turned_energy, turned, _ = term.evaluate(rotated(y, angle))
    there = rotated(force.reshape(-1, 3), angle) - [0, 0, angle]
    assert turned_energy == pytest.approx(energy, rel=1e-9)
    np.testing.assert_allclose(turned.reshape(-1, 3), there, atol=1e-9 * np.abs(force).max())


def test_turning_together_is_no_slip_and_passing_by_is():
    term, _, y = crossing(3, friction=10.0, slide=0.0)
    term.evaluate(y)
    term.accept(y)
    for angle in np.linspace(0, 1, 6)[1:]:
        term.accept(rotated(y, angle))
    assert np.abs(term._touch(rotated(y, 1.0)).slip).max() < 1e-13
    y[: len(y) // 2, 0] += 1e-3  # the lower line goes to the right, under the upper
    slip = term._touch(rotated(y, 1.0)).slip
    assert np.abs(np.abs(slip) - 1e-3).max() < 1e-4  # but for its own slope


def test_lines_apart_do_not_act():
    term, x, _ = crossing(3)
    energy, force, K = term.evaluate(x)
    assert energy == 0
    assert not force.any()
    assert not K.toarray().any()


def test_a_line_does_not_touch_its_own_neighbourhood():
    points, elements = ring((0, 0), 1.0, 48)  # elements of 0.13 for a thickness of 0.3
    term = SelfContact(points, elements, thickness=B, EA=1.0)
    term.start(at_rest(points))
    assert not len(term.record.gap)
    assert term.pairs.nearest(at_rest(points)).distance.min(initial=9.0) > B


def test_the_free_end_is_round():
    # a line that ends at height h above another touches it when h is a thickness
    base, tip = line((-1, 0), (1, 0), 4), lambda h: line((0.1, h), (0.1, 1.0), 2)
    for h, touching in ((1.001 * B, False), (0.999 * B, True)):
        points, elements, _ = together(base, tip(h))
        term = SelfContact(points, elements, thickness=B, EA=1.0)
        term.start(at_rest(points))
        assert bool(len(term.record.gap)) is touching, h


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"thickness": 0.0}, "thickness must be positive and finite, got 0.0"),
        ({"EA": float("inf")}, "EA must be positive and finite, got inf"),
        ({"friction": -0.1}, "friction must be 0 or more, got -0.1"),
        ({"share": 0.0}, "share must be positive and finite, got 0.0"),
        ({"per_element": 0}, "an element needs 1 probe or more, got per_element = 0"),
        ({"apart": -1.0}, "apart must be a length of 0 or more, got -1.0"),
    ],
)
def test_impossible_input_is_named(wrong, words):
    points, elements = line((0, 0), (1, 0), 2)
    with pytest.raises(ValueError, match=words.replace("(", r"\(")):
        SelfContact(points, elements, **({"thickness": 0.1, "EA": 1.0} | wrong))


def test_impossible_obstacles_are_named():
    points, elements = line((0, 0), (1, 0), 2)
    with pytest.raises(ValueError, match="the normal of a flat has a length"):
        Flat((0, 0), (0, 0))
    with pytest.raises(ValueError, match="a disc's radius is positive, got -1"):
        Disc((0, 0), -1.0)
    with pytest.raises(ValueError, match="no node 5: the frame has nodes 0 to 4"):
        Obstacle(points, elements, Flat((0, 0), (0, 1)), thickness=0.1, EA=1.0, carrier=5)
    with pytest.raises(ValueError, match="no node 9: the frame has nodes 0 to 4"):
        Obstacle(points, [[0, 9]], Flat((0, 0), (0, 1)), thickness=0.1, EA=1.0)

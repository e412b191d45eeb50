"""Contact terms alone: the force is the derivative of the energy, the tangent that of the force.

States are random, near those in which lines overlap by a few hundredths of the thickness.
"""

import numpy as np
import pytest

from fem.beam.touching import BeamObstacle, SelfContact
from fem.beam.touching_rigid import DiscObstacle, FlatObstacle
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
    "flat": FlatObstacle((0.0, 0.25), (0.1, -1.0)),
    "disc": DiscObstacle((1.0, 2.0), 1.6),
    "bore": DiscObstacle((2.0, -1.0), 3.0, inside=True),
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
    term = BeamObstacle(
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


def check_slopes(term, y, friction):
    """Force and tangent by differences; friction alone has no energy."""
    _, force, K = term.evaluate(y)
    energy, slope = differences(term, y)
    largest = np.abs(force).max()
    assert largest > 0
    if not friction:
        np.testing.assert_allclose(energy, force, atol=1e-7 * largest)
    np.testing.assert_allclose(K.toarray(), slope, atol=1e-7 * largest)
    return force


@pytest.mark.parametrize(
    ("nodes", "friction", "slide"),
    [(2, 0.0, 0.02), (3, 0.0, 0.002), (3, 0.3, 0.0002), (3, 0.3, 0.02)],
    ids=["straight", "quadratic", "sticks", "slides"],
)
def test_lines_push_each_other_with_the_slope_of_their_energy(nodes, friction, slide):
    term, x, y = crossing(nodes, friction, slide=slide)
    force = check_slopes(term, y, friction)
    np.testing.assert_allclose(couples(y, force), 0, atol=1e-13 * np.abs(force).max())
    energy, force, K = term.evaluate(x)  # no contact
    assert energy == 0
    assert not force.any()
    assert not K.toarray().any()


@pytest.mark.parametrize(
    ("shape", "friction", "carrier"),
    [("flat", 0.0, 10), ("flat", 0.3, 10), ("disc", 0.0, 10), ("disc", 0.3, None),
     ("bore", 0.0, 10), ("bore", 0.3, 10)],
)  # fmt: skip
def test_an_obstacle_pushes_with_the_slope_of_its_energy(shape, friction, carrier):
    term, _, y = on_obstacle(SHAPES[shape], friction, carrier)
    force = check_slopes(term, y, friction)
    if carrier:  # which takes what the line gives
        np.testing.assert_allclose(couples(y, force), 0, atol=1e-12 * np.abs(force).max())


def test_lines_that_turn_together_push_equally_and_do_not_slip():
    term, _, y = crossing(3, friction=10.0, slide=0.0)
    energy, force, _ = term.evaluate(y)
    term.accept(y)
    for angle in np.linspace(0, 1, 6)[1:]:
        turned_energy, turned, _ = term.evaluate(rotated(y, angle))
        there = rotated(force.reshape(-1, 3), angle) - [0, 0, angle]
        assert turned_energy == pytest.approx(energy, rel=1e-9)
        np.testing.assert_allclose(turned.reshape(-1, 3), there, atol=1e-9 * np.abs(force).max())
        term.accept(rotated(y, angle))
    assert np.abs(term._touch(rotated(y, 1.0)).slip).max() < 1e-13
    y[: len(y) // 2, 0] += 1e-3  # the lower line goes to the right, under the upper
    slip = term._touch(rotated(y, 1.0)).slip
    assert np.abs(np.abs(slip) - 1e-3).max() < 1e-4  # except its slope


def test_a_line_does_not_touch_its_neighbouring_elements_and_its_free_end_is_round():
    points, elements = ring((0, 0), 1.0, 48)  # elements of 0.13 for a thickness of 0.3
    term = SelfContact(points, elements, thickness=B, EA=1.0)
    term.start(at_rest(points))
    assert not len(term.record.gap)
    # a line that ends at height h above another touches it when h is a thickness
    for h, touching in ((1.001 * B, False), (0.999 * B, True)):
        points, elements, _ = together(line((-1, 0), (1, 0), 4), line((0.1, h), (0.1, 1.0), 2))
        term = SelfContact(points, elements, thickness=B, EA=1.0)
        term.start(at_rest(points))
        assert bool(len(term.record.gap)) is touching, h


LINE = line((0, 0), (1, 0), 2)


def contact(**wrong):
    return SelfContact(*LINE, **({"thickness": 0.1, "EA": 1.0} | wrong))


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: contact(thickness=0.0), "thickness must be positive and finite, got 0.0"),
        (lambda: contact(EA=float("inf")), "EA must be positive and finite, got inf"),
        (lambda: contact(friction=-0.1), "friction must be finite and 0 or more, got -0.1"),
        (lambda: contact(share=0.0), "share must be positive and finite, got 0.0"),
        (lambda: contact(per_element=0), "number of probes, must be 1 or more, got 0"),
        (lambda: contact(apart=-1.0), "apart must be a finite length of 0 or more, got -1.0"),
        (lambda: FlatObstacle((0, 0), (0, 0)), "the normal of a flat must not be zero"),
        (lambda: DiscObstacle((0, 0), -1.0), "the radius of a disc must be positive, got -1"),
        (lambda: BeamObstacle(*LINE, SHAPES["flat"], thickness=0.1, EA=1.0, carrier=5),
         "no node 5: the frame has nodes 0 to 4"),
        (lambda: BeamObstacle(LINE[0], [[0, 9]], SHAPES["flat"], thickness=0.1, EA=1.0),
         "no node 9: the frame has nodes 0 to 4"),
    ],
)  # fmt: skip
def test_impossible_input_is_named(make, words):
    with pytest.raises(ValueError, match=words):
        make()

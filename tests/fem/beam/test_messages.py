"""A frame that makes no sense is refused, and the message names what is wrong with it."""

from math import inf, nan

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.section import Section
from fem.beam.straight import solve_frame

SECTION = Section(EA=100.0, EI=10.0, GA=50.0)


def straight(points=((0, 0), (1, 0), (2, 0)), elements=((0, 1), (1, 2)), **changed):
    """A cantilever of two elements with something `changed`."""
    problem = {"sections": SECTION, "supports": {0: "xyr"}, "loads": {}}
    return solve_frame(points, elements, **(problem | changed))


def curved(points=((0, 0), (1, 0), (2, 0)), elements=((0, 1), (1, 2)), **changed):
    """The same with middle nodes, numbered after all ends."""
    points, elements = np.asarray(points, float), np.asarray(elements)
    numbers = len(points) + np.arange(len(elements))
    problem = {"sections": SECTION, "supports": {0: "xyr"}, "loads": {}}
    return solve_curved_frame(
        np.vstack([points, points[elements].mean(axis=1)]), np.column_stack([elements, numbers]),
        **(problem | changed),
    )  # fmt: skip


def one_curved(middle):
    return solve_curved_frame(
        [(0, 0), (1, 0), middle], [(0, 1, 2)], sections=SECTION, supports={0: "xyr"}, loads={}
    )


both_solvers = pytest.mark.parametrize("solve", [straight, curved])


APART = {"points": ((0, 0), (1, 0), (0.3, 1.1), (1.1, 1.7)), "elements": ((0, 1), (2, 3))}
RIGID = r"frame can move rigidly \(.*"


@both_solvers
@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"supports": {}}, RIGID),
        ({"supports": {0: "xr", 2: "x"}}, RIGID + "y"),
        ({"supports": {0: "xy"}}, RIGID + "rotation"),
        (APART | {"supports": {0: "xyr", 2: "xy"}}, "rigidly|support|mechanism"),
        ({"points": ((0, 0), (1, 0), (5, 5)), "elements": ((0, 1),)},
         "node 2 belongs to no element"),
        ({"supports": {0: "xyr", 9: "x"}}, r"no node 9: the frame has nodes 0 to [24]"),
        ({"loads": {9: (1.0, 0.0, 0.0)}}, r"no node 9: the frame has nodes 0 to [24]"),
        ({"loads": {-1: (0.0, 1.0, 0.0)}}, "no node -1"),
        ({"supports": {0: "z"}}, "node 0: components are x, y, r, got 'z'"),
        ({"sections": {"leaf": SECTION}, "bodies": {"arm": [0], "stem": [1]}},
         "no body 'leaf'; bodies: arm, stem"),
        ({"sections": {"leaf": SECTION}}, "no body 'leaf'; bodies: none"),
        ({"sections": {"arm": SECTION}, "bodies": {"arm": [0]}}, "1 of 2 elements have no section"),
    ],
)  # fmt: skip
def test_a_frame_that_makes_no_sense_is_named(solve, changed, message):
    with pytest.raises(ValueError, match=message):
        solve(**changed)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Section(EA=0.0, EI=1.0), "must be positive.*EA=0"),
        (lambda: Section(EA=1.0, EI=-1.0), "must be positive.*EI=-1"),
        (lambda: Section(EA=1.0, EI=1.0, GA=nan), "must be positive.*GA=nan"),
        (lambda: Section(EA=1.0, EI=inf), "must be finite.*EI=inf"),
        (lambda: curved(sections=Section(EA=1.0, EI=1.0)), "finite shear stiffness GA"),
        # quadratic elements are regular while the middle lies in the inner half, 1/4 to 3/4
        (lambda: one_curved((1.4, 0)), "folded or has no length"),
        (lambda: one_curved((1, 0)), "folded or has no length"),
        (lambda: straight(elements=((0, 1), (1, 2), (2, 3))), "no node 3: the frame has nodes 0"),
        (lambda: straight(points=((0, 0), (1, 0), (1, 0))), "element 1 has no length"),
        (lambda: straight(distributed={7: (0.0, 1.0)}),
         "no element 7: the frame has elements 0 to 1"),
    ],
)  # fmt: skip
def test_what_one_of_the_solvers_refuses_is_named(make, message):
    with pytest.raises(ValueError, match=message):
        make()

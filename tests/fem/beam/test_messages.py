"""Invalid frames and states without equilibrium give one line that names the error."""

import re
from math import inf, nan

import numpy as np
import pytest

from fem.beam.curved import solve_curved_frame
from fem.beam.large import LargeFrame
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
        ({"supports": {0: "yr"}}, RIGID + r"[+-]1 x\)"),
        ({"supports": {0: "xr", 2: "x"}}, RIGID + "y"),
        ({"supports": {0: "xy"}}, RIGID + "rotation"),
        (APART | {"supports": {0: "xyr", 2: "xy"}}, "rigidly|support|mechanism"),
        ({"points": ((0, 0), (1, 0), (5, 5)), "elements": ((0, 1),)},
         "every node must belong to an element, but node 2 does not"),
        ({"supports": {0: "xyr", 9: "x"}}, r"no node 9: the frame has nodes 0 to [24]"),
        ({"loads": {9: (1.0, 0.0, 0.0)}}, r"no node 9: the frame has nodes 0 to [24]"),
        ({"loads": {-1: (0.0, 1.0, 0.0)}}, "no node -1"),
        ({"supports": {0: "z"}}, "node 0: components must be x, y or r, got 'z'"),
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
        (lambda: straight(points=((0, 0), (1, 0), (1, 0))), "length of element 1 must not be zero"),
        (lambda: straight(distributed={7: (0.0, 1.0)}),
         "no element 7: the frame has elements 0 to 1"),
    ],
)  # fmt: skip
def test_what_one_of_the_solvers_refuses_is_named(make, message):
    with pytest.raises(ValueError, match=message):
        make()


SOFT = Section(EA=1e4, EI=1.0, GA=1e4)
LINE = [(0, 0), (1, 0), (2, 0)]
PAIRS = [(0, 1), (1, 2)]


def frame(points=LINE, elements=PAIRS, **given):
    return LargeFrame(points, elements, **({"sections": SOFT, "supports": {0: "xyr"}} | given))


def path(factors=(1.0,), loads=None, supports=None, **given):
    return frame(supports=supports or {0: "xyr"}).under_loads(
        loads or {2: (0, 1, 0)}, factors, **given
    )


WRONG = {
    "every section of a geometrically exact beam needs a finite GA":
        lambda: frame(sections=Section(EA=1, EI=1)),
    "elements must have 2 or 3 nodes each": lambda: frame(elements=[(0, 1, 2, 3)]),
    "no node 7: the frame has nodes 0 to 2": lambda: path(loads={7: (0, 1, 0)}),
    "every node must belong to an element, but node 2 does not": lambda: frame(elements=[(0, 1)]),
    "element 1 is folded or has no length": lambda: frame([(0, 0), (1, 0), (1, 0)]),
    "no body 'arc'; bodies: none": lambda: frame(sections={"arc": SOFT}),
    "node 0: components must be x, y or r, got 'z'": lambda: frame(supports={0: "xyz"}),
    "node 0: supports must prescribe 0; use displaced() for other displacements":
        lambda: frame(supports={0: {"x": 0.1, "y": 0, "r": 0}}),
    "node 2: components must be x, y or r, got 'phi'":
        lambda: frame().displaced({2: {"phi": 1.0}}, [1.0]),
    "prescribed displacements must be finite numbers":
        lambda: frame().displaced({2: {"x": np.nan}}, [1.0]),
    "loads must be finite numbers": lambda: path(loads={2: (np.inf, 0, 0)}),
    "factors must be finite numbers, got [0.5, nan]": lambda: path(factors=[0.5, np.nan]),
    "no element 5: the frame has 2 elements": lambda: path(distributed={5: (0, 1)}),
    "the frame can move rigidly (":
        lambda: path(supports={0: "xr"}),
    "along_arc needs loads or displacements that move the frame":
        lambda: frame().along_arc({2: (0, 0, 0)}, first=1.0),
    "the loads must cause an axial or a shear force: otherwise the":
        lambda: frame().linear_buckling({2: (0, 0, 1)}),
    "9 modes need more than 6 unknowns: refine the mesh":
        lambda: frame().linear_buckling({2: (-1, 0, 0)}, count=9),
}  # fmt: skip


@pytest.mark.parametrize("message", WRONG)
def test_wrong_input_gets_one_line(message):
    with pytest.raises(ValueError, match=re.escape(message)) as caught:
        WRONG[message]()
    assert "\n" not in str(caught.value)


def toggle():
    return LargeFrame([(0, 0), (4, 1)], [(0, 1)], sections=SOFT, supports={0: "xy", 1: "xr"})


def test_a_load_beyond_a_limit_point_names_factor_residual_and_what_was_tried():
    """A bar from (0, 0) to (4, 1) carries EA (1 - l / l_0) y / l at the most, l^3 = 16 l_0."""
    l_0 = np.sqrt(17.0)
    length = (16 * l_0) ** (1 / 3)
    limit = 1e4 * (1 - length / l_0) * np.sqrt(length**2 - 16) / length
    assert toggle().under_loads({1: (0, -1, 0)}, [0.999 * limit]).negative.tolist() == [0]
    with pytest.raises(ArithmeticError) as caught:
        toggle().under_loads({1: (0, -1, 0)}, [10.0, 1.01 * limit])
    found = str(caught.value)
    assert "\n" not in found
    number = re.search(r"no equilibrium was found beyond factor ([\d.]+) towards", found)
    assert float(number[1]) == pytest.approx(limit, rel=1e-3)
    assert "with steps down to" in found
    assert "along_arc()" in found


def test_a_path_whose_end_is_not_reached_states_where_it_stopped():
    with pytest.raises(ArithmeticError, match=r"none of 3 states; .* at the factor"):
        frame().along_arc({2: (0, 1, 0)}, first=0.1, steps=3, until=lambda s: False)

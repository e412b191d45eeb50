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


both_solvers = pytest.mark.parametrize("solve", [straight, curved])


@pytest.mark.parametrize("name", ["EA", "EI", "GA"])
@pytest.mark.parametrize("value", [0.0, -1.0, nan])
def test_a_stiffness_that_is_not_positive_is_refused(name, value):
    with pytest.raises(ValueError, match=f"must be positive.*{name}={value}"):
        Section(**({"EA": 1.0, "EI": 1.0, "GA": 1.0} | {name: value}))


@pytest.mark.parametrize("name", ["EA", "EI"])
def test_only_the_shear_stiffness_may_be_infinite(name):
    with pytest.raises(ValueError, match=f"must be finite.*{name}=inf"):
        Section(**({"EA": 1.0, "EI": 1.0} | {name: inf}))


def test_the_curved_beam_needs_a_finite_shear_stiffness():
    with pytest.raises(ValueError, match="finite shear stiffness GA"):
        curved(sections=Section(EA=1.0, EI=1.0))


@both_solvers
@pytest.mark.parametrize(
    ("supports", "motion"),
    [
        pytest.param({}, "x|y|rotation", id="none"),
        pytest.param({0: "xr", 2: "x"}, "y", id="free across"),
        pytest.param({0: "yr", 2: "y"}, "x", id="free along"),
        pytest.param({0: "xy"}, "rotation", id="free to turn about a hinge"),
        pytest.param({0: "xy", 2: "x"}, "rotation", id="two parallel rollers on one line"),
    ],
)
def test_the_motion_that_the_supports_leave_is_named(solve, supports, motion):
    with pytest.raises(ValueError, match=rf"frame can move rigidly \(.*({motion}).*\)"):
        solve(supports=supports)


@both_solvers
def test_a_member_that_hangs_on_nothing_is_refused(solve):
    # a second member beside the supported one, not joined to it
    with pytest.raises(ValueError, match=r"rigidly|support"):
        solve(
            ((0, 0), (1, 0), (0, 1), (1, 1)), ((0, 1), (2, 3)), loads={3: (0.0, 1.0, 0.0)},
        )  # fmt: skip


@both_solvers
@pytest.mark.parametrize("held", ["x", "y", "r", "xy", "xr", "yr"])
@pytest.mark.parametrize("load", [(0.0, 1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 0.0)], ids=str)
def test_a_member_apart_from_the_others_needs_supports_of_its_own(solve, load, held):
    # an inclined second member, held against some motions only, whether the load moves it or not
    with pytest.raises(ValueError, match=r"rigidly|support|mechanism"):
        solve(
            ((0, 0), (1, 0), (0.3, 1.1), (1.1, 1.7)), ((0, 1), (2, 3)),
            supports={0: "xyr", 2: held}, loads={3: load},
        )  # fmt: skip


@both_solvers
def test_two_members_that_each_have_supports_may_be_apart(solve):
    s = solve(
        ((0, 0), (1, 0), (0, 1), (1, 1)), ((0, 1), (2, 3)), supports={0: "xyr", 2: "xyr"},
        loads={3: (2.0, 0.0, 0.0)},
    )  # fmt: skip
    assert s.u[3] == pytest.approx((2 / 100, 0, 0), abs=1e-15)
    assert not s.u[1].any()


@both_solvers
def test_a_node_that_no_element_uses_is_refused(solve):
    with pytest.raises(ValueError, match="node 2 belongs to no element"):
        solve(((0, 0), (1, 0), (5, 5)), ((0, 1),))


@pytest.mark.parametrize("unknown", [3, -1])
def test_an_element_between_unknown_nodes_is_refused(unknown):
    with pytest.raises(ValueError, match=f"no node {unknown}: the frame has nodes 0 to 2"):
        straight(elements=((0, 1), (1, 2), (2, unknown)))
    with pytest.raises(ValueError, match=f"no node {unknown}: the frame has nodes 0 to 2"):
        solve_curved_frame(
            [(0, 0), (1, 0), (2, 0)], [(0, 2, 1), (2, 0, unknown)], sections=SECTION,
            supports={0: "xyr"}, loads={},
        )  # fmt: skip


@both_solvers
@pytest.mark.parametrize(
    "changed",
    [
        pytest.param({"supports": {0: "xyr", 9: "x"}}, id="supports"),
        pytest.param({"loads": {9: (1.0, 0.0, 0.0)}}, id="loads"),
    ],
)
def test_an_unknown_node_is_named_beside_the_known_ones(solve, changed):
    with pytest.raises(ValueError, match=r"no node 9: the frame has nodes 0 to [24]"):
        solve(**changed)


@both_solvers
def test_a_node_is_not_counted_from_the_end(solve):
    with pytest.raises(ValueError, match="no node -1"):
        solve(loads={-1: (0.0, 1.0, 0.0)})


@both_solvers
@pytest.mark.parametrize("support", ["z", "xn", {"phi": 0.0}], ids=str)
def test_an_unknown_component_is_named_with_its_node(solve, support):
    with pytest.raises(ValueError, match=r"node 0: components are x, y, r, got '(z|n|phi)'"):
        solve(supports={0: support})


@both_solvers
def test_an_unknown_body_is_named_beside_the_known_ones(solve):
    with pytest.raises(ValueError, match="no body 'leaf'; bodies: arm, stem"):
        solve(sections={"leaf": SECTION}, bodies={"arm": [0], "stem": [1]})
    with pytest.raises(ValueError, match="no body 'leaf'; bodies: none"):
        solve(sections={"leaf": SECTION})


@both_solvers
def test_elements_without_a_section_are_counted(solve):
    with pytest.raises(ValueError, match="1 of 2 elements have no section"):
        solve(sections={"arm": SECTION}, bodies={"arm": [0]})


def test_an_element_without_length_is_named():
    with pytest.raises(ValueError, match="element 1 has no length"):
        straight(points=((0, 0), (1, 0), (1, 0)))


@pytest.mark.parametrize(
    "points",
    [
        pytest.param([(0, 0), (1, 0), (1, 0)], id="middle on an end"),
        pytest.param([(0, 0), (1, 0), (1.4, 0)], id="middle beyond an end"),
        pytest.param([(0, 0), (0, 0), (0, 0)], id="no length"),
    ],
)
def test_a_folded_curved_element_is_refused(points):
    # quadratic elements are regular while the middle lies in the inner half, 1/4 to 3/4
    with pytest.raises(ValueError, match="folded or has no length"):
        solve_curved_frame(
            points, [(0, 1, 2)], sections=SECTION, supports={0: "xyr"}, loads={}
        )  # fmt: skip


def test_an_even_load_on_an_unknown_element_is_refused():
    with pytest.raises(ValueError, match="no element 7: the frame has elements 0 to 1"):
        straight(distributed={7: (0.0, 1.0)})


@both_solvers
def test_a_load_that_is_no_number_has_no_answer(solve):
    with pytest.raises((ValueError, ArithmeticError)):
        solve(loads={2: (nan, 0.0, 0.0)})


@both_solvers
def test_a_frame_without_loads_stays_where_it_is(solve):
    s = solve()
    assert not s.u.any()
    assert s.strain_energy == 0.0
    assert s.residual == 0.0

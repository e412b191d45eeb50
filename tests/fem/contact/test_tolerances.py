"""Tolerances of the contact solver from both sides, and slips far smaller than gaps elsewhere."""

from types import SimpleNamespace

import numpy as np
import pytest

from fem.contact.active_sets import fitting_states
from fem.contact.complementarity import Complementarity
from fem.contact.solution import ContactSolution
from fem.contact.system import FORWARD, OPEN, STICK


def smooth(D=None):
    """Two nodes without friction on unit compliance."""
    return Complementarity(
        B=np.eye(2), D=np.zeros((2, 0)) if D is None else D, friction=np.zeros(2),
        partner=np.array([-1, -1]), part=np.array([0, 0]),
    )  # fmt: skip


@pytest.mark.parametrize(("tension", "state"), [(1e-13, STICK), (1e-9, OPEN)])
def test_a_node_opens_under_tension_and_not_under_round_off(tension, state):
    closed = np.array([STICK, STICK], np.int8)
    found = fitting_states(
        smooth(), np.array([-1.0, 0.0]), np.array([1.0, -tension]), np.zeros(0), closed
    )
    assert found[1] == state


@pytest.mark.parametrize(("overlap", "state"), [(1e-13, OPEN), (1e-9, STICK)])
def test_a_node_closes_by_an_overlap_and_not_by_round_off(overlap, state):
    # the gap of 1 and the approach of 1 + overlap
    states, w_0 = np.array([STICK, OPEN], np.int8), np.array([-1.0, 1.0 - overlap])
    system = Complementarity(
        B=np.array([[1.0, -1.0], [-1.0, 2.0]]), D=np.zeros((2, 0)), friction=np.zeros(2),
        partner=np.array([-1, -1]), part=np.array([0, 0]),
    )  # fmt: skip
    found = fitting_states(system, w_0, np.array([1.0, 0.0]), np.zeros(0), states)
    assert found[1] == state


@pytest.mark.parametrize(("load", "unloaded"), [(1e-14, True), (1e-12, False)])
def test_a_load_counts_beyond_round_off_of_the_gaps(load, unloaded):
    assert smooth(np.ones((2, 1))).is_unloaded(np.ones(2), np.array([load])) is unloaded


@pytest.mark.parametrize(("gap", "left"), [(1e-15, 0.0), (1e-12, 1e-12)])
def test_a_gap_of_an_unloaded_body_counts_beyond_round_off_of_the_largest(gap, left):
    assert smooth().without_round_off(np.array([1.0, gap])).tolist() == [1.0, left]


@pytest.mark.parametrize(("share", "slides"), [(1e-12, True), (1e-6, False)])
def test_a_contact_slides_where_sticking_nodes_carry_round_off_alone(share, slides):
    one = SimpleNamespace(touches=[SimpleNamespace(sticking_share=share)])
    assert ContactSolution.slides.fget(one) is slides


def test_a_slip_is_measured_by_its_own_row_not_by_a_gap_far_away():
    # Row 0 touches under pressure 1, row 1 is open by 1e6. Sliding forward (traction 1e-6, the
    # limit) would need a slip of +5e-7, with the traction: it sticks at 5e-7 instead.
    kernel = Complementarity(
        B=np.eye(4), D=np.zeros((4, 0)), friction=np.array([1e-6, 1e-6]),
        partner=np.array([2, 3]), part=np.array([0, 0]),
    )  # fmt: skip
    w_0 = np.array([-1.0, 1e6, -5e-7, 0.0])
    rest = kernel.solve(w_0, np.zeros(0), np.array([FORWARD, 0], np.int8))
    assert rest.states[0] == STICK
    assert np.isclose(rest.multipliers[2], 5e-7, rtol=1e-12)


def beside_an_obstacle():
    """A body that meets one obstacle, which it moves to."""
    return Complementarity(
        B=np.eye(1), D=np.array([[-1.0]]), friction=np.zeros(1), partner=np.array([-1]),
        part=np.zeros(1, int),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("left", "state"),
    [
        pytest.param(1e-14, OPEN, id="round-off of the path"),
        pytest.param(-1e-13, OPEN, id="round-off of the other sign"),
        pytest.param(-1e-9, STICK, id="an overlap"),
    ],
)
def test_a_gap_counts_against_the_path_whichever_direction_a_body_goes(left, state):
    # it went by 1e3 to where the gap is `left` of that
    path = np.array([1e3])
    w_0 = np.array([1e3 * (1 + left)])
    system, none = beside_an_obstacle(), np.zeros(1, np.int8)
    found = fitting_states(system, w_0, np.zeros(1), path, none)
    assert found.tolist() == [state]

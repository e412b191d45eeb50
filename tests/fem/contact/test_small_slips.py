"""Slips much smaller than gaps elsewhere still decide what sticks."""

import numpy as np
import pytest

from fem.contact.active_sets import fitting_states
from fem.contact.complementarity import Complementarity
from fem.contact.system import FORWARD, OPEN, STICK


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


def beside_an_obstacle(sense):
    """A body that meets one obstacle, which it moves to along `sense`."""
    return Complementarity(
        B=np.eye(1), D=np.array([[-sense]]), friction=np.zeros(1), partner=np.array([-1]),
        part=np.zeros(1, int),
    )  # fmt: skip


@pytest.mark.parametrize("sense", [1.0, -1.0])
@pytest.mark.parametrize(
    ("left", "state"),
    [
        pytest.param(1e-14, OPEN, id="round-off of the way"),
        pytest.param(-1e-13, OPEN, id="round-off the other way"),
        pytest.param(-1e-9, STICK, id="an overlap"),
    ],
)
def test_a_gap_counts_against_the_way_whichever_way_a_body_goes(sense, left, state):
    # it went by 1e3 to where the gap is `left` of that
    way = np.array([1e3 * sense])
    w_0 = np.array([1e3 * (1 + left)])
    system, none = beside_an_obstacle(sense), np.zeros(1, np.int8)
    found = fitting_states(system, w_0, np.zeros(1), way, none)
    assert found.tolist() == [state]

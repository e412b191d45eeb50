"""Tolerances of the contact solver from both sides, and slips far smaller than gaps elsewhere."""

from types import SimpleNamespace

import numpy as np
import pytest

from fem.contact.active_sets import fitting_states
from fem.contact.complementarity import Complementarity
from fem.contact.residual import residual
from fem.contact.solution import ContactSolution
from fem.contact.system import FORWARD, OPEN, STICK


def smooth(B=((1.0, 0.0), (0.0, 1.0)), D=None):
    """Nodes without friction, on the compliance B."""
    n = len(B)
    return Complementarity(
        B=np.array(B), D=np.zeros((n, 0)) if D is None else np.array(D), friction=np.zeros(n),
        partner=np.full(n, -1), part=np.zeros(n, int),
    )  # fmt: skip


COUPLED = smooth(((1.0, -1.0), (-1.0, 2.0)))
MOVED = smooth([[1.0]], [[-1.0]])  # a body that meets one obstacle, which it moves to


@pytest.mark.parametrize(
    ("system", "w_0", "multipliers", "motion", "before", "state"),
    [
        pytest.param(smooth(), [-1.0, 0.0], [1.0, -1e-13], [], STICK, STICK, id="round-off"),
        pytest.param(smooth(), [-1.0, 0.0], [1.0, -1e-9], [], STICK, OPEN, id="tension"),
        # the gap of 1 and the approach of 1 and a little
        pytest.param(COUPLED, [-1.0, 1.0 - 1e-13], [1.0, 0.0], [], OPEN, OPEN, id="round-off"),
        pytest.param(COUPLED, [-1.0, 1.0 - 1e-9], [1.0, 0.0], [], OPEN, STICK, id="an overlap"),
        # it went by 1e3 to where the gap is a share of that
        pytest.param(MOVED, [1e3 * (1 + 1e-14)], [0.0], [1e3], OPEN, OPEN, id="of a path"),
        pytest.param(MOVED, [1e3 * (1 - 1e-13)], [0.0], [1e3], OPEN, OPEN, id="the other sign"),
        pytest.param(MOVED, [1e3 * (1 - 1e-9)], [0.0], [1e3], OPEN, STICK, id="after a path"),
    ],
)
def test_a_node_opens_and_closes_by_more_than_round_off(
    system, w_0, multipliers, motion, before, state
):
    states = np.array([STICK, before] if len(w_0) == 2 else [before], np.int8)
    found = fitting_states(system, np.array(w_0), np.array(multipliers), np.array(motion), states)
    assert found[-1] == state


def test_loads_gaps_and_slips_count_beyond_round_off():
    for load, unloaded in ((1e-14, True), (1e-12, False)):
        system = smooth(D=np.ones((2, 1)))
        assert system.is_unloaded(np.ones(2), np.array([load])) is unloaded
    for gap, left in ((1e-15, 0.0), (1e-12, 1e-12)):
        assert smooth().without_round_off(np.array([1.0, gap])).tolist() == [1.0, left]
    for share, slides in ((1e-12, True), (1e-6, False)):
        one = SimpleNamespace(touches=[SimpleNamespace(sticking_share=share)])
        assert ContactSolution.slides.fget(one) is slides


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_what_a_gap_misses_counts_against_the_path_whichever_direction_a_body_goes(way):
    # bodies overlap by 0.1 at the end of a path of 1e6
    system = smooth([[1.0]], [[-way]])
    none = np.zeros(1)
    found = residual(system, np.array([1e6 - 0.1]), none, none, np.array([way * 1e6]))
    assert found.gap == pytest.approx(0.1 / (1e-5 * 2e6), rel=1e-6)


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

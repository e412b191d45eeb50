"""Slips much smaller than gaps elsewhere still decide what sticks."""

import numpy as np

from fem.contact.complementarity import FORWARD, STICK, Complementarity


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

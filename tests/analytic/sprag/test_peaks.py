"""What a design counts by: ends that carry count for more by strips than by slices."""

import numpy as np
import pytest

from analytic.sprag.peaks import END, Peaks

PRESSURE = np.array([[[2.0, 1.0, 2.5, 1.0, 2.0], [0.0, 3.0, 2.0, 3.0, 0.0]]])  # 1 crown, 2 torques


def peaks(by):
    return Peaks(np.ones((1, 3)), np.array([10.0, 25.0]), np.ones((1, 2)), PRESSURE, by)


def test_slices_count_by_their_largest_pressure():
    assert peaks("slices").objective.tolist() == peaks("slices").largest.tolist() == [[2.5, 3.0]]


def test_strips_count_ends_that_carry_for_more():
    assert peaks("strips").objective == pytest.approx(np.array([[END * 2.0, 3.0]]))
    assert peaks("strips").largest.tolist() == [[2.5, 3.0]]


def test_one_torque_alone_keeps_its_numbers():
    alone = peaks("strips").of(1)
    assert alone.torques.tolist() == [25.0]
    assert alone.end.tolist() == [[0.0]]
    assert alone.inside.tolist() == [[3.0]]

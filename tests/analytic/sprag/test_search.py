"""The least load at which something reaches a goal."""

import numpy as np
import pytest

from analytic.sprag.search import first_reach


def test_a_power_is_inverted_to_round_off_from_any_first_guess():
    goal = np.array([1e-6, 1.0, 1e6])
    for start in (1e-8, 1.0, 1e8):
        found = first_reach(lambda N: N**0.9, goal, start=np.full(3, start))
        assert found == pytest.approx(goal ** (1 / 0.9), rel=1e-12)


def test_of_two_places_the_one_on_the_way_comes_first():
    found = first_reach(lambda N: N * (4 - N), np.array(3.0), start=np.array(1.0))
    assert float(found) == pytest.approx(1.0, rel=1e-12)


def test_a_goal_beyond_the_last_value_is_never_reached():
    def ends(N):
        return np.where(N <= 7.0, N, np.nan)

    found = first_reach(ends, np.array([6.99, 7.01]), start=np.ones(2))
    assert found[0] == pytest.approx(6.99, rel=1e-12)
    assert np.isnan(found[1])


def test_where_nothing_is_sought_the_load_is_zero():
    found = first_reach(lambda N: N, np.array([0.0, 2.0]), start=np.array([0.0, 2.0]))
    assert found.tolist() == [0.0, pytest.approx(2.0, rel=1e-12)]

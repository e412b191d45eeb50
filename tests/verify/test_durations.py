"""Remaining time: a plain estimate from measured levels and a cost model."""

import pytest

from verify.cases.registry import CASES
from verify.core.store import Store
from verify.jobs import timing as durations
from verify.jobs.timing import expected_seconds, refined, remaining_seconds


def test_a_level_takes_what_it_took():
    known = {("ring", 2): 0.3, ("ring", 4): 0.4}
    assert expected_seconds([("ring", 4)], known) == {("ring", 4): 0.4}


def test_an_unknown_level_is_scaled_from_the_nearest_of_its_case_with_the_square():
    known = {("ring", 2): 0.5, ("ring", 8): 4.0, ("spring", 16): 99.0}
    expected = expected_seconds([("ring", 16), ("ring", 1)], known)
    assert expected == {("ring", 16): 4.0 * 4, ("ring", 1): 0.5 / 4}


def test_an_unknown_case_costs_at_its_finest_level_what_the_others_do():
    known = {("a", 8): 3.0, ("a", 4): 1.0, ("b", 32): 5.0, ("c", 2): 7.0}
    expected = expected_seconds([("new", 6), ("new", 3)], known)
    assert expected == {("new", 6): 5.0, ("new", 3): 5.0 / 4}


def test_earlier_durations_are_taken_at_the_pace_of_this_run():
    """A machine, or an hour, that is twice as slow: 6 s for what took 3 s."""
    earlier = {("a", 8): 2.0, ("a", 4): 1.0, ("b", 8): 5.0}
    now = refined(earlier, {("a", 8): 4.4, ("a", 4): 1.6})
    assert now == {("a", 8): 4.4, ("a", 4): 1.6, ("b", 8): pytest.approx(10.0)}


@pytest.mark.parametrize("measured", [{}, {("new", 1): 3.0}])
def test_without_a_level_in_common_the_pace_is_the_earlier_one(measured):
    assert refined({("a", 8): 2.0}, measured) == {("a", 8): 2.0} | measured


@pytest.mark.parametrize(
    ("running", "waiting", "processes", "left"),
    [
        pytest.param([], [], 2, 0.0, id="nothing left"),
        pytest.param([], [3.0, 2.0, 1.0], 1, 6.0, id="one after the other"),
        pytest.param([], [3.0, 2.0, 1.0], 2, 3.0, id="two processes"),
        pytest.param([], [3.0, 2.0], 8, 3.0, id="more processes than levels"),
        pytest.param([(10.0, 4.0)], [1.0, 1.0], 2, 6.0, id="a long level under way"),
        pytest.param([(10.0, 4.0), (2.0, 1.0)], [3.0, 3.0], 2, 7.0, id="two under way"),
        pytest.param([(1.0, 4.0)], [], 1, 2.0, id="beyond what was expected: half as long again"),
    ],
)
def test_what_is_left_by_hand(running, waiting, processes, left):
    assert remaining_seconds(running, waiting, processes) == pytest.approx(left)


def test_the_usual_seconds_are_of_levels_of_the_suite():
    levels = {(case.id, level) for case in CASES for level in case.levels}
    assert durations.usual().keys() <= levels
    assert len(durations.usual()) > 0.9 * len(levels)


def test_durations_are_stored_and_added_to(tmp_path):
    durations.store(tmp_path, {("ring-lame", 16): 3.25})
    durations.store(tmp_path, {("ring-lame", 16): 3.5, ("spring, two words", 2): 0.125})
    assert durations.load(tmp_path) == {("ring-lame", 16): 3.5, ("spring, two words", 2): 0.125}


def test_entries_that_make_no_sense_are_ignored(tmp_path):
    odd = {"a": b"1", "a x": b"2", "a 2": b"-1", "a 3": b"x", "a 4": b"nan", "a 5": b"inf",
           "a 6": b"", "a 7": b"0", " 8": b"1", "a -9": b"1", "a 10": b"\xff"}  # fmt: skip
    Store(tmp_path).store(durations.KIND, durations.KIND, odd | {"b 2": b"3"})
    assert durations.load(tmp_path) == {("b", 2): 3.0}

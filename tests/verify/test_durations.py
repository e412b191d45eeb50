"""Remaining time: a plain estimate from measured levels and a cost model."""

import pytest

from verify.core.store import Store
from verify.jobs import timing as durations
from verify.jobs.timing import expected_seconds, refined, remaining_seconds


@pytest.mark.parametrize(
    ("levels", "known", "seconds"),
    [
        pytest.param([("a", 4)], {("a", 2): 0.3, ("a", 4): 0.4}, [0.4], id="what it took"),
        pytest.param(
            [("a", 16), ("a", 1)], {("a", 2): 0.5, ("a", 8): 4.0, ("b", 16): 99.0},
            [4.0 * 4, 0.5 / 4], id="from the nearest level of the case with the square",
        ),
        pytest.param(
            [("new", 6), ("new", 3)], {("a", 8): 3.0, ("a", 4): 1.0, ("b", 32): 5.0, ("c", 2): 7.0},
            [5.0, 5.0 / 4], id="the finest of an unknown case as that of the others",
        ),
    ],
)  # fmt: skip
def test_levels_are_expected_to_take_what_the_known_ones_took(levels, known, seconds):
    assert expected_seconds(levels, known) == dict(zip(levels, seconds, strict=True))


def test_earlier_durations_are_taken_at_the_pace_of_this_run():
    """A machine, or an hour, that is twice as slow: 6 s for what took 3 s."""
    earlier = {("a", 8): 2.0, ("a", 4): 1.0, ("b", 8): 5.0}
    now = refined(earlier, {("a", 8): 4.4, ("a", 4): 1.6})
    assert now == {("a", 8): 4.4, ("a", 4): 1.6, ("b", 8): pytest.approx(10.0)}
    for measured in ({}, {("new", 1): 3.0}):  # nothing in common
        assert refined({("a", 8): 2.0}, measured) == {("a", 8): 2.0} | measured


@pytest.mark.parametrize(
    ("running", "waiting", "processes", "left"),
    [
        pytest.param([], [3.0, 2.0, 1.0], 1, 6.0, id="one after the other"),
        pytest.param([], [3.0, 2.0], 8, 3.0, id="more processes than levels"),
        pytest.param([(10.0, 4.0), (2.0, 1.0)], [3.0, 3.0], 2, 7.0, id="two under way"),
        pytest.param([(1.0, 4.0)], [], 1, 2.0, id="beyond what was expected: half as long again"),
    ],
)
def test_what_is_left_by_hand(running, waiting, processes, left):
    assert remaining_seconds(running, waiting, processes) == pytest.approx(left)


def test_durations_are_stored_and_added_to_and_entries_that_make_no_sense_ignored(tmp_path):
    odd = {"a": b"1", "a x": b"2", "a 2": b"-1", "a 3": b"x", "a 4": b"nan", "a 5": b"inf",
           "a 6": b"", "a 7": b"0", " 8": b"1", "a -9": b"1", "a 10": b"\xff"}  # fmt: skip
    Store(tmp_path).store(durations.KIND, durations.KIND, odd)
    durations.store(tmp_path, {("ring-lame", 16): 3.25})
    durations.store(tmp_path, {("ring-lame", 16): 3.5, ("spring, two words", 2): 0.125})
    assert durations.load(tmp_path) == {("ring-lame", 16): 3.5, ("spring, two words", 2): 0.125}

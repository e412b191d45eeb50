"""The dispatcher of all studies: every task once, progress, and messages of interrupted runs."""

from collections import deque

import pytest

from verify.core.store import Store
from verify.jobs import timing as durations
from verify.jobs.dispatch import Dispatch, queue
from verify.jobs.engine import GoneError
from verify.jobs.executor import local
from verify.jobs.timing import expected_seconds, refined, remaining_seconds


def double(task):
    return 2 * task


@pytest.mark.parametrize("processes", [0, 2])
def test_every_task_is_answered_once_also_one_that_the_last_answer_adds(processes):
    waiting, found = deque(range(7)), {}
    dispatch = Dispatch("points", 7)

    def receive(task, answer):
        found[task] = answer
        if 6 <= task < 9:
            waiting.append(task + 1)
            dispatch.total += 1
        return 1

    dispatch.run(local(processes), double, queue(waiting), receive)
    assert found == {n: 2 * n for n in range(10)}
    assert (dispatch.done, dispatch.total) == (10, 10)


def test_the_state_counts_known_levels_and_names_running_ones(monkeypatch):
    states = []
    waiting = deque(["a", "b"])
    dispatch = Dispatch("points", 5, 3, states.append, title=lambda task: f"point {task}")
    dispatch.run(local(0), double, queue(waiting), lambda _task, _answer: 1)
    first, last = states[0], states[-1]
    assert (first.done, first.total, first.running, first.what) == (3, 5, ("point a",), "points")
    assert (last.done, last.running, last.remaining) == (5, (), 0.0)
    # the time left follows the pace of this run
    now = [100.0]
    monkeypatch.setattr("verify.jobs.dispatch.time.monotonic", lambda: now[0])
    dispatch = Dispatch("points", 50, 30)
    assert dispatch.at_pace() == 0.0  # nothing is known
    now[0], dispatch.done = 108.0, 34
    assert dispatch.at_pace() == 2.0 * 16


@pytest.mark.parametrize(
    ("error", "unstored", "words"),
    [
        (KeyboardInterrupt, 0,
         "interrupted; 4 of 5 points are stored: the same command continues with the others"),
        (GoneError, 1,
         "no answer; 3 of 5 points are stored: the same command continues with the others"),
        (GoneError, 4, "no answer; 4 of 5 points are done, and not stored"),
    ],
)  # fmt: skip
def test_an_interrupted_run_states_what_is_stored(error, unstored, words):
    seen = []

    def receive(task, _answer):
        if len(seen) == 1:
            raise error("no answer")
        seen.append(task)
        return 1

    dispatch = Dispatch("points", 5, 3, unstored=unstored)
    with pytest.raises(error) as stopped:
        dispatch.run(local(0), double, queue(deque([1, 2, 3])), receive)
    assert str(stopped.value) == words


# Remaining time: a plain estimate from measured levels and a cost model

KNOWN = {("a", 2): 0.5, ("a", 8): 4.0, ("b", 32): 5.0, ("c", 2): 7.0}


def test_levels_are_expected_to_take_what_the_known_ones_took_at_the_pace_of_this_run():
    found = expected_seconds([("a", 8), ("a", 16), ("a", 1), ("new", 6), ("new", 3)], KNOWN)
    # an unknown level with the square from the nearest, an unknown case as the others' finest
    assert list(found.values()) == [4.0, 4.0 * 4, 0.5 / 4, 5.0, 5.0 / 4]
    now = refined(KNOWN, {("a", 8): 8.4, ("a", 2): 0.6})  # 9 s for what took 4.5 s
    assert now[("a", 8)] == 8.4
    assert now[("b", 32)] == pytest.approx(10.0)
    assert refined(KNOWN, {("new", 1): 3.0}) == KNOWN | {("new", 1): 3.0}


@pytest.mark.parametrize(
    ("running", "waiting", "processes", "left"),
    [
        pytest.param([], [3.0, 2.0, 1.0], 1, 6.0, id="one after the other"),
        pytest.param([], [3.0, 2.0], 8, 3.0, id="more processes than levels"),
        pytest.param([(10.0, 4.0), (2.0, 1.0)], [3.0, 3.0], 2, 7.0, id="two running"),
        pytest.param([(1.0, 4.0)], [], 1, 2.0, id="beyond what was expected: half as long again"),
    ],
)
def test_what_is_left_by_hand(running, waiting, processes, left):
    assert remaining_seconds(running, waiting, processes) == pytest.approx(left)


def test_durations_are_added_to_the_stored_ones_and_entries_that_make_no_sense_ignored(tmp_path):
    odd = {"a": b"1", "a x": b"2", "a 2": b"-1", "a 3": b"x", "a 4": b"nan", "a 6": b"",
           "a 7": b"0", " 8": b"1", "a -9": b"1", "a 10": b"\xff"}  # fmt: skip
    Store(tmp_path).store(durations.KIND, durations.KIND, odd)
    durations.store(tmp_path, {("ring-lame", 16): 3.25})
    durations.store(tmp_path, {("ring-lame", 16): 3.5, ("spring, two words", 2): 0.125})
    assert durations.load(tmp_path) == {("ring-lame", 16): 3.5, ("spring, two words", 2): 0.125}

"""The dispatcher of all studies: every task once, progress, and what an interrupted run says."""

from collections import deque

import pytest

from verify.jobs.dispatch import Dispatch, queue
from verify.jobs.engine import GoneError
from verify.jobs.executor import Lost, local


def double(task):
    return 2 * task


def fail(task):
    raise ArithmeticError(f"no answer to {task}")


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


def test_a_task_that_fails_is_an_answer_and_the_others_go_on():
    answers = []
    dispatch = Dispatch("points", 2)
    dispatch.run(local(0), fail, queue(deque([1, 2])), lambda _task, one: answers.append(one) or 1)
    reasons = [f"ArithmeticError: no answer to {task}" for task in (1, 2)]
    assert [one.reason for one in answers] == reasons
    assert all(isinstance(one, Lost) and "Traceback" in one.trace for one in answers)


def test_the_state_counts_what_was_known_and_names_what_is_under_way(monkeypatch):
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
def test_an_interrupted_run_says_what_is_stored(error, unstored, words):
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

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


def run(tasks, *, function=double, receive=None, processes=0, **options):
    """The answers of a run by task, and the run."""
    waiting, found = deque(tasks), {}

    def keep(task, answer):
        found[task] = answer
        return receive(task, waiting, dispatch) if receive else 1

    dispatch = Dispatch("points", len(waiting), **options)
    dispatch.run(local(processes), function, queue(waiting), keep)
    return found, dispatch


@pytest.mark.parametrize("processes", [0, 2])
def test_every_task_is_answered_once(processes):
    found, dispatch = run(range(7), processes=processes)
    assert found == {n: 2 * n for n in range(7)}
    assert dispatch.done == 7


@pytest.mark.parametrize("processes", [0, 2])
def test_an_answer_may_add_tasks_also_the_last_one(processes):
    def add(task, waiting, dispatch):
        if task < 4:
            waiting.append(task + 1)
            dispatch.total += 1
        return 1

    found, dispatch = run([1], receive=add, processes=processes)
    assert sorted(found) == [1, 2, 3, 4]
    assert (dispatch.done, dispatch.total) == (4, 4)


def test_a_task_that_fails_is_an_answer_and_the_others_go_on():
    found, _ = run([1, 2], function=fail)
    assert [one.reason for one in found.values()] == [
        "ArithmeticError: no answer to 1", "ArithmeticError: no answer to 2",
    ]  # fmt: skip
    assert all(isinstance(one, Lost) and "Traceback" in one.trace for one in found.values())


def test_the_state_counts_what_was_known_and_names_what_is_under_way():
    states = []
    waiting = deque(["a", "b"])
    dispatch = Dispatch("points", 5, 3, states.append, title=lambda task: f"point {task}")
    dispatch.run(local(0), double, queue(waiting), lambda _task, _answer: 1)
    first, last = states[0], states[-1]
    assert (first.done, first.total, first.running, first.what) == (3, 5, ("point a",), "points")
    assert (last.done, last.running, last.remaining) == (5, (), 0.0)


def test_the_time_left_follows_the_pace_of_this_run(monkeypatch):
    now = [100.0]
    monkeypatch.setattr("verify.jobs.dispatch.time.monotonic", lambda: now[0])
    dispatch = Dispatch("points", 50, 30)
    assert dispatch.at_pace() == 0.0  # nothing is known
    now[0], dispatch.done = 108.0, 34
    assert dispatch.at_pace() == 2.0 * 16


@pytest.mark.parametrize(
    ("unstored", "words"),
    [(0, "4 of 5 points are stored: the same command continues with the others"),
     (1, "3 of 5 points are stored: the same command continues with the others"),
     (4, "4 of 5 points are done, and not stored")],
)  # fmt: skip
@pytest.mark.parametrize("error", [KeyboardInterrupt, GoneError])
def test_an_interrupted_run_says_what_is_stored(error, unstored, words):
    waiting = deque([1, 2, 3])
    seen = []

    def receive(task, _answer):
        if len(seen) == 1:
            raise error("no answer")
        seen.append(task)
        return 1

    dispatch = Dispatch("points", 5, 3, unstored=unstored)
    with pytest.raises(error) as stopped:
        dispatch.run(local(0), double, queue(waiting), receive)
    before = "interrupted" if error is KeyboardInterrupt else "no answer"
    assert str(stopped.value) == f"{before}; {words}"

"""Children answer, run out of time, die, and are gone when their parent stops."""

import os
import signal
import time
from functools import partial

import pytest

from tests.verify.mutation.forked import answer, answers
from verify.audit.mutation.sandbox import LATE, Task


def test_answers_come_as_json_from_other_processes():
    found = list(answers([Task(n, lambda n=n: [os.getpid(), n], 20.0) for n in range(4)], 2))
    assert sorted(one.value[1] for one in found) == [0, 1, 2, 3]
    assert len({one.value[0] for one in found} - {os.getpid()}) == 4
    assert not any(one.failure for one in found)


def test_one_that_never_ends_is_ended_and_the_others_answer():
    def endless():
        while True:
            pass

    start = time.monotonic()
    found = {
        one.key: one for one in answers([Task("bad", endless, 1.0), Task("good", lambda: 7, 20.0)])
    }
    assert found["bad"].failure == LATE
    assert found["good"].value == 7
    assert time.monotonic() - start < 15


def test_what_a_child_started_does_not_keep_its_answer():
    def leaves():
        if os.fork() == 0:
            time.sleep(30)
        return 7

    start = time.monotonic()
    assert answer(leaves, 20.0).value == 7
    assert time.monotonic() - start < 10


def killed():
    os.kill(os.getpid(), signal.SIGKILL)


@pytest.mark.parametrize(
    ("end", "failure"),
    [
        (partial(os._exit, 3), "the process died"),
        (killed, "the process died"),
        (lambda: 1 / 0, "ZeroDivisionError: division by zero"),
    ],
)
def test_a_process_that_dies_is_named(end, failure):
    found = answer(end, 20.0)
    assert (found.value, found.failure) == (None, failure)


def test_children_are_gone_when_the_parent_stops():
    out, into = os.pipe()

    def stays():
        os.write(into, f"{os.getpid()}\n".encode())
        time.sleep(60)

    tasks = [Task(0, lambda: 7, 20.0), Task(1, stays, 90.0)]
    running = answers(tasks, 2)
    assert next(running).key == 0
    with os.fdopen(out) as pipe:
        child = int(pipe.readline())  # it is at work: its process is known and has not ended
    os.close(into)
    os.kill(child, 0)
    running.close()
    with pytest.raises(ProcessLookupError):  # ended and waited for; others' children may be there
        os.kill(child, 0)

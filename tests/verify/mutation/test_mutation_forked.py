"""Child processes return results, exceed their time, die, and end when their parent stops."""

import os
import signal
import time

import pytest

from tests.verify.mutation.forked import answer, answers
from verify.audit.mutation.sandbox import LATE, Task


def endless():
    while True:
        pass


def test_answers_come_from_other_processes_and_one_that_never_ends_is_ended():
    start = time.monotonic()
    tasks = [Task(n, lambda n=n: [os.getpid(), n], 20.0) for n in range(3)]
    found = {one.key: one for one in answers([Task("bad", endless, 1.0), *tasks], 2)}
    assert found["bad"].failure == LATE
    assert [found[n].value[1] for n in range(3)] == [0, 1, 2]
    assert len({found[n].value[0] for n in range(3)} - {os.getpid()}) == 3
    assert time.monotonic() - start < 15


def test_a_process_that_dies_is_named():
    for end, failure in (
        (lambda: os.kill(os.getpid(), signal.SIGKILL), "the process died"),
        (lambda: 1 / 0, "ZeroDivisionError: division by zero"),
    ):
        found = answer(end, 20.0)
        assert (found.value, found.failure) == (None, failure)


def test_children_are_gone_when_the_parent_stops():
    out, into = os.pipe()

    def stays():
        os.write(into, f"{os.getpid()}\n".encode())
        time.sleep(60)

    running = answers([Task(0, lambda: 7, 20.0), Task(1, stays, 90.0)], 2)
    assert next(running).key == 0
    with os.fdopen(out) as pipe:
        child = int(pipe.readline())  # it is at work: its process is known and has not ended
    os.close(into)
    os.kill(child, 0)
    running.close()
    with pytest.raises(ProcessLookupError):  # ended and waited for; others' children may be there
        os.kill(child, 0)

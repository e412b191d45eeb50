"""Processes that die, raise or are stopped: the other tasks never notice."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from verify.jobs.executor import TICK, Drive, Lost, local

# Tasks are Python expressions: a spawned process knows `eval` by its name.
SEGFAULT = "__import__('ctypes').string_at(0)"
SUICIDE = "__import__('os').kill(__import__('os').getpid(), 9)"
EXIT = "__import__('os')._exit(3)"
PID = "__import__('os').getpid()"


def answers(tasks, processes=2):
    """Answers by number."""
    with local(processes) as engine:
        events = [e for e in Drive(engine, eval).answers(tasks) if e is not None]
    return {tasks.index(task): answer for task, answer in events}


def test_every_task_is_answered_once():
    found = answers([f"{n} ** 2" for n in range(7)])
    assert found == {n: n**2 for n in range(7)}


def test_one_process_serves_task_after_task():
    found = answers([f"{PID} + 0 * {n}" for n in range(5)], processes=1)
    assert len(set(found.values())) == 1
    assert os.getpid() not in found.values()


@pytest.mark.parametrize(
    ("deadly", "how"),
    [
        pytest.param(SUICIDE, "signal 9", id="kill -9, or no memory"),
        pytest.param(SEGFAULT, "signal 11", id="segmentation fault"),
        pytest.param(EXIT, "exit status 3", id="exit"),
        pytest.param("exec('raise SystemExit')", "exit status 0", id="an exit that says success"),
    ],
)
@pytest.mark.parametrize("processes", [1, 2])
def test_a_task_that_kills_its_process_is_lost_after_two_attempts(deadly, how, processes):
    found = answers(["1 + 1", deadly, "2 + 2", "3 + 3"], processes)
    assert found == {0: 2, 1: Lost(f"the process died ({how})"), 2: 4, 3: 6}


def test_a_task_that_is_killed_once_is_done_again_alone(tmp_path):
    """In a fresh process, after the others: memory may have been short."""
    once = f"""exec('''
import os, pathlib
mark = pathlib.Path({str(tmp_path / "mark")!r})
if not mark.exists():
    mark.touch()
    os.kill(os.getpid(), 9)
''') or {PID}"""
    found = answers([once, *(f"{PID} + 0 * {n}" for n in range(3))])
    assert list(found)[-1] == 0
    assert found[0] not in (found[1], found[2], found[3])


def test_an_exception_comes_back_in_one_line_with_its_traceback():
    found = answers(["1 / 0", "5"])
    assert found[0].reason == "ZeroDivisionError: division by zero"
    assert found[0].trace.startswith("Traceback")
    assert found[1] == 5


@pytest.mark.parametrize("error", ["OSError", "EOFError", "BrokenPipeError"])
def test_a_task_s_own_error_is_no_death_of_its_process(error, tmp_path):
    file = tmp_path / "attempts"
    write = f"open({str(file)!r}, 'a').write('.')"
    lost = answers([f"[{write}, (_ for _ in ()).throw({error}('no room'))]"], 1)[0]
    assert lost.reason == f"{error}: no room"
    assert "Traceback" in lost.trace
    assert file.read_text() == "."  # it is not done once more


def test_an_answer_that_cannot_be_sent_is_lost_and_no_other_with_it():
    found = answers(["lambda: 0", "6"])
    assert "pickle" in found[0].reason
    assert found[1] == 6


def test_the_caller_is_woken_while_nothing_happens_and_knows_what_runs():
    seen, woken = set(), 0
    with local(2) as engine:
        drive = Drive(engine, eval)
        for event in drive.answers([f"__import__('time').sleep({6 * TICK})"] * 2):
            woken += event is None
            seen.add(tuple(drive.running))
    assert woken >= 4
    assert (0, 1) in seen
    assert not drive.running


def children():
    done = subprocess.run(
        ["ps", "-o", "pid=", "--ppid", str(os.getpid())], capture_output=True, text=True
    )
    return {int(pid) for pid in done.stdout.split()}


def test_a_caller_that_gives_up_leaves_no_process():
    before = children()
    with local(2) as engine:
        next(Drive(engine, eval).answers(["__import__('time').sleep(60)"] * 4))
        assert len(children() - before) >= 2
        start = time.monotonic()
    assert time.monotonic() - start < 1
    assert len(children() - before) <= 2  # `ps` itself and the tracker that the library keeps


SLEEPING = """
import os, sys
from verify.jobs.executor import Drive, local
if __name__ == "__main__":
    with local(2) as engine:
        sleep = "print(__import__('os').getpid(), flush=True) or __import__('time').sleep(60)"
        for event in Drive(engine, eval).answers([sleep, sleep]):
            pass
"""


@pytest.fixture
def sleeping(tmp_path):
    """A program whose two workers sleep, and their process ids."""
    script = tmp_path / "sleeping.py"
    script.write_text(SLEEPING)
    with subprocess.Popen(
        [sys.executable, script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as program:
        yield program, [int(program.stdout.readline()) for _ in range(2)]


def gone(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except OSError:
        return True


def test_workers_end_when_their_parent_is_killed(sleeping):
    program, workers = sleeping
    program.kill()
    end = time.monotonic() + 2
    while not all(map(gone, workers)) and time.monotonic() < end:
        time.sleep(0.02)
    assert all(map(gone, workers))


def test_ctrl_c_to_all_processes_of_a_terminal_shows_one_traceback_at_most(sleeping):
    """The parent's own; here nothing catches it."""
    program, workers = sleeping
    for pid in (*workers, program.pid):
        os.kill(pid, signal.SIGINT)
    assert program.wait(2) in (130, -signal.SIGINT)
    assert program.stderr.read().count("Traceback") == 1
    assert all(map(gone, workers))


def test_in_this_process_tasks_follow_one_another():
    assert answers(["0 + 1", "1 + 1", "2 + 1"], processes=0) == {0: 1, 1: 2, 2: 3}
    assert answers([PID], processes=0) == {0: os.getpid()}

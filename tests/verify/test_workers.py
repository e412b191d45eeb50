"""Processes that die, raise or are stopped: the other tasks are not affected."""

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from verify.cases.registry import find
from verify.core.inputs import InputError
from verify.core.results import Status
from verify.core.store import Store
from verify.jobs.engine import Engine, GoneError
from verify.jobs.executor import TICK, Drive, Here, Lost, Where, local
from verify.jobs.level import Job
from verify.jobs.processes import WorkerDiedError
from verify.jobs.scheduler import run

ROOT = Path(__file__).parents[2]
# Tasks are Python expressions: a spawned process imports `eval` by its name.
KILLED = "__import__('os').kill(__import__('os').getpid(), 9)"
EXIT = "__import__('os')._exit(3)"
PID = "__import__('os').getpid()"


def answers(tasks, processes=2):
    """Answers by number."""
    with local(processes) as engine:
        events = [e for e in Drive(engine, eval).answers(tasks) if e is not None]
    return {tasks.index(task): answer for task, answer in events}


def test_a_task_that_kills_its_process_or_cannot_answer_is_lost_alone(tmp_path):
    file = tmp_path / "attempts"
    own = f"[open({str(file)!r}, 'a').write('.'), (_ for _ in ()).throw(EOFError('no room'))]"
    found = answers(["1 + 1", KILLED, EXIT, "1 / 0", "lambda: 0", own, "2 + 2"])
    assert (found[0], found[6]) == (2, 4)
    assert found[1] == Lost("the process died (signal 9)")
    assert found[2] == Lost("the process died (exit status 3)")
    assert found[3].reason == "ZeroDivisionError: division by zero"
    assert found[3].trace.startswith("Traceback")
    assert "pickle" in found[4].reason
    assert found[5].reason == "EOFError: no room"
    assert file.read_text() == "."  # an error of the task: it is not repeated
    assert answers(["0 + 1", "1 + 1", PID], processes=0) == {0: 1, 1: 2, 2: os.getpid()}


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


def test_the_caller_is_woken_while_nothing_happens_and_gets_what_runs():
    seen, woken = set(), 0
    with local(2) as engine:
        drive = Drive(engine, eval)
        for event in drive.answers([f"__import__('time').sleep({6 * TICK})"] * 2):
            woken += event is None
            seen.add(tuple(drive.running))
    assert woken >= 4
    assert (0, 1) in seen
    assert not drive.running


SLEEPING = """
from verify.jobs.executor import Drive, local
if __name__ == "__main__":
    with local(2) as engine:
        sleep = "print(__import__('os').getpid(), flush=True) or __import__('time').sleep(60)"
        for event in Drive(engine, eval).answers([sleep, sleep]):
            pass
"""


def gone(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except OSError:
        return True


def test_workers_end_when_their_parent_is_killed(tmp_path):
    script = tmp_path / "sleeping.py"
    script.write_text(SLEEPING)
    with subprocess.Popen([sys.executable, script], stdout=subprocess.PIPE, text=True) as program:
        workers = [int(program.stdout.readline()) for _ in range(2)]
        program.kill()
    end = time.monotonic() + 5
    while not all(map(gone, workers)) and time.monotonic() < end:
        time.sleep(0.02)
    assert all(map(gone, workers))


def test_a_script_that_starts_processes_without_a_guard_gets_one_error(tmp_path):
    """Without `if __name__ == "__main__":` each process would run the script again."""
    script = tmp_path / "mine.py"
    script.write_text(SLEEPING.replace('if __name__ == "__main__":', "if True:"))
    done = subprocess.run(
        [sys.executable, str(script)], capture_output=True, text=True, check=False,
        env=os.environ | {"PYTHONPATH": str(ROOT)}, timeout=300,
    )  # fmt: skip
    assert done.returncode == 1
    last = done.stderr.strip().splitlines()[-1]
    assert last.startswith("verify.jobs.engine.GoneError: ")
    assert 'put the calls of the script under `if __name__ == "__main__":`' in last


# Engines


def test_what_is_no_engine_is_refused():
    for asked, words in (
        ({"jobs": 257}, "--jobs must be 0 (one per core) to 256, got 257"),
        ({"engine": "ray"}, "--engine must be one of local, dask, got 'ray'"),
        ({"scheduler": "tcp://host:8786"}, "--scheduler requires --engine dask"),
        ({"engine": "dask", "scheduler": "tcp://::1"},
         "--scheduler must be an address such as tcp://host:8786, got 'tcp://::1'"),
    ):  # fmt: skip
        with pytest.raises(InputError) as error:
            Where(**asked)
        assert str(error.value) == words
    for scheduler in ("tls://10.0.0.1:1", "tcp://[::1]:8786"):
        assert Where(engine="dask", scheduler=scheduler).scheduler == scheduler


def test_a_process_has_one_blas_thread_unless_the_environment_sets_more(monkeypatch):
    monkeypatch.setenv("OMP_NUM_THREADS", "3")
    monkeypatch.delenv("OPENBLAS_NUM_THREADS", raising=False)
    with local(1) as engine:
        names = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS")
        asked = [engine.executor.submit(os.getenv, name).result() for name in names]
    assert asked == ["3", "1"]


class Deadly(Here):
    """Tasks that hold a 13 kill their process."""

    def submit(self, function, /, task):
        if 13 in task:
            return super().submit(died)
        return super().submit(function, task)


def died():
    raise WorkerDiedError("the process died (signal 9)")


def test_a_batch_that_kills_its_process_is_split_and_its_culprit_alone_is_lost():
    drive = Drive(Engine(Deadly(), lambda: 1), sum, split=lambda batch: [(one,) for one in batch])
    found = dict(e for e in drive.answers([(1, 2), (12, 13, 14), (5,)]) if e is not None)
    assert found == {
        (1, 2): 3, (5,): 5, (12,): 12, (13,): Lost("the process died (signal 9)"), (14,): 14,
    }  # fmt: skip
    engine = Engine(Deadly(), lambda: 1, gone=lambda: "it is gone")
    with pytest.raises(GoneError, match="it is gone"):
        list(Drive(engine, sum).answers([(13,)]))


@pytest.mark.soak  # a cluster of processes starts
def test_one_or_two_processes_and_a_dask_cluster_judge_equally(tmp_path):
    case = find("polyhedral-pressure")  # its levels take tenths of a second
    rows = []
    for where in (Where(jobs=1), Where(jobs=2, engine="dask")):
        folder = tmp_path / where.engine
        (result,) = run([Job(case, case.inputs())], engine=where.entered(), cache_folder=folder)
        rows.append(result.rows)
        assert len(Store(folder).all("level", case.id)) == len(case.levels)
    assert rows[0] == rows[1]
    assert {row.status for row in rows[0]} == {Status.PASS}

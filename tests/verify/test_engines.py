"""Engines by their names, and a run on a dask cluster beside one on processes."""

import json
import os
import subprocess
import sys

import pytest

from verify.cases.registry import find
from verify.core.inputs import InputError
from verify.core.results import Status
from verify.core.store import Store
from verify.jobs.engine import Engine, GoneError
from verify.jobs.executor import Drive, Here, Lost, Where, local
from verify.jobs.level import Job
from verify.jobs.processes import WorkerDiedError
from verify.jobs.scheduler import run


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ({"jobs": -1}, "--jobs is 0 (one a core) to 256, got -1"),
        ({"jobs": 257}, "--jobs is 0 (one a core) to 256, got 257"),
        ({"engine": "ray"}, "--engine is one of local, dask, got 'ray'"),
        ({"scheduler": "tcp://host:8786"}, "--scheduler belongs to --engine dask"),
        ({"engine": "dask", "scheduler": "host:8786"},
         "--scheduler is an address such as tcp://host:8786, got 'host:8786'"),
        ({"engine": "dask", "scheduler": "tcp://::1"},
         "--scheduler is an address such as tcp://host:8786, got 'tcp://::1'"),
    ],
)  # fmt: skip
def test_what_is_no_engine_is_told(asked, said):
    with pytest.raises(InputError) as error:
        Where(**asked)
    assert str(error.value) == said


def test_an_address_of_a_cluster_may_be_of_either_kind():
    for scheduler in ("tcp://host:8786", "tls://10.0.0.1:1", "tcp://[::1]:8786"):
        assert Where(engine="dask", scheduler=scheduler).scheduler == scheduler


def test_a_process_has_one_blas_thread_unless_it_is_told(monkeypatch):
    monkeypatch.setenv("OMP_NUM_THREADS", "3")
    monkeypatch.delenv("OPENBLAS_NUM_THREADS", raising=False)
    with local(1) as engine:
        asked = [
            engine.executor.submit(os.getenv, f"{name}_NUM_THREADS").result()
            for name in ("OMP", "OPENBLAS")
        ]
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
    engine = Engine(Deadly(), lambda: 1)
    drive = Drive(engine, sum, split=lambda batch: [(one,) for one in batch])
    found = dict(e for e in drive.answers([(1, 2), (12, 13, 14), (5,)]) if e is not None)
    assert found == {
        (1, 2): 3, (5,): 5, (12,): 12, (13,): Lost("the process died (signal 9)"), (14,): 14,
    }  # fmt: skip


def test_no_more_tasks_are_taken_than_are_solved_and_wait():
    taken = []

    def tasks():
        for n in range(8):
            taken.append(n)
            yield (n,)

    drive = Drive(Engine(Here(), lambda: 2, ahead=1), sum)
    events = drive.answers(tasks())
    next(event for event in events if event is not None)
    assert len(taken) == 4


def test_an_engine_that_is_gone_while_a_task_dies_ends_the_run():
    engine = Engine(Deadly(), lambda: 1, gone=lambda: "it is gone")
    with pytest.raises(GoneError, match="it is gone"):
        list(Drive(engine, sum).answers([(13,)]))


@pytest.mark.slow("a cluster of processes starts")
def test_a_dask_cluster_judges_as_processes_do(tmp_path):
    case = find("polyhedral-pressure")  # its levels take tenths of a second
    rows = []
    for engine in ("local", "dask"):
        folder, where = tmp_path / engine, Where(jobs=2, engine=engine)
        (result,) = run([Job(case, case.inputs())], engine=where.entered(), cache_folder=folder)
        rows.append(result.rows)
        assert len(Store(folder).all("level", case.id)) == len(case.levels)
    assert rows[0] == rows[1]
    assert {row.status for row in rows[0]} == {Status.PASS}


@pytest.mark.soak  # two commands that write whole reports
def test_the_command_on_a_dask_cluster_judges_as_on_processes(tmp_path):
    rows = []
    for engine in ("local", "dask"):
        done = subprocess.run(
            [sys.executable, "-m", "verify", "verify", "ring-lame", "--engine", engine, "--jobs",
             "2", "--out", str(tmp_path / engine)],
            env=os.environ | {"FREEWHEEL_CACHE": str(tmp_path / f"cache-{engine}")},
            capture_output=True, text=True,
        )  # fmt: skip
        assert (done.returncode, "Traceback" in done.stderr) == (0, False)
        rows.append(json.loads((tmp_path / engine / "results.json").read_text())["rows"])
        assert len(Store(tmp_path / f"cache-{engine}").all("level", "ring-lame")) == 4
    assert rows[0] == rows[1]

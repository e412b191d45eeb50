"""Sweeps whose worker, client or scheduler is killed: the table is that of an undisturbed run."""

import os
import signal
import socket
import sqlite3
import subprocess
import sys
import time
from contextlib import closing, contextmanager, suppress
from pathlib import Path

import pytest

from tests.verify.sweep_made import RING
from verify.app.cli import run

POINTS = 24
VARY = ("--vary", "z=3:8:6", "--vary", "delta_1=3mm:5mm:2", "--vary", "rho=1mm:2mm:2")
ONLY = ("--only", "K in the middle of the flats")
SECONDS = 600.0


def command(folder):
    return ["sweep", str(folder / "ring.toml"), *VARY, *ONLY, "--out", str(folder / "out")]


def client(folder, *options):
    """A sweep as a process of its own, with its cache and its tables in `folder`."""
    (folder / "ring.toml").write_text(RING)
    return subprocess.Popen(
        [sys.executable, "-m", "verify", *command(folder), *options],
        env=os.environ | {"FREEWHEEL_CACHE": str(folder / "cache")},
        text=True,
        start_new_session=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )


def ended(process):
    """Exit status and standard error of a process that ends by itself."""
    _, said = process.communicate(timeout=SECONDS)
    return process.returncode, said


def table(folder):
    return (folder / "out" / "points.csv").read_bytes()


def points(folder):
    """Points that the cache in `folder` holds, 0 where there is none."""
    path = folder / "cache" / "store.sqlite"
    if not path.exists():
        return 0
    with closing(sqlite3.connect(path, timeout=10)) as database:
        try:
            return database.execute(
                "SELECT COUNT(*) FROM entries WHERE kind = 'sweep reference'"
            ).fetchone()[0]
        except sqlite3.OperationalError:  # no table yet
            return 0


def until(condition):
    end = time.monotonic() + SECONDS
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.05)


def below(pid):
    """Processes below one, the worker processes last."""
    done = subprocess.run(["ps", "-eo", "pid=,ppid=,args="], capture_output=True, text=True)
    rows = [line.split(None, 2) for line in done.stdout.splitlines()]
    found = [pid]
    for parent in found:
        found += [int(p) for p, parent_of, _ in rows if int(parent_of) == parent]
    args = {int(p): a for p, _, a in rows}
    return [p for p in found[1:] if "resource_tracker" not in args.get(p, "resource_tracker")]


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("undisturbed")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FREEWHEEL_CACHE", str(folder / "cache"))
        (folder / "ring.toml").write_text(RING)
        assert run([*command(folder), "--jobs", "1"]) == 0
    assert points(folder) == POINTS
    return table(folder)


@pytest.mark.slow("runs are killed and go on")
def test_a_killed_worker_and_a_killed_client_leave_the_table_of_an_undisturbed_run(
    undisturbed, tmp_path
):
    process = client(tmp_path, "--jobs", "2")
    until(lambda: points(tmp_path) >= 2)
    os.kill(below(process.pid)[-1], signal.SIGKILL)  # a worker, with what it is at
    done = points(tmp_path)
    until(lambda: points(tmp_path) >= done + 2)
    left = below(process.pid)
    process.kill()
    process.communicate()
    kept = points(tmp_path)
    assert 4 <= kept < POINTS
    until(lambda: not any(map(alive, left)))  # workers end with their client
    assert not (tmp_path / "out" / "points.csv").exists()
    assert ended(client(tmp_path, "--jobs", "1"))[0] == 0
    assert points(tmp_path) == POINTS
    assert table(tmp_path) == undisturbed


@pytest.mark.soak
@pytest.mark.parametrize("engine", ["local"])
def test_ctrl_c_says_what_is_stored_and_the_same_command_goes_on(undisturbed, tmp_path, engine):
    process = client(tmp_path, "--jobs", "2", "--engine", engine)
    until(lambda: points(tmp_path) >= 2)
    os.killpg(process.pid, signal.SIGINT)  # as a terminal sends it: to workers, too
    status, said = ended(process)
    assert status == 130
    assert "Traceback" not in said
    kept = points(tmp_path)
    assert said.splitlines()[-1] == (
        f"freewheel: interrupted; {kept} of {POINTS} points are stored: the same command "
        "continues with the others"
    )
    assert ended(client(tmp_path, "--jobs", "2"))[0] == 0
    assert table(tmp_path) == undisturbed


def alive(pid):
    with suppress(OSError):
        os.kill(pid, 0)
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    return False


@contextmanager
def listening():
    """A dask scheduler with two workers, as an engineer starts them: its process and address."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    address = f"tcp://127.0.0.1:{port}"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    module = [sys.executable, "-m", "distributed.cli.dask_"]
    scheduler = subprocess.Popen(
        [*module[:-1], f"{module[-1]}scheduler", "--host", "127.0.0.1", "--port", str(port),
         "--no-dashboard"], **quiet,
    )  # fmt: skip
    workers = subprocess.Popen(
        [*module[:-1], f"{module[-1]}worker", address, "--nthreads", "1", "--nworkers", "2",
         "--no-dashboard"],
        env=os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}, **quiet,
    )  # fmt: skip
    try:
        yield scheduler, workers, address
    finally:
        for pid in below(workers.pid):
            with suppress(OSError):
                os.kill(pid, signal.SIGKILL)
        for process in (workers, scheduler):
            process.kill()
            process.wait()


@pytest.mark.soak  # two clusters; a killed worker and client are in the other test
def test_a_killed_scheduler_is_named_and_another_one_goes_on_with_the_same_numbers(
    undisturbed, tmp_path
):
    with listening() as (scheduler, workers, address):
        process = client(tmp_path, "--engine", "dask", "--scheduler", address)
        until(lambda: points(tmp_path) >= 2)
        os.kill(below(workers.pid)[-1], signal.SIGKILL)  # a worker: the scheduler has another
        done = points(tmp_path)
        until(lambda: points(tmp_path) >= done + 2)
        scheduler.kill()
        status, said = ended(process)
    kept = points(tmp_path)
    assert status == 2
    assert said.splitlines()[-1] == (
        f"freewheel: the scheduler at {address} is gone; {kept} of {POINTS} points are stored: "
        "the same command continues with the others"
    )
    assert "Traceback" not in said
    assert kept < POINTS
    with listening() as (_, _, address):
        assert ended(client(tmp_path, "--engine", "dask", "--scheduler", address))[0] == 0
    assert points(tmp_path) == POINTS
    assert table(tmp_path) == undisturbed

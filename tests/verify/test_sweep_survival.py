"""Sweeps on a cluster whose workers or scheduler are killed have the same results."""

import os
import socket
import subprocess
import sys
import time
from contextlib import contextmanager

import pytest

from tests.verify.sweep_made import RING
from verify.core.store import Store

pytestmark = pytest.mark.soak  # a killed client is in test_kills, killed tasks in test_workers
POINTS = 24
VARY = ("--vary", "z=3:8:6", "--vary", "delta_1=3mm:5mm:2", "--vary", "rho=1mm:2mm:2")
ONLY = ("--only", "K in the middle of the flats")
SECONDS = 600.0
CONTINUES = "{} of 24 points are stored: the same command continues with the others"


def client(folder, *options):
    """A sweep as a separate process, with its cache and its tables in `folder`."""
    part, out = folder / "ring.toml", folder / "out"
    part.write_text(RING)
    return subprocess.Popen(
        [sys.executable, "-m", "verify", "sweep", part, *VARY, *ONLY, "--out", out, *options],
        env=os.environ | {"FREEWHEEL_CACHE": str(folder / "cache")}, text=True,
        start_new_session=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )  # fmt: skip


def ended(process):
    """Exit status and standard error of a process that ends by itself."""
    _, message = process.communicate(timeout=SECONDS)
    assert "Traceback" not in message
    return process.returncode, message


def points(folder):
    """Points that the cache in `folder` holds."""
    groups = Store(folder / "cache").groups()
    return sum(group.entries for group in groups if group.kind == "sweep reference")


def wait_for_points(folder, count):
    end = time.monotonic() + SECONDS
    while points(folder) < count:
        assert time.monotonic() < end
        time.sleep(0.05)


@contextmanager
def listening():
    """A dask scheduler with two workers, as an engineer starts them: processes and address."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    address = f"tcp://127.0.0.1:{port}"

    def start(what, *options):
        return subprocess.Popen(
            [sys.executable, "-m", f"distributed.cli.dask_{what}", *options, "--no-dashboard"],
            env=os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"},
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip

    scheduler = start("scheduler", "--host", "127.0.0.1", "--port", str(port))
    workers = [start("worker", address, "--nthreads", "1", "--no-nanny") for _ in range(2)]
    try:
        yield scheduler, workers, address
    finally:
        for process in (*workers, scheduler):
            process.kill()
            process.wait()


def test_a_killed_scheduler_is_named_and_another_one_continues_with_the_same_numbers(tmp_path):
    with listening() as (scheduler, workers, address):
        process = client(tmp_path, "--engine", "dask", "--scheduler", address)
        wait_for_points(tmp_path, 2)
        workers[0].kill()  # the scheduler has another
        wait_for_points(tmp_path, points(tmp_path) + 2)
        scheduler.kill()
        status, message = ended(process)
    stored = points(tmp_path)
    assert status == 2
    gone = f"freewheel: the scheduler at {address} is gone; {CONTINUES.format(stored)}"
    assert message.splitlines()[-1] == gone
    assert stored < POINTS
    with listening() as (_, _, address):
        assert ended(client(tmp_path, "--engine", "dask", "--scheduler", address))[0] == 0
    undisturbed = tmp_path / "undisturbed"
    undisturbed.mkdir()
    assert ended(client(undisturbed, "--jobs", "1"))[0] == 0
    assert points(undisturbed) == POINTS
    tables = [(folder / "out" / "points.csv").read_bytes() for folder in (tmp_path, undisturbed)]
    assert tables[0] == tables[1]

"""Runs that are stopped, that run at once, or that find torn files: nothing is left behind."""

import json
import os
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from contextlib import closing
from pathlib import Path

import pytest

from verify.app.cli import run
from verify.core.store import FILE, Store


class Place:
    """A cache and an output folder of their own, and runs of ring-lame on them."""

    def __init__(self, base: Path):
        self.out, self.cache = base / "out", base / "cache" / "fem"

    def start(self, jobs):
        command = [sys.executable, "-m", "verify", "verify", "ring-lame", "--out", str(self.out),
                   "--jobs", jobs]  # fmt: skip
        return subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            env=os.environ | {"FREEWHEEL_CACHE": str(self.cache)}, start_new_session=True,
        )  # fmt: skip

    def stored(self):
        """Stored levels with the time of their writing."""
        with closing(sqlite3.connect(self.cache / FILE)) as database:
            question = "SELECT key, made FROM entries WHERE kind = 'level'"
            return dict(database.execute(question).fetchall())

    def left_over(self):
        return list(self.out.rglob(".part-*"))

    def results(self):
        """results.json without what differs between any two runs."""
        record = json.loads((self.out / "results.json").read_text("utf-8"))
        for name in ("made", "commit", "seconds", "cached"):
            del record["provenance"][name]
        return record


@pytest.fixture
def place(tmp_path):
    return Place(tmp_path)


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    place = Place(tmp_path_factory.mktemp("undisturbed"))
    _, err = place.start("2").communicate(timeout=600)
    assert place.results(), err
    return place


def members(session):
    """Living processes of a session, with their command lines."""
    found = {}
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            state, _, _, sid = (entry / "stat").read_text().rpartition(")")[2].split()[:4]
            if int(sid) == session and state != "Z":
                found[int(entry.name)] = (entry / "cmdline").read_bytes()
        except OSError:
            continue
    return found


def wait_until(condition):
    end = time.monotonic() + 20
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


@pytest.mark.parametrize(
    ("stop", "jobs"),
    [(signal.SIGINT, 2), pytest.param(signal.SIGTERM, 1, marks=pytest.mark.soak)],
    ids=["ctrl-c", "sigterm"],
)
def test_a_stopped_run_ends_at_once_with_one_line(stop, jobs, place):
    process = place.start(str(jobs))
    wait_until(lambda: sum(b"spawn_main" in c for c in members(process.pid).values()) == jobs)
    time.sleep(0.1 * jobs)
    start = time.monotonic()
    if stop is signal.SIGINT:
        os.killpg(process.pid, stop)  # as a terminal does
    else:
        process.send_signal(stop)
    _, err = process.communicate(timeout=20)
    assert time.monotonic() - start < 2  # the level under way takes longer
    assert process.returncode == 130
    assert re.fullmatch(r"(refinement levels .*\n)*freewheel: interrupted; .*\n", err)
    wait_until(lambda: not members(process.pid))
    assert place.left_over() == []


@pytest.mark.soak  # two whole runs
def test_two_runs_at_once_with_one_cache_and_one_folder_agree(place, undisturbed):
    both = [place.start("1") for _ in range(2)]
    for process in both:
        _, err = process.communicate(timeout=600)
        assert process.returncode == 0, err
    assert place.left_over() == []
    assert place.results() == undisturbed.results()


def test_torn_entries_are_solved_again_and_the_files_of_a_killed_run_go(
    undisturbed, tmp_path, monkeypatch
):
    right = undisturbed
    entries = Store(right.cache).all("level", "ring-lame")
    _, torn, empty = sorted(entries, key=lambda key: -len(entries[key]))[-3:]
    place = Place(tmp_path)
    monkeypatch.setenv("FREEWHEEL_CACHE", str(place.cache))
    shutil.copytree(right.cache, place.cache)
    Store(place.cache).store("level", "ring-lame", {torn: entries[torn][:-10], empty: b""})
    (place.out / ".part-killed").mkdir(parents=True)
    (place.out / ".part-killed" / "rows.csv").write_bytes(b"half")
    before = place.stored()
    assert run(["verify", "ring-lame", "--jobs", "1", "--out", str(place.out)]) == 0
    now = place.stored()
    assert {key for key in now if before[key] != now[key]} == {torn, empty}
    assert place.left_over() == []
    assert place.results() == right.results()

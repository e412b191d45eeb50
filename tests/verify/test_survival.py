"""Whole runs that are killed or stopped: no torn file, no orphan, nothing solved twice."""

import csv
import io
import json
import os
import random
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
import xml.etree.ElementTree as ET
import zipfile
from contextlib import closing
from pathlib import Path

import pytest

from verify.app.cli import run
from verify.core.store import FILE, Store, unpacked

KILLS = 2  # test_kills has more of them
RING_LEVELS = 4
REPORT = re.compile(
    r"\.up-to-date\.json|report\.(html|pdf)"
    r"|results(\.schema)?\.json|(rows|budget|crosscheck)\.csv|tables\.xlsx|verdicts\.md|junit\.xml"
    r"|ring-lame-.*\.vtu"
)


class Place:
    """A cache and an output folder of their own, and runs of ring-lame on them."""

    def __init__(self, base: Path):
        self.out, self.cache = base / "out", base / "cache" / "fem"

    def start(self, jobs):
        command = [sys.executable, "-m", "verify", "verify", "ring-lame", "--out", str(self.out),
                   "--jobs", jobs]  # fmt: skip
        return subprocess.Popen(
            command,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=os.environ | {"FREEWHEEL_CACHE": str(self.cache)},
            start_new_session=True,
        )

    def run(self, jobs):
        """A run that nothing disturbs: the levels that it wrote, and what it says."""
        process = self.start(jobs)
        _, err = process.communicate(timeout=600)
        assert process.returncode == 0, err
        self.assert_whole()
        assert self.left_over() == []

    def stored(self):
        """Stored levels with the time of their writing."""
        if not (file := self.cache / FILE).is_file():
            return {}
        with closing(sqlite3.connect(file)) as database:
            question = "SELECT key, made FROM entries WHERE kind = 'level'"
            return dict(database.execute(question).fetchall())

    def left_over(self):
        return list(self.out.rglob(".part-*"))

    def contents(self):
        """Kind and content of every entry, of a store that SQLite finds in order."""
        if not (file := self.cache / FILE).is_file():
            return []
        with closing(sqlite3.connect(file)) as database:
            assert database.execute("PRAGMA integrity_check").fetchall() == [("ok",)]
            return database.execute("SELECT kind, content FROM entries").fetchall()

    def results(self):
        """results.json without what differs between any two runs."""
        record = json.loads((self.out / "results.json").read_text("utf-8"))
        for name in ("made", "commit", "seconds", "cached"):
            del record["provenance"][name]
        return record

    def assert_whole(self):
        """Every file that a run leaves can be read to its end, and there are no others."""
        for kind, content in self.contents():
            if kind in ("level", "picture"):
                assert unpacked(content)
        for path in self.out.glob("*"):
            if path.name.startswith(".part-") or path.name == ".lock":
                continue
            assert REPORT.fullmatch(path.name)
            if path.suffix == ".pdf":
                assert path.read_bytes().rstrip().endswith(b"%%EOF")
                continue
            if path.suffix == ".xlsx":
                assert zipfile.ZipFile(path).testzip() is None
                continue
            text = path.read_text("utf-8")
            if path.suffix == ".json":
                assert json.loads(text)
            elif path.suffix in (".xml", ".vtu"):
                assert len(ET.fromstring(text))
            elif path.suffix == ".csv":
                assert len({len(line) for line in csv.reader(io.StringIO(text))}) == 1
            elif path.suffix == ".html":
                assert text.rstrip().endswith("</html>")
            else:
                assert text.endswith("\n")


@pytest.fixture
def place(tmp_path):
    return Place(tmp_path)


def members(session):
    """Living processes of a session."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                state, _, _, sid = (entry / "stat").read_text().rpartition(")")[2].split()[:4]
            except OSError:
                continue
            if int(sid) == session and state != "Z":
                found.append(int(entry.name))
    return found


def all_gone(session, seconds=20.0):
    """Whether the processes of a session end: on a loaded machine a killed one takes its time."""
    end = time.monotonic() + seconds
    while members(session) and time.monotonic() < end:
        time.sleep(0.02)
    return not members(session)


def workers_of(process, count):
    """The processes under `process` that solve, once there are `count`."""
    end = time.monotonic() + 20
    while time.monotonic() < end:
        found = [p for p in members(process.pid) if p != process.pid and is_worker(p)]
        if len(found) == count:
            return found
        time.sleep(0.01)
    raise AssertionError(f"no {count} workers")


def is_worker(pid):
    try:
        return b"spawn_main" in Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return False


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    """A run that nobody disturbed, and how long it took [s]."""
    place = Place(tmp_path_factory.mktemp("undisturbed"))
    start = time.monotonic()
    place.run("2")
    return place, time.monotonic() - start


@pytest.mark.slow("runs are killed and go on")
def test_kills_lose_and_tear_nothing(place, undisturbed):
    """Seeded moments, from the first levels in an empty cache to the last file of the report."""
    right, seconds = undisturbed
    moments = random.Random(20)
    stored = {}
    for _ in range(KILLS):
        process = place.start("2")
        try:
            process.wait(moments.uniform(0.1, 1.05 * seconds))
        except subprocess.TimeoutExpired:
            process.kill()
        process.communicate()
        assert all_gone(process.pid)
        place.assert_whole()
        now = place.stored()
        assert stored.items() <= now.items()  # what was stored is never written again
        stored = now
    place.run("2")
    assert stored.items() <= place.stored().items()
    assert len(place.stored()) == RING_LEVELS
    assert place.results() == right.results()


@pytest.mark.parametrize(
    ("stop", "jobs"),
    [(signal.SIGINT, "2"), pytest.param(signal.SIGTERM, "1", marks=pytest.mark.soak)],
    ids=["ctrl-c", "sigterm"],
)
def test_a_stopped_run_ends_at_once_with_one_line(stop, jobs, place):
    process = place.start(jobs)
    workers_of(process, int(jobs))
    time.sleep(0.1 * int(jobs))
    start = time.monotonic()
    if stop is signal.SIGINT:
        os.killpg(process.pid, stop)  # as a terminal does
    else:
        process.send_signal(stop)
    _, err = process.communicate(timeout=20)
    assert time.monotonic() - start < 2  # the level under way takes longer
    assert process.returncode == 130
    assert re.fullmatch(r"(refinement levels .*\n)*freewheel: interrupted; .*\n", err)
    assert all_gone(process.pid)
    assert place.left_over() == []


@pytest.mark.soak  # two whole runs
def test_two_runs_at_once_with_one_cache_and_one_folder_agree(place, undisturbed):
    both = [place.start("1") for _ in range(2)]
    for process in both:
        _, err = process.communicate(timeout=600)
        assert process.returncode == 0, err
    place.assert_whole()
    assert place.left_over() == []
    assert place.results() == undisturbed[0].results()


def test_torn_entries_are_solved_again_and_the_files_of_a_killed_run_go(
    undisturbed, tmp_path, monkeypatch
):
    right = undisturbed[0]
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

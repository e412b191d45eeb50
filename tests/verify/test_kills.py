"""Studies that are killed or stopped, torn files: no stored result is lost, results are equal.

The studies run in a copy of the project, since some of them write its measured files.
"""

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
from contextlib import closing, suppress
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.verify.sweep_made import RING
from tests.verify.test_design_sprag_command import NARROW, task
from verify.core.store import FILE

KILLS = int(os.environ.get("FREEWHEEL_KILLS", "6"))  # of each study
ROOT = Path(__file__).parents[2]
PARTS = ("analytic", "fem", "meshes", "verify", "reports", "tests", "pyproject.toml")
SWEEP = ("--vary", "z=3:8:6", "--vary", "delta_1=3mm:5mm:2", "--only", "K in the middle of the fl")
MEASURED = "verify/measured"
GROWING = ("duration", "sources")  # kinds of entries that each run may write again
# differ between any two runs
UNLIKE = {"date", "seconds", "made", "commit", "cached", "spent", "checksum"}


@dataclass(frozen=True)
class Study:
    """A command, and the file with its result below the copy of the project."""

    arguments: tuple[str, ...]
    result: str


STUDIES = {
    "levels": Study(("verify", "ring-lame", "--jobs", "2", "--out", "out"), "out/results.json"),
    "sweep": Study(("sweep", "ring.toml", *SWEEP, "--jobs", "2", "--out", "out"), "out/points.csv"),
    "budget": Study(("deep", "budget:ring-lame"), f"{MEASURED}/budget/ring-lame.json"),
    "crowns": Study(("design", "--no-fem", "task.toml", "--out", "out"), "out/designs.csv"),
}


class Copy:
    """The project, its store and its files in a separate folder."""

    def __init__(self, folder: Path, study: Study) -> None:
        self.folder, self.study = folder, study
        for part in PARTS:
            place = ROOT / part
            if place.is_dir():
                ignored = shutil.ignore_patterns("__pycache__", "out")
                shutil.copytree(place, folder / part, ignore=ignored)
            else:
                shutil.copy(place, folder / part)
        (folder / "ring.toml").write_text(RING)
        task(folder, **NARROW)
        self.store = folder / "cache" / FILE
        if study.result.startswith(MEASURED):  # of other code: it is measured again
            path = folder / study.result
            path.write_text(path.read_text("utf-8").replace("made by", "made otherwise"), "utf-8")

    def start(self) -> subprocess.Popen:
        environment = os.environ | {
            "FREEWHEEL_CACHE": str(self.store.parent), "PYTHONPATH": str(self.folder),
        }  # fmt: skip
        return subprocess.Popen(
            [sys.executable, "-m", "verify", *self.study.arguments], cwd=self.folder,
            env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
            start_new_session=True,
        )  # fmt: skip

    def run(self) -> float:
        """Seconds of a run that nothing disturbs."""
        start, process = time.monotonic(), self.start()
        _, err = process.communicate(timeout=1800)
        assert process.returncode in (0, 1), err
        assert "Traceback" not in err
        assert not list(self.folder.glob("out/**/.part-*"))
        return time.monotonic() - start

    def entries(self) -> dict[tuple[str, str], float]:
        """Kind and key of every entry and when it was made, of a store that SQLite finds whole."""
        if not self.store.is_file():
            return {}
        with closing(sqlite3.connect(self.store)) as database:
            assert database.execute("PRAGMA integrity_check").fetchall() == [("ok",)]
            if not database.execute("SELECT 1 FROM sqlite_master").fetchone():
                return {}
            lines = database.execute("SELECT kind, key, made FROM entries").fetchall()
        return {(kind, key): made for kind, key, made in lines if kind not in GROWING}

    def result(self) -> object:
        text = (self.folder / self.study.result).read_text("utf-8")
        return plain(json.loads(text)) if self.study.result.endswith(".json") else text


def plain(record: object) -> object:
    """A record without what differs between any two runs."""
    if isinstance(record, dict):
        return {k: plain(v) for k, v in record.items() if k not in UNLIKE}
    return [plain(one) for one in record] if isinstance(record, list) else record


@pytest.mark.soak  # six kills of each study
@pytest.mark.parametrize("name", STUDIES)
def test_kills_lose_nothing(name, tmp_path):
    study = STUDIES[name]
    right = Copy(tmp_path / "right", study)
    seconds = right.run()
    copy, moments = Copy(tmp_path / "killed", study), random.Random(20)
    stored = copy.entries()
    for _ in range(KILLS):
        process = copy.start()
        with suppress(subprocess.TimeoutExpired):
            process.wait(moments.uniform(0.1, 1.05 * seconds))
        process.kill()  # its child processes end by themselves
        process.communicate()
        now = copy.entries()
        assert stored.items() <= now.items()  # nothing is lost, nothing is made twice
        stored = now
    if name == "levels":  # temporary files of a killed run are removed
        (copy.folder / "out" / ".part-killed").mkdir(parents=True, exist_ok=True)
        (copy.folder / "out" / "rows.csv").unlink(missing_ok=True)  # or it is up to date
    copy.run()
    assert stored.items() <= copy.entries().items()
    assert copy.result() == right.result()


def members(session: int) -> dict[int, bytes]:
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


def wait_until(condition) -> None:
    end = time.monotonic() + 20
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


STORED = r"\d+ of 12 points are stored: the same command continues with the others"


@pytest.mark.parametrize(
    ("stop", "name", "words"),
    [
        (signal.SIGINT, "levels", ".*"),
        pytest.param(signal.SIGTERM, "levels", ".*", marks=pytest.mark.soak),
        pytest.param(signal.SIGINT, "sweep", STORED, marks=pytest.mark.soak),
    ],
)
def test_a_stopped_run_ends_at_once_with_one_line(stop, name, words, tmp_path):
    process = Copy(tmp_path, STUDIES[name]).start()
    wait_until(lambda: sum(b"spawn_main" in c for c in members(process.pid).values()) == 2)
    time.sleep(0.2)
    start = time.monotonic()
    if stop is signal.SIGINT:
        os.killpg(process.pid, stop)  # as a terminal does
    else:
        process.send_signal(stop)
    _, err = process.communicate(timeout=20)
    assert time.monotonic() - start < 2  # the running level takes longer
    assert process.returncode == 130
    assert "Traceback" not in err
    assert re.fullmatch(f"freewheel: interrupted; {words}", err.splitlines()[-1])
    wait_until(lambda: not members(process.pid))
    assert not list(tmp_path.glob("out/**/.part-*"))


@pytest.mark.soak  # two whole runs
def test_two_runs_at_once_with_one_cache_and_one_folder_agree(tmp_path):
    copy = Copy(tmp_path, STUDIES["levels"])
    both, results = [copy.start() for _ in range(2)], []
    for process in both:
        _, err = process.communicate(timeout=600)
        assert process.returncode == 0, err
        results.append(copy.result())
    assert not list(tmp_path.glob("out/**/.part-*"))
    assert results[0] == results[1]

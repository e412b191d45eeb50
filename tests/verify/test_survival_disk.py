"""Disks that are full or cannot be written: one line, and everything else as it was."""

import resource
import subprocess
import sys

import pytest

from verify.app.cli import run
from verify.core.store import FILE

SPRING = """\
case = "spring-accordion"
[inputs]
n = 10
b = "0.1 mm"
h = "56 mm"
r = "0.45 mm"
L1 = "11.6 mm"
alpha = "80 deg"
E = "206 GPa"
nu = 0.3
"""
UNDECIDED = 3  # `check` of a spring without a working force


@pytest.fixture
def tiny(tmp_path):
    """A file system of 256 kB in memory."""
    folder = tmp_path / "tiny"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=256k", "none", str(folder)]
    done = subprocess.run(mount, capture_output=True, text=True, check=False)
    if done.returncode:
        pytest.skip(f"no file system can be mounted here: {done.stderr.strip()}")
    yield folder
    subprocess.run(["umount", str(folder)], check=True)


@pytest.fixture
def check(tmp_path, monkeypatch, capsys):
    """`check` of a spring with a cache: the status, the lines of progress and the others."""

    def checked(*options, cache):
        monkeypatch.setenv("FREEWHEEL_CACHE", str(cache))
        path = tmp_path / "spring.toml"
        path.write_text(SPRING)
        status = run(["check", str(path), *map(str, options)])
        lines = capsys.readouterr().err.splitlines()
        progress = [line for line in lines if line.startswith("refinement levels")]
        return status, progress, [line for line in lines if line not in progress]

    return checked


@pytest.mark.slow("a run with finite elements")
def test_a_full_cache_is_one_line_and_the_run_goes_on(tiny, check):
    (tiny / "ballast").write_bytes(bytes(200_000))
    status, _, lines = check("--fem", cache=tiny / "fem")
    assert status == UNDECIDED
    (line,) = [line for line in lines if "cannot be stored" in line]
    assert line.startswith(f"freewheel: {tiny / 'fem' / FILE}: ")
    assert line.endswith("make room on its disk, or remove it to begin again: going on without")


def test_a_report_that_finds_no_space_is_one_line_and_the_old_one_stays(tiny, tmp_path, check):
    old = {name: f"old {name}".encode() for name in ("report.html", "results.json", "rows.csv")}
    for name, content in old.items():
        (tiny / name).write_bytes(content)
    status, _, (line,) = check("--out", tiny, cache=tmp_path / "fem")
    assert status == 2
    assert line.startswith(f"freewheel: {tiny}/")
    assert line.endswith("cannot be written: No space left on device")
    assert {p.name: p.read_bytes() for p in tiny.iterdir() if p.name != ".lock"} == old


def test_a_read_only_output_folder_is_found_before_the_work(tiny, tmp_path, check):
    subprocess.run(["mount", "-o", "remount,ro", str(tiny)], check=True)
    status, _, (line,) = check("--fem", "--out", tiny / "out", cache=tmp_path / "fem")
    assert status == 2
    assert "Read-only file system" in line
    assert not (tmp_path / "fem").exists()


@pytest.mark.soak
def test_a_read_only_cache_is_one_line_and_what_it_has_is_not_solved_again(tiny, check):
    subprocess.run(["mount", "-o", "remount,size=64m", str(tiny)], check=True)
    assert check("--fem", cache=tiny)[0] == UNDECIDED
    subprocess.run(["mount", "-o", "remount,ro", str(tiny)], check=True)
    status, _, lines = check("--fem", cache=tiny / "below")
    assert status == UNDECIDED
    (line,) = [line for line in lines if "going on without" in line]
    assert "Read-only file system" in line
    assert check("--fem", cache=tiny)[:2] == (UNDECIDED, [])


@pytest.mark.soak
@pytest.mark.parametrize("place", ["itself", "parent", "store"])
def test_a_file_where_the_cache_needs_a_folder_is_one_line(place, tmp_path, check):
    cache = tmp_path / "fem"
    if place == "store":
        (cache / FILE).mkdir(parents=True)
    else:
        cache.touch()
    status, _, (line,) = check("--fem", cache=cache / "below" if place == "parent" else cache)
    assert status == UNDECIDED
    assert "going on" in line


@pytest.mark.soak
def test_a_quota_on_files_is_one_line_for_the_cache_and_one_for_the_report(tmp_path, monkeypatch):
    """RLIMIT_FSIZE: "File too large", which Python meets as an error and no signal."""
    monkeypatch.setenv("FREEWHEEL_CACHE", str(tmp_path / "fem"))
    path, out = tmp_path / "spring.toml", tmp_path / "out"
    path.write_text(SPRING)
    command = [sys.executable, "-m", "verify", "check", "--fem", str(path), "--out", str(out)]
    done = subprocess.run(
        command, capture_output=True, text=True, timeout=600,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000)),
    )  # fmt: skip
    assert done.returncode == 2
    lines = [x for x in done.stderr.splitlines() if not x.startswith("refinement levels")]
    stored, written = lines
    assert stored.endswith(": going on without")
    assert "File too large" in written
    assert {p.name for p in out.iterdir()} <= {".lock"}

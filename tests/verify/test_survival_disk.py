"""Full or read-only disks: one line, and all other results unchanged."""

import subprocess

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


def remount(folder, option):
    subprocess.run(["mount", "-o", f"remount,{option}", str(folder)], check=True)


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


def test_a_report_that_finds_no_space_is_one_line_and_the_old_one_stays(tiny, tmp_path, check):
    old = {name: f"old {name}".encode() for name in ("report.html", "results.json", "rows.csv")}
    for name, content in old.items():
        (tiny / name).write_bytes(content)
    status, _, (line,) = check("--out", tiny, cache=tmp_path / "fem")
    assert status == 2
    assert line.startswith(f"freewheel: {tiny}/")
    assert line.endswith("cannot be written: No space left on device")
    assert {p.name: p.read_bytes() for p in tiny.iterdir() if p.name != ".lock"} == old
    # a folder that cannot be written is found before the work
    remount(tiny, "ro")
    status, _, (line,) = check("--fem", "--out", tiny / "out", cache=tmp_path / "unused")
    assert status == 2
    assert "Read-only file system" in line
    assert not (tmp_path / "unused").exists()


@pytest.mark.soak
def test_a_cache_that_is_full_or_read_only_is_one_line_and_what_it_has_is_read(
    tiny, tmp_path, check
):
    (tiny / "ballast").write_bytes(bytes(200_000))
    status, _, lines = check("--fem", cache=tiny / "fem")
    assert status == UNDECIDED
    (line,) = [line for line in lines if "cannot be stored" in line]
    assert line.startswith(f"freewheel: {tiny / 'fem' / FILE}: ")
    assert line.endswith(
        "free space on its disk, or remove the file to begin again: going on without"
    )
    remount(tiny, "size=64m")
    assert check("--fem", cache=tiny)[0] == UNDECIDED
    remount(tiny, "ro")
    assert check("--fem", cache=tiny)[:2] == (UNDECIDED, [])  # nothing is solved again
    (tmp_path / "file").touch()
    (tmp_path / "taken" / FILE).mkdir(parents=True)
    places = (tiny / "below", tmp_path / "file", tmp_path / "file" / "below", tmp_path / "taken")
    for place in places:
        status, _, lines = check("--fem", cache=place)
        assert status == UNDECIDED
        assert len([line for line in lines if "going on" in line]) == 1, place

"""Files that are whole or not there, and temporary ones that only the living keep."""

import subprocess
import sys

import pytest

from verify.core.files import PREFIX, remove_abandoned, write_whole

WRITING = """
import os, sys, time
from pathlib import Path
from verify.core.files import write_whole
def slowly(file):
    file.write(b"half"); file.flush()
    print("writing", flush=True)
    sys.stdin.readline()
write_whole(Path(sys.argv[1]) / "entry", slowly)
"""


@pytest.fixture
def writer(tmp_path):
    """A process in the middle of writing `entry`."""
    with subprocess.Popen(
        [sys.executable, "-c", WRITING, tmp_path],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    ) as process:  # fmt: skip
        assert process.stdout.readline() == "writing\n"
        yield process
        process.kill()


def parts(folder):
    return [p.name for p in folder.iterdir() if p.name.startswith(PREFIX)]


def test_a_file_being_written_is_not_there_and_not_abandoned(writer, tmp_path):
    remove_abandoned(tmp_path)
    assert len(parts(tmp_path)) == 1
    assert not (tmp_path / "entry").exists()
    writer.communicate("go on\n")
    assert writer.returncode == 0
    assert (tmp_path / "entry").read_bytes() == b"half"
    assert parts(tmp_path) == []


def test_what_a_killed_writer_left_is_removed(writer, tmp_path):
    writer.kill()
    writer.wait()
    assert len(parts(tmp_path)) == 1
    remove_abandoned(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_file_removed_before_it_was_locked_is_written_again(tmp_path, monkeypatch):
    """Another run sweeps between the making and the locking of a temporary file."""
    import fcntl

    right, swept = fcntl.flock, []

    def late(handle, how):
        if not swept:
            swept.extend(p.unlink() for p in tmp_path.glob(f"{PREFIX}*"))
        right(handle, how)

    monkeypatch.setattr(fcntl, "flock", late)
    write_whole(tmp_path / "entry", lambda file: file.write(b"whole"))
    assert swept
    assert {p.name: p.read_bytes() for p in tmp_path.iterdir()} == {"entry": b"whole"}


def test_a_file_system_without_locks_loses_nothing(tmp_path, monkeypatch):
    import fcntl

    def no_locks(_handle, _how):
        raise OSError(37, "No locks available")

    monkeypatch.setattr(fcntl, "flock", no_locks)
    write_whole(tmp_path / "entry", lambda file: file.write(b"whole"))
    (tmp_path / f"{PREFIX}x").touch()
    remove_abandoned(tmp_path)  # perhaps of a live run: nobody can know
    assert sorted(p.name for p in tmp_path.iterdir()) == [f"{PREFIX}x", "entry"]


def test_other_files_are_none_of_its_business(tmp_path):
    (tmp_path / "part-time.npz").touch()
    (tmp_path / f"{PREFIX}folder").mkdir()
    remove_abandoned(tmp_path)
    remove_abandoned(tmp_path / "nowhere")
    assert len(list(tmp_path.iterdir())) == 2

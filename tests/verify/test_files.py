"""Files that are whole or not there."""

import subprocess
import sys

import pytest

from verify.core.files import PREFIX, write_whole

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


def test_a_file_being_written_is_not_there(writer, tmp_path):
    assert len(parts(tmp_path)) == 1
    assert not (tmp_path / "entry").exists()
    writer.communicate("go on\n")
    assert writer.returncode == 0
    assert (tmp_path / "entry").read_bytes() == b"half"
    assert parts(tmp_path) == []


def test_a_killed_writer_leaves_the_earlier_file(writer, tmp_path):
    (tmp_path / "entry").write_bytes(b"earlier")
    writer.kill()
    writer.wait()
    assert (tmp_path / "entry").read_bytes() == b"earlier"


@pytest.mark.parametrize("error", [OSError, KeyboardInterrupt])
def test_a_writer_that_fails_leaves_nothing(error, tmp_path):
    def fail(file):
        file.write(b"half")
        raise error

    with pytest.raises(error):
        write_whole(tmp_path / "entry", fail)
    assert list(tmp_path.iterdir()) == []

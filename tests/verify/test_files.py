"""Files that are whole or not there."""

import subprocess
import sys

import pytest

from verify.core.files import PREFIX, write_whole

WRITING = """
import sys
from pathlib import Path
from verify.core.files import write_whole
def slowly(file):
    file.write(b"half"); file.flush()
    print("writing", flush=True)
    sys.stdin.readline()
write_whole(Path(sys.argv[1]) / "entry", slowly)
"""


@pytest.mark.parametrize("end", ["written", "killed"])
def test_a_file_being_written_is_not_there_and_a_killed_writer_leaves_the_earlier_one(
    end, tmp_path
):
    (tmp_path / "entry").write_bytes(b"earlier")
    with subprocess.Popen(
        [sys.executable, "-c", WRITING, tmp_path],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    ) as process:  # fmt: skip
        assert process.stdout.readline() == "writing\n"
        assert len([p for p in tmp_path.iterdir() if p.name.startswith(PREFIX)]) == 1
        assert (tmp_path / "entry").read_bytes() == b"earlier"
        if end == "killed":
            process.kill()
        process.communicate("" if end == "killed" else "continue\n")
    assert (tmp_path / "entry").read_bytes() == (b"earlier" if end == "killed" else b"half")
    assert end == "killed" or len([*tmp_path.iterdir()]) == 1


@pytest.mark.parametrize("error", [OSError, KeyboardInterrupt])
def test_a_writer_that_fails_leaves_nothing(error, tmp_path):
    def fail(file):
        file.write(b"half")
        raise error

    with pytest.raises(error):
        write_whole(tmp_path / "entry", fail)
    assert list(tmp_path.iterdir()) == []

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


def test_a_killed_writer_leaves_the_earlier_file_and_one_that_fails_nothing(tmp_path):
    def fail(file):
        file.write(b"half")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_whole(tmp_path / "entry", fail)
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "entry").write_bytes(b"earlier")
    with subprocess.Popen(
        [sys.executable, "-c", WRITING, tmp_path],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    ) as process:  # fmt: skip
        assert process.stdout.readline() == "writing\n"
        assert len([p for p in tmp_path.iterdir() if p.name.startswith(PREFIX)]) == 1
        process.kill()
        process.communicate()
    assert (tmp_path / "entry").read_bytes() == b"earlier"
    write_whole(tmp_path / "entry", lambda file: file.write(b"half"))
    assert (tmp_path / "entry").read_bytes() == b"half"

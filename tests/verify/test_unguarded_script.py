"""A script that starts processes without `if __name__ == "__main__":` gets one error."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "examples" / "winkler_bach.py"  # few equations to draw
SCRIPT = """\
from pathlib import Path
from verify.app.commands import run_verify
from verify.jobs.executor import Where

{guard}run_verify(["{case}"], quick=False, where=Where(2, "{engine}"), out=Path("out"),
           use_cache=False)
"""


def ran(folder, guard, engine, case="ring-lame"):
    script = folder / "mine.py"
    script.write_text(SCRIPT.format(guard=guard, engine=engine, case=case))
    return subprocess.run(
        [sys.executable, str(script)], cwd=folder, capture_output=True, text=True, check=False,
        env=os.environ | {"PYTHONPATH": str(ROOT)}, timeout=300,
    )  # fmt: skip


@pytest.mark.parametrize("engine", ["local", "dask"])
def test_without_the_guard_the_script_ends_with_one_error_that_names_it(tmp_path, engine):
    done = ran(tmp_path, "", engine)
    assert done.returncode == 1
    assert "FAIL" not in done.stdout + done.stderr
    assert not list((tmp_path / "out").iterdir())  # no process wrote a report
    lines = done.stderr.strip().splitlines()
    last = lines[-1]
    assert last.startswith("verify.jobs.engine.GoneError: ")
    assert 'put the calls of the script under `if __name__ == "__main__":`' in last
    assert "does not converge" not in done.stderr


def test_with_the_guard_it_runs(tmp_path):
    done = ran(tmp_path, 'if __name__ == "__main__":\n    ', "local", EXAMPLE)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / "report.html").exists()

"""Commands of both sides in processes of their own: what they take, one thread each."""

import json
import os
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")


@dataclass(frozen=True)
class Used:
    """Wall and processor seconds, the most memory at once [MB], and what was printed."""

    wall: float
    cpu: float
    peak: float
    said: str


def measured(command: list[str], folder: Path | None = None) -> Used:
    """A command run in `folder`; RuntimeError with its own words where it fails."""
    with tempfile.TemporaryFile() as out:
        start = time.perf_counter()
        process = subprocess.Popen(  # noqa: S603
            command, cwd=folder, env=os.environ | ONE_THREAD, stdout=out, stderr=subprocess.PIPE
        )
        assert process.stderr is not None
        words = process.stderr.read().decode("utf-8", "replace")
        _, status, used = os.wait4(process.pid, 0)
        wall = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            raise RuntimeError(f"{' '.join(command)} failed: {words[-500:]}")
        out.seek(0)
        said = out.read().decode("utf-8", "replace")
    return Used(wall, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, said)


def run_module(name: str, *words: object) -> dict[str, Any]:
    """What a module prints as JSON; and what its process took, Python's start included.

    RuntimeError with its own words where it fails.
    """
    used = measured([sys.executable, "-m", name, *map(str, words)])
    answer: dict[str, Any] = json.loads(used.said)
    return answer | {"process": used.wall, "process cpu": used.cpu, "peak": used.peak}

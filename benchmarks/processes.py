"""Commands in separate processes with one thread: time and memory."""

import json
import os
import re
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")
STEP = 0.01  # s between readings of the memory


@dataclass(frozen=True)
class Used:
    """Wall and processor seconds, peak memory [MB], and the printed text."""

    wall: float
    cpu: float
    peak: float
    output: str


def measured(command: list[str], folder: Path | None = None) -> Used:
    """Result of a command in `folder`; RuntimeError with its error output if it fails."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        start, peak, ended = time.perf_counter(), 0.0, 0
        process = subprocess.Popen(  # noqa: S603
            command, cwd=folder, env=os.environ | ONE_THREAD, stdout=out, stderr=err
        )
        while not ended:
            # the peak stated by the system includes the memory of the parent process at the start
            peak = max(peak, _most(process.pid))
            ended, status, used = os.wait4(process.pid, os.WNOHANG)
            time.sleep(0.0 if ended else STEP)
        wall = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        output, errors = (_read(file) for file in (out, err))
    if process.returncode:
        raise RuntimeError(f"{' '.join(command)} failed: {errors[-500:]}")
    return Used(wall, used.ru_utime + used.ru_stime, peak, output)


def _most(process: int) -> float:
    """Peak memory [MB] of a running process so far; 0 if the system does not report it."""
    status = Path(f"/proc/{process}/status")
    found = re.search(r"VmHWM:\s+(\d+)", status.read_text()) if status.exists() else None
    return int(found[1]) / 1024 if found else 0.0


def _read(file: Any) -> str:
    file.seek(0)
    return str(file.read().decode("utf-8", "replace"))


def run_module(name: str, *words: object) -> dict[str, Any]:
    """JSON printed by a module, and the time of its process with the start of Python.

    If it fails, RuntimeError with its error output.
    """
    used = measured([sys.executable, "-m", name, *map(str, words)])
    answer: dict[str, Any] = json.loads(used.output)
    return answer | {"process": used.wall, "process cpu": used.cpu, "peak": used.peak}

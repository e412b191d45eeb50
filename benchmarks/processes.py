"""Runs of this project in processes of their own."""

import json
import os
import resource
import subprocess
import sys
import time
from typing import Any


def run_module(name: str, *words: object) -> dict[str, Any]:
    """What a module prints as JSON, run with one thread; and the process's seconds with its start.

    RuntimeError with its own words where it fails.
    """
    command = [sys.executable, "-m", name, *map(str, words)]
    threads = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    said = subprocess.run(  # noqa: S603
        command, env=os.environ | threads, capture_output=True, text=True, check=False
    )
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if said.returncode:
        raise RuntimeError(f"{name} failed: {said.stderr[-500:]}")
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    answer: dict[str, Any] = json.loads(said.stdout)
    return answer | {"process": wall, "process cpu": cpu}

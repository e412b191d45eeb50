"""Settings of this process that affect rounding errors: BLAS, threads, instruction sets.

An environment variable that selects another processor may have no effect, because OpenBLAS uses the
nearest kernels that it contains. Therefore, only the settings in effect identify a machine.
"""

import json
import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import scipy.linalg  # noqa: F401 - loads the BLAS of scipy, which differs from numpy's
from threadpoolctl import threadpool_info

PROBE_SECONDS = 60.0
CPU_INFO = Path("/proc/cpuinfo")
NUMBA = "NUMBA_CPU_NAME"


def effective() -> dict[str, Any]:
    """Settings in effect in this process, as a dictionary for JSON.

    `blas` is the core type of the kernels of each BLAS library, and `threads` its number of
    threads. `numpy` lists the instruction sets that numpy selects at run time. `numba` is the
    processor for which numba compiles.
    """
    libraries = {_owner(one): one for one in threadpool_info() if one["user_api"] == "blas"}
    extensions: Any = np.show_config(mode="dicts")
    return {
        "blas": {name: str(one.get("architecture", "")) for name, one in libraries.items()},
        "threads": {name: int(one["num_threads"]) for name, one in libraries.items()},
        "numpy": list(extensions["SIMD Extensions"].get("found", ())),
        "numba": os.environ.get(NUMBA) or "host",
    }


def probe(environment: Mapping[str, str]) -> dict[str, Any]:
    """Settings in effect in a process with the given environment.

    Raises OSError if the process ends without reporting them.
    """
    command = [sys.executable, "-m", "verify.audit.portable.effective"]
    try:
        done = subprocess.run(  # noqa: S603 - this interpreter and this module
            command, env=dict(environment), capture_output=True, text=True, check=True,
            timeout=PROBE_SECONDS,
        )  # fmt: skip
        found: dict[str, Any] = json.loads(done.stdout)
    except subprocess.CalledProcessError as error:
        last = (error.stderr.strip() or f"exit status {error.returncode}").splitlines()[-1]
        raise OSError(last) from error
    except (subprocess.TimeoutExpired, ValueError) as error:
        raise OSError("the process did not report its libraries") from error
    return found


def processor_flags(path: Path | None = None) -> frozenset[str]:
    """Instruction sets of the first processor, as named by Linux; empty if unknown."""
    try:
        text = (path or CPU_INFO).read_text("utf-8")
    except OSError:
        return frozenset()
    line = next((line for line in text.splitlines() if line.startswith("flags")), "")
    return frozenset(line.partition(":")[2].split())


def _owner(library: Mapping[str, Any]) -> str:
    """Name of the package that contains the library, otherwise the name of its file."""
    path = Path(library["filepath"])
    folder = path.parent.name
    return folder.removesuffix(".libs") if folder.endswith(".libs") else path.name


if __name__ == "__main__":
    print(json.dumps(effective(), sort_keys=True))

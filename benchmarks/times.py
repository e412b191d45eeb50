"""Times of the commands that a user waits for, cold and warm: minimum, median and maximum of runs.

python -m benchmarks.times [--runs 5] [NAME...]

Cold runs begin with an empty store. Processor seconds are those of all processes of a command. The
machine should be idle otherwise.
"""

import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

FREEWHEEL = (sys.executable, "-m", "verify.app.cli")
CHECKS = """
import contextlib, io, sys
from verify.app.cli import run
for _ in range(101):
    with contextlib.redirect_stdout(io.StringIO()):
        assert run(["check", sys.argv[1]]) != 2
"""
Seconds = tuple[float, float]  # wall, processor


def timed(command: tuple[str, ...], store: Path) -> Seconds:
    """Wall and processor seconds of a command that uses the given store."""
    environment = {**os.environ, "FREEWHEEL_CACHE": str(store)}
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(command, env=environment, check=True, capture_output=True)  # noqa: S603
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return wall, used


def cold(*command: str) -> Callable[[Path], Seconds]:
    """A command with an empty store."""

    def run(folder: Path) -> Seconds:
        with tempfile.TemporaryDirectory(dir=folder) as store:
            return timed((*FREEWHEEL, *command, "--out", f"{store}/out"), Path(store))

    return run


def warm(*command: str) -> Callable[[Path], Seconds]:
    """A command that was run before with the same store."""
    return lambda folder: timed((*FREEWHEEL, *command), folder / "store")


def again(*command: str) -> Callable[[Path], Seconds]:
    """A run in which nothing has changed since the previous run."""
    return lambda folder: warm(*command, "--out", str(folder / "out"))(folder)


def checks(folder: Path) -> Seconds:
    """Mean time of a check over a hundred checks in one process, without the start."""
    file = _file(folder)
    one = timed((*FREEWHEEL, "check", file), folder / "store")
    many = timed((sys.executable, "-c", CHECKS, file), folder / "store")
    return (many[0] - one[0]) / 100, (many[1] - one[1]) / 100


def _file(folder: Path) -> str:
    file = folder / "ring.toml"
    if not file.exists():
        timed((*FREEWHEEL, "init", "ring-lame", "--out", str(file)), folder / "store")
    return str(file)


MEASURED: dict[str, Callable[[Path], Seconds]] = {
    "verify, cold": cold("verify"),
    "verify, nothing changed": again("verify"),
    "verify --quick, cold": cold("verify", "--quick"),
    "help": warm("--help"),
    "check": lambda folder: timed((*FREEWHEEL, "check", _file(folder)), folder / "store"),
    "check, one of a hundred": checks,
}


def main() -> None:
    """Print a table of the chosen figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", choices=[[], *MEASURED])
    parser.add_argument("--runs", type=int, default=5)
    chosen = parser.parse_args()
    print("| command | wall s: min, median, max | processor s: min, median, max |\n|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for figure in chosen.names or MEASURED:
            if figure == "verify, nothing changed":
                MEASURED[figure](folder)
            runs = [MEASURED[figure](folder) for _ in range(chosen.runs)]
            cells = (_spread([run[side] for run in runs]) for side in (0, 1))
            print(f"| {figure} | {' | '.join(cells)} |", flush=True)


def _spread(values: list[float]) -> str:
    return ", ".join(f"{v:.3g}" for v in (min(values), statistics.median(values), max(values)))


if __name__ == "__main__":
    main()

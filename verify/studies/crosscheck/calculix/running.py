"""Runs of calculix; the output is stored in the folder of the deck."""

import os
import re
import resource
import shutil
import subprocess
import time
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from verify.studies.crosscheck.calculix.reading import Array, displacements

LAST = 500  # characters of the output of calculix in an error message


@dataclass(frozen=True, kw_only=True)
class Run:
    """Wall-clock and processor time [s] of one run of `deck`."""

    wall: float
    cpu: float
    deck: Path

    @cached_property
    def u(self) -> Array:
        """Displacements (nodes, 2) in the last increment."""
        return displacements(self.deck.with_suffix(".frd"))


def executable() -> str | None:
    """Path of the calculix solver, or None if it is not installed."""
    return shutil.which("ccx")


def version() -> str:
    """Version that calculix prints."""
    output = subprocess.run([str(executable()), "-v"], capture_output=True, text=True, check=False)  # noqa: S603
    return " ".join(re.findall(r"Version\s+(\S+)", output.stdout)) or "unknown"


def start() -> float:
    """Time [s] of a calculix process that only prints its version."""
    begun = time.perf_counter()
    version()
    return time.perf_counter() - begun


def run_deck(deck: Path, threads: int = 1, limit: float | None = None) -> Run:
    """Run calculix on `deck` for at most `limit` seconds.

    The output is stored in the folder of the deck as a .log file. Raises RuntimeError with the last
    part of the output if calculix fails or exceeds the limit.
    """
    command = [str(executable()), "-i", deck.stem]
    environment = os.environ | {"OMP_NUM_THREADS": str(threads)}
    log = deck.with_suffix(".log")
    before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    with log.open("w", encoding="utf-8") as output:
        try:
            done = subprocess.run(  # noqa: S603
                command, cwd=deck.parent, env=environment, stdout=output,
                stderr=subprocess.STDOUT, check=False, timeout=limit,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            raise RuntimeError(
                f"calculix exceeded its limit, {limit:g} s, on {deck.name}"
            ) from None
    wall, after = time.perf_counter() - begun, resource.getrusage(resource.RUSAGE_CHILDREN)
    words = log.read_text("utf-8", errors="replace")
    if done.returncode or "*ERROR" in words:
        raise RuntimeError(f"calculix failed on {deck.name}: {words[-LAST:]}")
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return Run(wall=wall, cpu=cpu, deck=deck)

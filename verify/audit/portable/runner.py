"""Processes of the emulated machines, some in parallel, with separate environment and cache."""

import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from verify.audit.portable.store import Place, Results
from verify.core.progress import Show, State

LOG = "log.txt"
TICK = 1.0  # s between two looks at the processes
GUESS = 15.0  # s per case on one processor, if no time was measured


@dataclass(frozen=True, kw_only=True)
class Work:
    """Work of one process: cases of a machine, its environment, and the folder of its log."""

    place: Place
    folder: Path
    environment: Mapping[str, str]
    cases: tuple[str, ...]
    seed: int | None = None

    @property
    def name(self) -> str:
        """Name of the emulated machine."""
        return self.place.variant

    def results(self) -> Results:
        """Stored results of the machine."""
        return self.place.results()

    def is_done(self) -> bool:
        """Whether all results exist for the present code."""
        return set(self.cases) <= set(self.results().cases)


def run_all(work: Sequence[Work], processes: int, show: Show) -> dict[str, str]:
    """Run the machines with missing results; return the failures by machine.

    If the run is interrupted, all processes end. The next run uses the stored results.
    """
    waiting = [one for one in work if not one.is_done()]
    running: dict[str, tuple[Work, subprocess.Popen[bytes]]] = {}
    failures: dict[str, str] = {}
    progress = Progress(work, processes)
    try:
        while waiting or running:
            while waiting and len(running) < processes:
                one = waiting.pop(0)
                running[one.name] = one, _start(one)
            time.sleep(TICK)
            for name, (one, process) in list(running.items()):
                if (status := process.poll()) is not None:
                    del running[name]
                    _end(process)
                    if status:
                        failures[name] = _ending(one, status)
            show(progress.state([one for one, _ in running.values()]))
    finally:
        for _, process in running.values():
            _end(process)
    return failures


class Progress:
    """Progress of all machines: number of finished cases, and remaining time."""

    def __init__(self, work: Sequence[Work], processes: int) -> None:
        self.processes = processes
        self.done = {one.name: self._seconds(one) for one in work}
        self.total = sum(len(one.cases) for one in work)

    def state(self, running: Sequence[Work]) -> State:
        for one in running:
            self.done[one.name] = self._seconds(one)
        done = sum(map(len, self.done.values()))
        known = [seconds for cases in self.done.values() for seconds in cases.values()]
        each = sum(known) / len(known) if known else GUESS
        names = tuple(one.name for one in running)
        remaining = each * (self.total - done) / self.processes
        return State(done, self.total, names, remaining, what="cases on emulated machines")

    @staticmethod
    def _seconds(one: Work) -> dict[str, float]:
        cases = one.results().cases
        return {name: cases[name].seconds for name in one.cases if name in cases}


def _start(one: Work) -> subprocess.Popen[bytes]:
    one.folder.mkdir(parents=True, exist_ok=True)
    command = [sys.executable, "-m", "verify.audit.portable.worker"]
    command += [str(one.place.store.path.parent), one.place.variant, one.place.key]
    command += ["--seed", str(one.seed)] if one.seed is not None else []
    with (one.folder / LOG).open("wb") as log:
        return subprocess.Popen(  # noqa: S603 - this interpreter and this project's module
            [*command, *one.cases], env=dict(one.environment), stdin=subprocess.PIPE, stdout=log,
            stderr=subprocess.STDOUT,
        )  # fmt: skip


def _end(process: subprocess.Popen[bytes]) -> None:
    process.kill()
    process.wait()
    if process.stdin is not None:
        process.stdin.close()


def _ending(one: Work, status: int) -> str:
    """Text with the exit status of a process and the last line of its log."""
    how = f"signal {-status}" if status < 0 else f"exit status {status}"
    lines = (one.folder / LOG).read_text("utf-8", errors="replace").split("\n")
    last = next((line.strip() for line in reversed(lines) if line.strip()), "")
    return f"{how}: {last}; see {one.folder / LOG}" if last else how

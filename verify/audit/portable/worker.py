"""Process of one emulated machine: solves and judges cases, and stores their rows.

`python -m verify.audit.portable.worker FOLDER VARIANT KEY [--seed N] CASE...` is started in the
environment of the machine and writes to the store in FOLDER. The process ends when its standard
input closes, which happens when the parent process ends.
"""

import argparse
import os
import sys
import threading
import time
from collections.abc import Sequence
from pathlib import Path

from verify.audit.portable.effective import effective
from verify.audit.portable.moving import record
from verify.audit.portable.perturbation import Outcome, perturb_defaults
from verify.audit.portable.store import MACHINE, CaseRecord, Place
from verify.cases.registry import CASES, find
from verify.core.case import Case
from verify.core.store import Store
from verify.jobs import cache
from verify.jobs.level import Job
from verify.jobs.scheduler import run


def solve_cases(place: Place, cases: Sequence[Case], seed: int | None) -> None:
    """Solve each case that has no stored record, and store its record."""
    stored = place.results()
    if not stored.effective:
        place.keep(MACHINE, effective())
    outcomes = perturb_defaults([case.inputs for case in CASES], seed) if seed is not None else {}
    for number, case in enumerate(cases, start=1):
        if case.id in stored.cases:
            continue
        found = rows_of(case, outcomes.get(case.inputs, Outcome()))
        place.keep(case.id, found)
        print(f"{number} of {len(cases)}: {case.id}, {found.seconds:.1f} s", flush=True)


def rows_of(case: Case, outcome: Outcome) -> CaseRecord:
    """Record of one case, solved in this process with default inputs and the machine's cache."""
    start = time.perf_counter()
    job = Job(case, case.inputs(), drawn=False)
    (result,) = run([job], cache_folder=cache.default_folder())
    return CaseRecord(
        rows=tuple(record(row) for row in result.rows),
        seconds=round(time.perf_counter() - start, 2),
        fixed=outcome.fixed, rejected=outcome.rejected, errors=len(result.errors),
    )  # fmt: skip


def main(arguments: Sequence[str]) -> int:
    """Solve the cases that the command line names; return 0 whether rows pass or fail."""
    parser = argparse.ArgumentParser(prog="verify.audit.portable.worker")
    parser.add_argument("folder", type=Path)
    parser.add_argument("variant")
    parser.add_argument("key")
    parser.add_argument("cases", nargs="+")
    parser.add_argument("--seed", type=int)
    given = parser.parse_args(arguments)
    cases = [find(name) for name in given.cases]
    place = Place(Store(given.folder), given.variant, given.key)
    solve_cases(place, cases, given.seed)
    return 0


def _end_with_parent() -> None:
    while os.read(sys.stdin.fileno(), 1):  # below Python's buffer, whose lock the end would want
        pass
    os._exit(1)


if __name__ == "__main__":
    threading.Thread(target=_end_with_parent, daemon=True).start()
    raise SystemExit(main(sys.argv[1:]))

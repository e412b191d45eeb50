"""Command `freewheel mutants`: check mutants, print how many are detected, store the score."""

import os
import time
from collections.abc import Sequence
from typing import Any

from verify.audit.mutation import groups, references, score
from verify.audit.mutation.baseline import Notes
from verify.audit.mutation.campaign import Campaign
from verify.audit.mutation.console import print_score
from verify.audit.mutation.digest import digest
from verify.audit.mutation.outcomes import Outcomes
from verify.audit.mutation.workload import loads
from verify.cases.registry import CASES
from verify.core.progress import Show, State, shown
from verify.core.store import Store
from verify.jobs import cache
from verify.jobs.executor import Where

SEED = 0  # of the sample that is stored


def run_mutants(*, whole: bool, seed: int, jobs: int, only: Sequence[str]) -> int:
    """Check the groups, print and store the scores; return 1 if a requirement is not met."""
    Where(jobs)  # raises an error for a wrong number of processes
    jobs = jobs or os.cpu_count() or 1
    names = [name for name in (score.REFERENCES, *groups.MAKE) if not only or name in only]
    mutated = [name for name in names if name in groups.MAKE]
    code, store = digest(), Store(cache.default_folder())
    outcomes = Outcomes(store, code)
    found: dict[str, Any] = {}
    with shown(quiet=False) as show:
        if score.REFERENCES in names:
            found[score.REFERENCES] = _references(show)
        every = loads(CASES, cache.default_folder()) if mutated else []
        notes = Notes(store, jobs, show)
        for name in mutated:
            start = time.monotonic()
            group = groups.MAKE[name](every, notes, seed, whole=whole)
            Campaign(group, outcomes, jobs, show).run()
            found[name] = score.scored(group, outcomes.found, time.monotonic() - start)
    return _concluded(found, code, is_kept=seed == SEED)


def _references(show: Show) -> Any:
    start = time.monotonic()

    def show_progress(done: int, every: int, case: str) -> None:
        left = (time.monotonic() - start) / max(done, 1) * (every - done)
        show(State(done, every, (case,) * bool(case), left, what="references moved, cases"))

    return references.measured(CASES, cache.default_folder(), show=show_progress)


def _concluded(found: dict[str, Any], code: str, *, is_kept: bool) -> int:
    for name, one in found.items():
        if is_kept:
            score.keep(name, one, code)
    caught = score.caught(found)
    print_score(caught)
    complaints = score.complaints(caught)
    for complaint in complaints:
        print(complaint)
    return 1 if complaints else 0

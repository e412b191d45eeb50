"""Command `freewheel portable`: solve on emulated machines and compare with this machine."""

import os
import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path

from verify.audit.portable import reasons
from verify.audit.portable.compare import Difference, differences, moves
from verify.audit.portable.effective import effective, probe, processor_flags
from verify.audit.portable.runner import Work, run_all
from verify.audit.portable.store import KIND, Place, Results, key_of
from verify.audit.portable.summary import Machine, Summary, largest, lines, write
from verify.audit.portable.variants import BASELINE, Machines, Variant, candidates, machines
from verify.cases.registry import CASES, find
from verify.core.inputs import InputError
from verify.core.progress import shown
from verify.core.store import Store
from verify.jobs import cache
from verify.jobs.executor import Where

ROOT = Path(__file__).parents[3]
MOST_SEEDS = 1000


def run_list(seeds: int) -> int:
    """Print the emulated machines, and reasons why other machines cannot be emulated."""
    emulated = _machines((), seeds)
    for variant in emulated.variants:
        print(f"{variant.name:16} {variant.what}")
    for name, why in emulated.not_emulated.items():
        print(f"{name:16} not emulated: {why}")
    return 0


def run_portable(
    names: Sequence[str], *, only: Sequence[str], seeds: int, jobs: int, again: bool,
    out: Path | None,
) -> int:  # fmt: skip
    """Run the emulated machines, print and write the differences.

    Returns 0 if every difference has a reason.
    """
    Where(jobs)  # raises an error for a wrong number of processes
    cases = tuple(find(name).id for name in dict.fromkeys(names)) or CASES.ids
    stated = reasons.read()
    emulated = _machines(only, seeds)
    folder = out or ROOT / "reports" / "out" / "portable"
    work = [_work(one, emulated, cases, folder) for one in emulated.variants]
    if again:
        for one in work:
            one.place.store.clear(KIND, one.name)
            shutil.rmtree(one.environment["FREEWHEEL_CACHE"], ignore_errors=True)
    try:
        with shown(quiet=False) as show:
            failures = run_all(work, jobs or os.cpu_count() or 1, show)
    except KeyboardInterrupt:
        raise KeyboardInterrupt("interrupted; the next run uses finished cases") from None
    is_full = not names and not only
    summary = summarized(work, emulated, failures, stated, is_full=is_full)
    for line in lines(summary):
        print(line)
    write(summary, folder)
    print(f"report: {folder / 'portable.md'}")
    return 0 if summary.is_portable else 1


def summarized(
    work: Sequence[Work], emulated: Machines, failures: Mapping[str, str],
    stated: Sequence[reasons.Reason], *, is_full: bool,
) -> Summary:  # fmt: skip
    """Summary of the differences of each machine from the baseline, over cases solved on both."""
    results = {one.name: one.results() for one in work}
    here = results[BASELINE]
    found: list[Difference] = []
    moved: list[Difference] = []
    for one in work:
        for case in one.cases:
            pair = here.cases.get(case), results[one.name].cases.get(case)
            if one.name == BASELINE or pair[0] is None or pair[1] is None:
                continue
            rows = pair[0].rows, pair[1].rows
            found += differences(*rows, one.name, perturbed=one.seed is not None)
            moved += moves(*rows, one.name, perturbed=one.seed is not None)
    found, unused = reasons.explained(found, stated)
    what = {variant.name: variant.what for variant in emulated.variants}
    return Summary(
        machines=tuple(_machine(one, results[one.name], what[one.name]) for one in work),
        not_emulated=emulated.not_emulated, differences=tuple(found), moves=largest(moved),
        failures=failures, unused=tuple(reason.rows for reason in unused) if is_full else (),
    )  # fmt: skip


def _machines(only: Sequence[str], seeds: int) -> Machines:
    """Requested machines that can be emulated, always including the baseline.

    Raises InputError if an argument is wrong.
    """
    if not 0 <= seeds <= MOST_SEEDS:
        raise InputError(f"--seeds must be 0 to {MOST_SEEDS}, got {seeds}")
    every = candidates(effective()["numpy"], seeds)
    known = [variant.name for variant in every]
    if unknown := [name for name in only if name not in known]:
        raise InputError(f"--only {unknown[0]}: unknown machine; known are {', '.join(known)}")
    chosen = [v for v in every if not only or v.name in only or v.name == BASELINE]
    return machines(chosen, probe, processor_flags())


def _work(variant: Variant, emulated: Machines, cases: tuple[str, ...], folder: Path) -> Work:
    """Work of the process of an emulated machine, with a separate cache.

    The cache is separate because its keys do not contain the processor.
    """
    place = cache.default_folder()
    environment = variant.applied(os.environ)
    environment["FREEWHEEL_CACHE"] = str(place.with_name(f"{place.name}-machines") / variant.name)
    key = key_of(emulated.effective[variant.name], variant.seed)
    return Work(
        place=Place(Store(place), variant.name, key), folder=folder / variant.name,
        environment=environment, cases=cases, seed=variant.seed,
    )  # fmt: skip


def _machine(one: Work, results: Results, what: str) -> Machine:
    """Summary of one emulated machine."""
    cases = {name: results.cases[name] for name in one.cases if name in results.cases}
    return Machine(
        name=one.name, what=what, effective=results.effective, cases=len(cases),
        rows=sum(len(case.rows) for case in cases.values()),
        seconds=round(sum(case.seconds for case in cases.values()), 1),
        fixed=tuple(f"{name}: {place}" for name, case in cases.items() for place in case.fixed),
        rejected=tuple(f"{name}: {case.rejected}" for name, case in cases.items() if case.rejected),
    )  # fmt: skip

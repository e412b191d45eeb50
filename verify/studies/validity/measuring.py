"""Measure where formulas hold: the scans of cases, solved like any sweep and kept by case."""

import time
from collections.abc import Sequence

from verify.core.case import Case
from verify.core.inputs import InputError
from verify.core.progress import Show
from verify.core.suggestions import nearest
from verify.jobs.executor import Where
from verify.studies.sweep.outcome import outcome
from verify.studies.sweep.run import solve
from verify.studies.validity import store as kept

NAME = "validity"


def chosen(names: Sequence[str], cases: Sequence[Case]) -> list[Case]:
    """The cases with scans that "validity", all, and "validity:CASE" name; InputError."""
    found = [case for case in cases if case.scans]
    if NAME in names:
        return found
    known = {case.id: case for case in found}
    wanted = [name.partition(":")[2] for name in dict.fromkeys(names)]
    for name in wanted:
        if name not in known:
            asked = f"{NAME}:{name}".rstrip(":")
            raise InputError(f"{asked}: no such measurement, there are {nearest(name, known)}")
    return [known[name] for name in wanted]


def measure(
    cases: Sequence[Case],
    where: Where,
    *,
    again: bool = False,
    show: Show = lambda _state: None,
) -> None:
    """Measure what is not kept for the present code, case by case, and say what was done.

    A run goes on where one was interrupted. OSError where the file cannot be written.
    """
    for case in cases:
        if not again and kept.measured(case) is not None:
            print(f"{NAME}:{case.id}: measured already, --again measures it anew")
            continue
        start = time.perf_counter()
        found = [outcome(solve(plan, where, again=again, show=show)) for plan in kept.plans(case)]
        kept.keep(case, found)
        points = sum(len(one.solved.plan.points) for one in found)
        bad = sum(bool(problem) for one in found for problem in one.problems)
        said = f", {bad} without finite elements" if bad else ""
        print(f"{NAME}:{case.id}: {points} points in {time.perf_counter() - start:.0f} s{said}")

"""Study of ranges of validity: the scans of a case are solved as sweeps and stored."""

import time
from collections.abc import Sequence

from verify.cases import registry
from verify.core.case import Case
from verify.core.progress import shown
from verify.jobs.executor import Where
from verify.studies.study import Study
from verify.studies.sweep.outcome import outcome
from verify.studies.sweep.run import solve
from verify.studies.validity import store


def measure(cases: Sequence[Case], where: Where, again: bool) -> bool:
    """Solve the scans of each case, store the errors, and print the number of points.

    An interrupted run is continued by the same command. The result is False if processes ended
    unexpectedly or the machine failed; such a case is not stored. Points without a solution by
    finite elements are valid results and are counted.
    """
    good = True
    with shown(quiet=False) as show:
        for case in cases:
            start = time.perf_counter()
            found = [
                outcome(solve(plan, where, again=again, show=show)) for plan in store.plans(case)
            ]
            lost = sum(point.lost for one in found for point in one.solved.solutions)
            if lost:
                good = False
                print(f"{VALIDITY.title(case)}: not stored: {lost} points were not completed")
                continue
            store.keep(case, found)
            points = sum(len(one.solved.plan.points) for one in found)
            bad = sum(bool(problem) for one in found for problem in one.problems)
            failed = f", {bad} without finite elements" if bad else ""
            seconds = time.perf_counter() - start
            print(f"{VALIDITY.title(case)}: {points} points in {seconds:.0f} s{failed}")
    return good


VALIDITY = Study(
    name="validity",
    cases=lambda: [case for case in registry.CASES if case.scans],
    is_measured=lambda case: store.measured(case) is not None,
    measure=measure,
)

"""The command `deep`: what takes longer than a run may, measured once and read by reports."""

from collections.abc import Sequence

from verify.core.progress import shown
from verify.core.results import Status
from verify.jobs import cache
from verify.jobs.deep_results import keep, measured
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.session import solve


def run_deep(names: Sequence[str], *, jobs: int, again: bool = False) -> int:
    """Measure the named deep cases, or all that are not measured for the present code.

    "validity" and "validity:CASE" measure where formulas hold, "budget" and "budget:CASE" of what
    differences are made; no name measures all. 0 where everything was measured, 1 where a part
    failed.
    """
    from verify.cases.registry import CASES, DEEP, find
    from verify.studies.budget import measuring as budget
    from verify.studies.validity import measuring

    of_validity, of_budget = (
        [name for name in names if name.partition(":")[0] == kind]
        for kind in (measuring.NAME, budget.NAME)
    )
    regions = measuring.chosen(of_validity if names else (measuring.NAME,), CASES)
    differences = budget.chosen(of_budget if names else (budget.NAME,), CASES)
    others = [name for name in dict.fromkeys(names) if name not in {*of_validity, *of_budget}]
    try:
        chosen = [find(name, DEEP) for name in others]
    except ValueError as error:
        raise ValueError(f"{error}, validity[:CASE], budget[:CASE]") from None
    chosen = chosen if names else list(DEEP)
    missing = [case for case in chosen if again or measured(case) is None]
    for case in chosen:
        if case not in missing:
            print(f"{case.id}: measured already, --again measures it anew")
    results = solve([Job(case, case.inputs(), drawn=False) for case in missing], Where(jobs), True)
    failed = False
    for case, result in zip(missing, results, strict=True):
        bad = [row.reason for row in result.rows if row.status is Status.FAIL]
        folder = cache.default_folder()
        parts = [cache.load(folder, case, case.inputs(), level) for level in case.levels]
        whole = [part for part in parts if part is not None]
        if bad or len(whole) < len(parts):
            failed = True
            print(f"{case.id}: {bad[0] if bad else 'the cache could not be written'}")
            continue
        keep(case, whole)
        print(f"{case.id}: {len(whole)} parts measured in {result.seconds:.0f} s")
    with shown(quiet=False) as show:
        measuring.measure(regions, Where(jobs), again=again, show=show)
        failed |= not budget.measure(differences, Where(jobs), again=again, show=show)
    return 1 if failed else 0

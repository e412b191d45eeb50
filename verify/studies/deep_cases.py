"""Study of deep cases: their levels are solved like those of other cases, and stored together."""

from collections.abc import Sequence

from verify.cases import registry
from verify.core.case import Case
from verify.core.results import CaseResult, Status
from verify.jobs import cache
from verify.jobs.deep_results import keep, measured
from verify.jobs.executor import Where
from verify.jobs.level import Job
from verify.jobs.session import solve
from verify.studies.study import Study


class DeepCases(Study):
    """Study with one record for each deep case, named by the id of the case."""

    def title(self, case: Case) -> str:
        """Name of the record on the command line: the id of the case."""
        return case.id

    def chosen(self, names: Sequence[str]) -> list[Case]:
        """Cases with the ids `names`.

        Raises ValueError, which lists similar ids, if an id is unknown.
        """
        try:
            return [registry.find(name, self.cases()) for name in names]
        except ValueError as error:
            if unknown := [name for name in names if name in registry.ids(registry.CASES)]:
                one = unknown[0]
                raise ValueError(
                    f"{one} is a case: give its study too, as validity:{one} or budget:{one}"
                ) from None
            raise ValueError(f"{error}, validity[:CASE], budget[:CASE]") from None


def measure(cases: Sequence[Case], where: Where, _again: bool) -> bool:
    """Solve the levels that are not in the cache, and store each case that has no failed row."""
    results = solve([Job(case, case.inputs(), drawn=False) for case in cases], where, True)
    good = [_store(case, result) for case, result in zip(cases, results, strict=True)]
    return all(good)


def _store(case: Case, result: CaseResult) -> bool:
    """Store a case and print a line; False if a row failed or a level is missing."""
    bad = [row.reason for row in result.rows if row.status is Status.FAIL]
    folder = cache.default_folder()
    parts = [cache.load(folder, case, case.inputs(), level) for level in case.levels]
    whole = [part for part in parts if part is not None]
    if bad or len(whole) < len(parts):
        print(f"{case.id}: {bad[0] if bad else 'the cache could not be written'}")
        return False
    keep(case, whole)
    print(f"{case.id}: {len(whole)} parts measured in {result.seconds:.0f} s")
    return True


DEEP_CASES = DeepCases("", lambda: registry.DEEP, lambda case: measured(case) is not None, measure)

"""The command `deep` runs long studies once and stores their results for reports."""

from collections.abc import Sequence

from verify.core.case import Case
from verify.jobs.executor import Where
from verify.studies.budget.measuring import BUDGET
from verify.studies.deep_cases import DEEP_CASES
from verify.studies.study import Study
from verify.studies.validity.measuring import VALIDITY

STUDIES = {study.name: study for study in (DEEP_CASES, VALIDITY, BUDGET)}


def run_deep(names: Sequence[str], *, jobs: int, again: bool = False) -> int:
    """Run the named studies, by default all, if they have no record for the present code.

    "validity" and "validity:CASE" measure ranges of validity, "budget" and "budget:CASE" the causes
    of differences. Other names are those of deep cases. Returns 0 if everything was measured, 1 if
    a part failed.
    """
    where = Where(jobs)
    chosen = [(study, _chosen(study, names)) for study in STUDIES.values()]
    good = [study.measure_missing(cases, where, again=again) for study, cases in chosen]
    return 0 if all(good) else 1


def _chosen(study: Study, names: Sequence[str]) -> Sequence[Case]:
    """The cases of a study that the names select; ValueError for an unknown name."""
    if not names:
        return study.cases()
    return study.chosen([name for name in dict.fromkeys(names) if _study_of(name) is study])


def _study_of(name: str) -> Study:
    return STUDIES.get(name.partition(":")[0], DEEP_CASES)

"""The report of a run: judged cases, ledgers, records of studies, verdicts and provenance."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from verify.app.parts import Parts
from verify.app.provenance import provenance
from verify.cases.registry import CASES, find, ids
from verify.core.case import Case
from verify.core.results import (
    CaseBudget,
    CaseResult,
    Caught,
    Crosscheck,
    Drift,
    ReadingsTried,
    Report,
    StoredStudy,
    Validity,
)
from verify.core.verdicts import FormulaVerdict

ROOT = Path(__file__).parents[2]
NOTHING = Parts()
_READINGS = "verify.studies.readings.tried"


def make_report(
    results: Sequence[CaseResult], cases: Sequence[Case], seconds: float, name: str = "",
    parts: Parts = NOTHING,
) -> Report:  # fmt: skip
    """Report of a run with ledgers and provenance; `name` is the name in a parameter file, or "".

    Pages stored in `parts` are not made again; only cases with new pages are imported.
    """
    from verify.papers.ledgers import ledgers, sources

    own = [result for result in results if result.id in CASES.ids]
    left_out = len(CASES) - len(own)
    head: dict[str, Any] = {
        "cases": tuple(results), "name": name,
        "provenance": {**provenance(ROOT, results, seconds), "left_out": left_out},
        "crosschecks": () if name else _crosschecks(results, parts),
    }  # fmt: skip
    if not own:
        return Report(**head, **sources(results))
    inputs = _claims(cases, parts)
    if name:
        return Report(**head, **ledgers(results, inputs))
    names = [result.id for result in own]
    return Report(
        **head, **ledgers(results, inputs), caught=_caught(),
        validity=_validity(results, cases, parts), budgets=_budgets(own, parts),
        drift=_drift(own),
        searches=parts.of_all("searches", _READINGS, names, lambda: _searches(names)),
        studies=_studies(results, parts) if len(results) > 1 else (),
        verdicts=() if left_out else _verdicts(results, parts),
    )  # fmt: skip


def _claims(cases: Sequence[Case], parts: Parts) -> Mapping[str, Sequence[str]]:
    """Inputs of the cases that equal a printed number, by "paper:id" of the number."""
    from verify.papers.paper_tables import claiming_inputs

    def of_case(name: str) -> Mapping[str, Sequence[str]]:
        return claiming_inputs([find(name, cases)])

    found: dict[str, list[str]] = {}
    made = parts.of_cases("claims of inputs", "verify.papers.paper_tables", ids(cases), of_case)
    for claims in made.values():
        for reference, inputs in claims.items():
            found.setdefault(reference, []).extend(inputs)
    return found


def _crosschecks(results: Sequence[CaseResult], parts: Parts) -> tuple[Crosscheck, ...]:
    """Results of second solvers for the problems of the cases."""
    names = [result.id for result in results]

    def reported() -> tuple[Crosscheck, ...]:
        from verify.studies.crosscheck.judged import reported  # reads the sources of all it needs

        return reported(names)

    return parts.of_all("crosschecks", "verify.studies.crosscheck.judged", names, reported)


def _validity(
    results: Sequence[CaseResult], cases: Sequence[Case], parts: Parts
) -> tuple[Validity, ...]:
    """Ranges of validity of the formulas, for the inputs of the papers."""
    by_name = {result.id: result for result in results}

    def of_case(name: str) -> Validity | None:
        # scipy's statistics, which `check` does without
        from verify.studies.validity.cards import of_result

        return of_result(find(name, cases), by_name[name])

    known = [name for name in ids(cases) if name in by_name]
    made = parts.of_cases("validity", "verify.studies.validity.cards", known, of_case)
    # a run of some cases has no place for the maps of others
    return tuple(
        replace(one, maps=tuple(name for name in one.maps if name in by_name))
        for one in made.values() if one
    )  # fmt: skip


def _studies(results: Sequence[CaseResult], parts: Parts) -> tuple[StoredStudy, ...]:
    """Stored studies of the cases, from which pages interpolate the error at a user's inputs."""
    by_name = {result.id: result for result in results}

    def of_case(name: str) -> tuple[StoredStudy, ...]:
        from verify.verdicts.stored_points import studies

        return studies([by_name[name]])

    made = parts.of_cases("studies", "verify.verdicts.stored_points", list(by_name), of_case)
    return tuple(one for found in made.values() for one in found)


def _budgets(results: Sequence[CaseResult], parts: Parts) -> tuple[CaseBudget, ...]:
    """Error budgets for the inputs of the papers."""
    by_name = {result.id: result for result in results}

    def of_case(name: str) -> CaseBudget | None:
        from verify.studies.budget.console import of_result  # reads sources of all it depends on

        return of_result(by_name[name])

    made = parts.of_cases("budgets", "verify.studies.budget.console", list(by_name), of_case)
    return tuple(one for one in made.values() if one)


def _drift(results: Sequence[CaseResult]) -> Drift | None:
    """Changes since the last release; None if no release is stored."""
    from verify.audit.releases.changes import since

    return since(results)


def _searches(names: Sequence[str]) -> tuple[ReadingsTried, ...]:
    """Results of the searches for other readings of printed numbers in the named cases."""
    from verify.studies.readings.tried import searches

    return searches(names)


def _caught() -> Caught:
    """Stored results of the fault detection: mutants and changed references."""
    from verify.audit.mutation.score import latest  # judges again, which `check` does not need

    return latest()


def _verdicts(results: Sequence[CaseResult], parts: Parts) -> tuple[FormulaVerdict, ...]:
    """Verdicts of all papers' formulas, which depend on the cases of the papers' evidence."""
    rows = [row for result in results for row in result.rows]

    def of_paper(key: str) -> tuple[FormulaVerdict, ...]:
        from verify.verdicts.found import verdicts

        return verdicts(rows, key)

    def evidence() -> Mapping[str, Sequence[str]]:
        from verify.verdicts.declared import cases_by_paper

        return cases_by_paper()

    groups = parts.of_all("evidence", "verify.verdicts.declared", (), evidence)
    made = parts.by_group("verdicts", "verify.verdicts.found", groups, of_paper)
    return tuple(one for verdicts in made.values() for one in verdicts)

"""All searches for readings in a run, for the report."""

from collections.abc import Collection

from verify.core.results import ReadingsTried
from verify.papers.ledger import published
from verify.studies.readings.problem import Problem
from verify.studies.readings.registry import PROBLEMS, WITHOUT_FORMULA
from verify.studies.readings.search import Outcome


def searches(cases: Collection[str]) -> tuple[ReadingsTried, ...]:
    """Searches for other meanings of printed numbers of the given cases.

    Numbers for which no formula exists are included. The result is empty if none of the cases has
    such a number.
    """
    found = tuple(record(p, p.search()) for p in PROBLEMS if p.case in cases)
    return (*found, *map(_missing, WITHOUT_FORMULA)) if found else ()


def record(problem: Problem, outcome: Outcome) -> ReadingsTried:
    """Record of one search for a report."""
    best, plain = outcome.best, outcome.as_it_stands
    if outcome.met:
        best = None
    return ReadingsTried(
        reference=problem.reference, place=problem.place, printed=problem.printed,
        unit=problem.printed_unit, what=problem.what,
        as_it_stands=None if plain is None else plain.value, met=outcome.met, tried=outcome.tried,
        hits=len(outcome.hits), readings=best.readings if best else (),
        value=best.value if best else None, chance=outcome.accidental,
        is_evidence=best is not None and outcome.is_evidence, errata=problem.errata,
    )  # fmt: skip


def _missing(reference: str) -> ReadingsTried:
    entry = published(reference)
    return ReadingsTried(
        reference=reference, place=entry.place, printed=entry.printed, unit=entry.unit,
        missing=WITHOUT_FORMULA[reference],
    )  # fmt: skip

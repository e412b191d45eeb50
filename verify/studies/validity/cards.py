"""Validity cards of a run: measured ranges of each formula, with the result of its row."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from verify.core.case import Case
from verify.core.results import CaseResult, Kind, Row, Validity, ValidityCard, ValidityExact
from verify.judging.judge import expanded
from verify.studies.sweep.outcome import Course
from verify.studies.sweep.pairs import Pair, pairs
from verify.studies.sweep.plan import Plan
from verify.studies.validity import messages as words
from verify.studies.validity.equations import place, tex
from verify.studies.validity.left_out import LEFT_OUT, MAPS, SUBJECTS
from verify.studies.validity.regions import region
from verify.studies.validity.store import Measured, measured

ALIKE = 1e-9  # relative to the largest error: round-off of an input without effect
STALE = "range of validity not computed for the present code: run `freewheel deep validity:{}`"


def of_result(case: Case, result: CaseResult) -> Validity | None:
    """Validity cards of a case; None if the case compares no formula with finite elements."""
    return of_case(case, result) if pairs(case) else None


def of_case(case: Case, result: CaseResult) -> Validity:
    """Validity cards of a case, from its stored record."""
    head = Validity(
        case=case.id, title=case.title,
        subject=SUBJECTS.get(case.id.partition("-")[0], "Other subjects"),
        maps=MAPS.get(case.id, ()),
    )  # fmt: skip
    every = pairs(case)
    found = measured(case) if case.scans else None
    if found is None:
        missing = STALE.format(case.id) if case.scans else LEFT_OUT.get(case.id, "")
        return replace(head, missing=missing, others=_names(every))
    courses = [(plan, course) for plan, kept in found.scans for course in kept]
    swept = {course.pair.name for _, course in courses}
    exact = [p for p in every if p.kind is Kind.IDENTITY and p.name in swept]
    return replace(
        head, date=found.date, missing=LEFT_OUT.get(case.id, ""),
        cards=tuple(
            _card(case, pair, result, [(p, c) for p, c in courses if c.pair == pair])
            for pair in every if pair.kind is not Kind.IDENTITY and pair.name in swept
        ),
        exact=tuple(_exact(p, [c for _, c in courses if c.pair == p]) for p in exact),
        over=_over(found, exact), others=_names([p for p in every if p.name not in swept]),
    )  # fmt: skip


def _card(
    case: Case, pair: Pair, result: CaseResult, courses: Sequence[tuple[Plan, Course]]
) -> ValidityCard:
    row = next((row for row in result.rows if row.quantity == pair.name), None)
    error, U = _at_paper(row)
    return ValidityCard(
        case=case.id, quantity=pair.name, symbol=pair.symbol, place=place(case, pair),
        tex=tex(case, pair, result.equations), error=error, U=U,
        regions=tuple(region(plan, course) for plan, course in courses),
    )  # fmt: skip


def _at_paper(row: Row | None) -> tuple[float | None, float | None]:
    """Relative error of the row and its expanded uncertainty; None for a value not solved."""
    if row is None or row.analytic is None or row.reference is None or not row.scale:
        return None, None
    error = (row.analytic - row.reference) / row.scale
    return error, None if row.u_num is None else expanded(row.u_num) / row.scale


def _exact(pair: Pair, courses: Sequence[Course]) -> ValidityExact:
    error, U = (
        np.concatenate([getattr(c, name) for c in courses]) for name in ("error", "U_error")
    )
    solved = np.isfinite(error)
    size = np.abs(np.where(solved, error, 0.0))
    largest = int(np.argmax(size >= (1 - ALIKE) * size.max())) if solved.any() else None
    return ValidityExact(
        quantity=pair.name, symbol=pair.symbol, points=len(error), unsolved=int((~solved).sum()),
        largest=None if largest is None else float(error[largest]),
        U=None if largest is None else float(U[largest]),
    )  # fmt: skip


def _over(found: Measured, exact: Sequence[Pair]) -> str:
    names = {pair.name for pair in exact}
    return "; ".join(dict.fromkeys(
        words.over(plan) for plan, kept in found.scans
        if names & {course.pair.name for course in kept}
    ))  # fmt: skip


def _names(left: Sequence[Pair]) -> tuple[str, ...]:
    return tuple(pair.name for pair in left)

"""Evidence for a verdict: errors of judged rows, and of the studies of the same comparisons."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from verify.cases.registry import find
from verify.core.differences import offset
from verify.core.results import Kind, Row, Status
from verify.studies.sweep.outcome import Course
from verify.studies.sweep.plan import Plan
from verify.studies.validity.store import measured
from verify.verdicts.rule import Point

Study = tuple[Plan, Course]
BESIDE = ": convergence"  # ends the name of the row that judges the meshes of another
COMPARING = (Kind.IDENTITY, Kind.APPROXIMATION, Kind.ASYMPTOTIC)  # rows that carry an error


class NoEvidenceError(ValueError):
    """A row that is required for a verdict failed, was not solved, or has no judged error."""


@dataclass(frozen=True)
class Evidence:
    """Rows with their errors at the paper's inputs, and studies of the same comparisons."""

    rows: tuple[Row, ...]
    studies: tuple[Study, ...]

    @property
    def points(self) -> tuple[Point, ...]:
        """All errors: those of the rows, then those of the solved points of the studies."""
        solved = (
            Point(float(e), float(U), is_paper=False)
            for _, course in self.studies
            for e, U in zip(course.error, course.U_error, strict=True)
            if np.isfinite(e) and np.isfinite(U)
        )
        return (*(point_of(row) for row in self.rows), *solved)

    @property
    def cases(self) -> tuple[str, ...]:
        """Ids of the cases of the rows."""
        return tuple(dict.fromkeys(row.case for row in self.rows))

    @property
    def unsolved(self) -> int:
        """Number of points without a result, summed over the studies of all rows."""
        return sum(
            int((~np.isfinite(course.error + course.U_error)).sum()) for _, course in self.studies
        )

    @property
    def is_studied(self) -> bool:
        """Whether every case was studied beyond its default inputs, with all points solved."""
        studied = {plan.case.id for plan, _ in self.studies if len(plan.points) > 1}
        return not self.unsolved and set(self.cases) <= studied


def evidence(ids: Sequence[str], rows: Mapping[str, Row]) -> Evidence:
    """Evidence from the rows with the given ids.

    Raises NoEvidenceError, which names the missing evidence.
    """
    found = tuple(_judged(row_id, rows) for row_id in ids)
    return Evidence(found, tuple(study for row in found for study in _studies(row)))


def point_of(row: Row) -> Point:
    """Relative error of a row with its expanded uncertainty.

    Raises NoEvidenceError if the row has no such error.
    """
    found = offset(row)
    if found is None or row.difference is None or not row.scale or row.tolerance is None:
        raise NoEvidenceError(
            f"{row.id} cannot be evidence: its error, or the uncertainty of its error, was not "
            "computed"
        )
    if not math.isfinite(found + row.tolerance):
        raise NoEvidenceError(f"{row.id} cannot be evidence: its error is not a finite number")
    return Point(found / row.scale, row.tolerance / row.scale)


def require(row_id: str, rows: Mapping[str, Row], *, may_be_note: bool = False) -> Row:
    """Row with the given id, if it passed, or if it has the status SHOWN and a measured error.

    With `may_be_note`, a row that states a contradiction in the paper (NOTE) is also accepted.
    Raises NoEvidenceError for any other row.
    """
    if row_id not in rows:
        raise NoEvidenceError(f"this run contains no row {row_id}")
    row = rows[row_id]
    stands = row.status is Status.PASS or (may_be_note and row.status is Status.NOTE)
    if not stands and not _is_measured(row, rows):
        raise NoEvidenceError(f"{row_id} cannot be evidence: it has the status {row.status.value}")
    return row


def _judged(row_id: str, rows: Mapping[str, Row]) -> Row:
    row = require(row_id, rows)
    if row.kind not in COMPARING:
        raise NoEvidenceError(
            f"{row_id} cannot be evidence: a row of the kind {row.kind.value} does not compare "
            "formula and reference"
        )
    point_of(row)
    return row


def _is_measured(row: Row, rows: Mapping[str, Row]) -> bool:
    """Whether the row measured a model error without an expected value, on converged meshes."""
    beside = rows.get(f"{row.id}{BESIDE}")
    converges = beside is not None and beside.status is Status.PASS
    return row.status is Status.SHOWN and row.kind is Kind.APPROXIMATION and converges


def _studies(row: Row) -> list[Study]:
    case = find(row.case)
    record = measured(case) if case.scans else None
    return [
        (plan, course)
        for plan, courses in (record.scans if record else ())
        for course in courses if course.pair.name == row.quantity
    ]  # fmt: skip


def joined(studies: Sequence[Study]) -> list[Study]:
    """The studies; those of one case at the same points become one with the larger errors."""
    found: dict[tuple[str, str], Study] = {}
    for plan, course in studies:
        key = (plan.case.id, str((plan.names, plan.points.tolist())))
        found[key] = (plan, _worse(found[key][1], course) if key in found else course)
    return list(found.values())


def _worse(one: Course, other: Course) -> Course:
    """Result with the larger error at each point; an unsolved point counts as largest."""
    size, next_size = (abs(c.error) + c.U_error for c in (one, other))
    takes_other = np.isnan(next_size) | (next_size > size)
    return replace(
        one,
        error=np.where(takes_other, other.error, one.error),
        U_error=np.where(takes_other, other.U_error, one.U_error),
        problems=tuple(
            b if t else a for a, b, t in zip(one.problems, other.problems, takes_other, strict=True)
        ),
    )

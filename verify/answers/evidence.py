"""Correction of an answer of the formulas by a simulation in time and by finite elements."""

import math
from collections.abc import Sequence
from dataclasses import replace

from verify.answers.answer import Answer
from verify.answers.console import number
from verify.core import units
from verify.core.references import FINITE_ELEMENTS, reference_name
from verify.core.results import FE, Row, Status
from verify.jobs.dynamic import DynamicResult

HOLDS = ("", "holds", "locks")
UNDECIDED = ("not followed",)
NOT_CONVERGED = "not converged"
SAME_VALUE = 1e-9  # relative; the design value in a row's unit


def with_dynamic(answer: Answer, dynamic: DynamicResult) -> Answer:
    """Answer corrected by the verdict of the simulation in time."""
    if dynamic.verdict in HOLDS:
        return answer
    reason = dynamic.first[0] if dynamic.first else f"{dynamic.what}: {dynamic.verdict}"
    if dynamic.verdict in UNDECIDED:
        return replace(answer, unknowns=(reason, *answer.unknowns))
    return replace(answer, failures=(reason, *answer.failures))


def with_rows(answer: Answer, rows: Sequence[Row]) -> Answer:
    """Answer after comparison with a reference: undecided if a row failed or was not run."""
    failed = [row for row in rows if row.status in (Status.FAIL, Status.SKIP)]
    if not failed:
        return answer
    more = f" and {len(failed) - 1} more" if len(failed) > 1 else ""
    if not_solved := why_not_solved(rows):
        reason = f"no value was compared because the reference was {not_solved}"
    else:
        reason = (
            f"the reference does not confirm the formulas: row {failed[0].quantity!r}{more} failed"
        )
    return replace(answer, unknowns=(reason, *answer.unknowns))


def why_not_solved(rows: Sequence[Row]) -> str:
    """Reason, such as "not converged ...", why the failed rows have no reference value.

    It is empty if no row failed, if a failed row has a reference value, or if no failed row has
    such a reason.
    """
    failed = [row for row in rows if row.status in (Status.FAIL, Status.SKIP)]
    if not failed or any(row.reference is not None for row in failed):
        return ""
    return next((row.reason for row in failed if row.reason.startswith(NOT_CONVERGED)), "")


def reference_of_design(answer: Answer, rows: Sequence[Row]) -> str:
    """Sentence that compares the design value with its reference; empty if this is not possible."""
    if answer.design is None:
        return ""
    value, unit = answer.design.value, answer.design.unit
    for row in rows:
        if row.analytic is None or not row.reference or not _is_same_quantity(row.unit, unit):
            continue
        factor = units.factor(row.unit)
        if math.isclose(row.analytic * factor, value, rel_tol=SAME_VALUE):
            by = reference_name(row)
            by = FINITE_ELEMENTS if by == FE else by
            other = number(row.reference * factor, unit)
            off = (row.analytic - row.reference) / row.reference
            return f"{by}: {other}; the formula differs by {100 * off:+.2f} %"
    return (
        "the design value itself has no reference; the rows below compare the quantities "
        "from which it is computed"
    )


def _is_same_quantity(unit: str, other: str) -> bool:
    return units.dimensions(unit) == units.dimensions(other)

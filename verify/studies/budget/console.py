"""Budgets of a run: measured causes of the differences of each case, and row tolerances."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from verify.core.results import (
    BudgetJoint,
    BudgetPart,
    CaseBudget,
    CaseResult,
    Kind,
    Row,
    RowBudget,
)
from verify.judging.judge import expanded
from verify.studies.budget import balance
from verify.studies.budget.found import RowBudget as Found
from verify.studies.budget.measuring import plan_of
from verify.studies.budget.messages import in_words
from verify.studies.budget.plan import Plan
from verify.studies.budget.store import measured

LARGE, LEFT = 1e-3, 0.25  # least difference to be explained, and the share that may remain
STALE = "error budget not computed for the present code: run `freewheel deep budget:{}`"


def of_result(result: CaseResult) -> CaseBudget | None:
    """Error budget of a case of the suite; None if none of its rows has a budget."""
    plan = plan_of(result.id)
    return of_case(plan, result) if plan.rows else None


def of_case(plan: Plan, result: CaseResult) -> CaseBudget:
    """Budgets of all rows of a case, from its stored record."""
    found = measured(plan)
    if found is None:
        return CaseBudget(
            case=plan.case.id, title=plan.case.title, missing=STALE.format(plan.case.id)
        )
    found = replace(found, rows=in_words(plan.case.id, found.rows))
    rows = {row.quantity: row for row in result.rows}
    drawn = headline(plan, found.rows)
    return CaseBudget(
        case=plan.case.id, title=plan.case.title, date=found.date, seconds=found.seconds,
        rows=tuple(
            _row(one, rows, plan.statement.reason(one.pair.name), headline=one.pair.name == drawn)
            for one in found.rows
        ),
    )  # fmt: skip


def headline(plan: Plan, rows: Sequence[Found]) -> str:
    """Name of the row whose budget is drawn; empty if there is none.

    This is the row named in the plan or, by default, the first approximation.
    """
    if plan.statement.headline:
        return plan.statement.headline
    first = (one for one in rows if one.pair.kind is Kind.APPROXIMATION)
    return next((one.pair.name for one in first), "")


def apart(known: balance.Balance) -> bool:
    """Whether the budget is complete: the total error is at most LARGE, or the remainder is small.

    The remainder is small if it is at most LEFT times the total error, or at most the expanded
    uncertainty of the remainder.
    """
    left = abs(known.remainder)
    return abs(known.total) <= LARGE or left <= max(
        LEFT * abs(known.total), balance.COVERAGE * known.u
    )


def _row(one: Found, rows: Mapping[str, Row], why: str, *, headline: bool) -> RowBudget:
    row, known = rows.get(one.pair.name), one.balance
    U = None if row is None or not row.scale else float(expanded(row.u_num or 0.0) / row.scale)
    allowed = row.tolerance / row.scale if row and row.scale and row.tolerance else U or 0.0
    explained = max(allowed, balance.COVERAGE * known.u)
    return RowBudget(
        quantity=one.pair.name, symbol=one.pair.symbol, kind=one.pair.kind, total=known.total, U=U,
        parts=tuple(_part(part) for part in known.parts),
        joints=tuple(
            BudgetJoint(causes=joint.names, value=joint.value, note=joint.note)
            for joint in one.joints
        ),
        remainder=known.remainder, u=known.u, headline=headline,
        apart=apart(known), why="" if apart(known) else why,
        within=bool(abs(known.remainder) <= explained) if one.pair.kind is Kind.IDENTITY else None,
    )  # fmt: skip


def _part(part: balance.Part) -> BudgetPart:
    cause, _, what = part.name.partition(": ")
    return BudgetPart(
        cause=cause, what=what, contribution=part.contribution, u=part.u, shared=part.shared,
        note=part.note,
    )  # fmt: skip

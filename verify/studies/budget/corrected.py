"""Budgets of rows whose formula itself causes an error and is replaced by a corrected formula.

First, the corrected formula replaces the formula of the row. Then all other causes are removed from
the remaining error. The remainder of the row is that of the corrected formula.
"""

import math
from dataclasses import replace

from verify.judging.budget_statement import Corrected
from verify.studies.budget import found
from verify.studies.budget.balance import Balance, Part
from verify.studies.budget.compared import values
from verify.studies.budget.found import RowBudget, Solutions
from verify.studies.budget.plan import AS_IT_IS, Plan, Step, inputs_of
from verify.studies.sweep.pairs import Pair


def budgets(plan: Plan, solutions: Solutions) -> tuple[RowBudget, ...]:
    """Budgets of all rows that have values of formula and finite elements on the finest mesh."""
    statement = {pair.name: plan.statement.correction(pair.name) for pair in plan.rows}
    twins = tuple(_twin(pair, statement[pair.name]) for pair in plan.rows)
    mine = {pair.name: pair for pair in plan.rows}
    return tuple(
        one if (by := statement[one.pair.name]) is None
        else _printed(mine[one.pair.name], one, by, plan, solutions)
        for one in found.budgets(replace(plan, rows=twins), solutions)
    )  # fmt: skip


def _twin(pair: Pair, by: Corrected | None) -> Pair:
    """The row with the corrected formula instead of the printed one; unchanged if `by` is None."""
    if by is None:
        return pair
    claim = replace(pair.claim, analytic=by.key)  # type: ignore[call-arg]
    return replace(pair, analytic=by.key, claim=claim)


def _printed(
    pair: Pair, twin: RowBudget, by: Corrected, plan: Plan, solutions: Solutions
) -> RowBudget:
    """Budget of a row: the correction `by`, then the contributions in the budget of its `twin`."""
    step = Step(plan.case.id, (AS_IT_IS,), plan.case.levels[-1])
    total = values(pair, inputs_of(plan, step), solutions[step]).error
    change = total - twin.balance.total
    part = Part(by.name, change if math.isfinite(change) else None, 0.0)
    left = twin.balance
    return replace(
        twin, pair=pair, balance=Balance(total, (part, *left.parts), left.remainder, left.u)
    )

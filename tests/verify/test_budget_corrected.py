"""Budgets of rows whose formula is itself a cause, and of what is not taken apart."""

from dataclasses import replace

import pytest

from tests.verify import budget_made as made
from verify.cases.registry import CASES
from verify.core.results import CaseResult
from verify.jobs import records
from verify.judging.budget_statement import Corrected, Left, Statement
from verify.studies.budget import store as kept
from verify.studies.budget.balance import Balance
from verify.studies.budget.console import apart, of_case
from verify.studies.budget.corrected import budgets
from verify.studies.budget.measuring import plan_of
from verify.studies.budget.plan import Plan, first, rows
from verify.studies.budget.solve import solved
from verify.studies.budget.store import measured

K, PRINTED = 100.0, 250.0
CORRECTED = Corrected("stiffness", "k corrected")


def formulas(_q):
    return {"k": PRINTED, "k corrected": K, "same": 7.0}


def budget(*corrected):
    """The stiffness' budget with a printed formula, and the plan."""
    case = replace(made.CASE, analytic=formulas)
    plan = Plan(case, replace(made.SAYS, corrected=corrected), rows(case))
    return next(
        one for one in budgets(plan, {step: solved(plan, step, None) for step in first(plan)})
        if one.pair.name == "stiffness"
    )  # fmt: skip


def test_the_printed_formula_is_a_part_and_the_rest_is_the_corrected_one_s():
    plan = made.plan()
    steps = {step: solved(plan, step, None) for step in first(plan)}
    right = budgets(plan, steps)[0].balance
    found = budget(CORRECTED).balance
    part, *others = found.parts
    fe = K / (1 + right.total)
    assert (part.name, part.u) == ("formula: as printed, beside the corrected one", 0.0)
    assert part.contribution == pytest.approx((PRINTED - K) / fe)
    assert found.total == pytest.approx(PRINTED / fe - 1)
    assert budget(CORRECTED).pair.analytic == "k"  # its own formula
    assert (tuple(others), found.remainder, found.u) == (right.parts, right.remainder, right.u)


@pytest.mark.parametrize(
    "by",
    [
        replace(CORRECTED, key="same"),
    ],
)
def test_another_correction_makes_it_stale(by, tmp_path, monkeypatch):
    monkeypatch.setattr(records, "FOLDER", tmp_path)
    plan = made.plan(replace(made.SAYS, corrected=(CORRECTED,)))
    kept.keep(plan, (), 12.34)
    assert kept.measured(plan).seconds == 12.3
    assert kept.measured(made.plan(replace(made.SAYS, corrected=(by,) if by else ()))) is None


@pytest.mark.parametrize(
    ("total", "left", "u", "known"),
    [
        (0.1, 0.026, 0.0, False),
        (0.1, 0.024, 0.0, True),
        (0.1, 0.05, 0.026, True),
        (9e-4, 9e-4, 0.0, True),
    ],
)  # fmt: skip
def test_what_is_large_is_taken_apart_or_not(total, left, u, known):
    assert apart(Balance(total, (), left, u)) is known


def test_corrections_are_of_rows_and_values_that_there_are():
    for case in CASES:
        plan = plan_of(case.id)
        names = {pair.name: pair for pair in plan.rows}
        values = case.analytic(case.inputs()) if plan.says.corrected else {}
        for one in plan.says.corrected:
            assert one.key in values
            assert one.key != names[one.row].analytic, one.row


def test_every_reason_is_needed_and_every_row_that_is_not_taken_apart_has_one():
    for case in CASES:
        plan = plan_of(case.id)
        found = measured(plan)
        if found is None:  # not measured for this code
            continue
        names = [one.pair.name for one in found.rows if not apart(one.balance)]
        assert [name for name in names if not plan.says.reason(name)] == []
        for left in plan.says.left:
            for pattern in left.rows:
                alone = Statement(left=(Left((pattern,), left.why),))
                assert any(alone.reason(name) for name in names), pattern


def test_the_reason_stands_where_much_is_left_and_there_alone(tmp_path, monkeypatch):
    monkeypatch.setattr(records, "FOLDER", tmp_path)
    plan = made.plan(replace(made.SAYS, left=(Left(("*",), "for a reason"),)))
    case = replace(made.CASE, analytic=formulas)
    wrong = Plan(case, plan.says, rows(case))
    steps = {step: solved(wrong, step, None) for step in first(wrong)}
    kept.keep(wrong, budgets(wrong, steps), 0.0)
    result = CaseResult(id=case.id, title="", paper="", place="", lead="", inputs=(), equations=(),
                        assumptions=(), readings=(), rows=())  # fmt: skip
    found = {row.quantity: (row.apart, row.why) for row in of_case(wrong, result).rows}
    assert found == {"stiffness": (False, "for a reason"), "the same": (True, "")}

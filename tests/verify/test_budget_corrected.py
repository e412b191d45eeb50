"""Budgets of rows whose formula is itself a cause, and the subjects of statements of cases."""

from dataclasses import replace

import pytest

from tests.verify import budget_made as made
from verify.cases.registry import CASES
from verify.jobs import records
from verify.judging.budget_statement import Corrected, Left, Statement
from verify.studies.budget import store as kept
from verify.studies.budget.balance import Balance
from verify.studies.budget.console import apart, of_case
from verify.studies.budget.corrected import budgets
from verify.studies.budget.measuring import plan_of
from verify.studies.budget.plan import Plan, first, inputs_of, rows
from verify.studies.budget.solve import solved
from verify.studies.budget.store import measured

K, PRINTED = 100.0, 250.0
CASE = replace(made.CASE, analytic=lambda _q: {"k": PRINTED, "k corrected": K, "same": 7.0})


def budgets_of(plan):
    return budgets(plan, {step: solved(plan, step, None) for step in first(plan)})


def test_the_printed_formula_is_a_part_and_the_rest_is_the_corrected_one_s():
    right = budgets_of(made.plan())[0].balance
    statement = replace(made.STATEMENT, corrected=(Corrected("stiffness", "k corrected"),))
    row = budgets_of(Plan(CASE, statement, rows(CASE)))[0]
    part, *others = row.balance.parts
    fe = K / (1 + right.total)
    assert (part.name, part.u) == ("formula: printed form instead of the corrected form", 0.0)
    assert part.contribution == pytest.approx((PRINTED - K) / fe)
    assert row.balance.total == pytest.approx(PRINTED / fe - 1)
    assert (row.pair.name, row.pair.analytic) == ("stiffness", "k")  # the formula of the row
    rest = (tuple(others), row.balance.remainder, row.balance.u)
    assert rest == (right.parts, right.remainder, right.u)


def test_what_is_large_is_decomposed_or_not():
    for total, left, u, known in (
        (0.1, 0.026, 0.0, False), (0.1, 0.024, 0.0, True), (0.1, 0.05, 0.026, True),
        (9e-4, 9e-4, 0.0, True),
    ):  # fmt: skip
        assert apart(Balance(total, (), left, u)) is known


def test_the_reason_stands_where_much_is_left_and_there_alone(tmp_path, monkeypatch):
    monkeypatch.setattr(records, "FOLDER", tmp_path)
    statement = replace(made.STATEMENT, left=(Left(("*",), "for a reason"),))
    wrong = Plan(CASE, statement, rows(CASE))
    kept.keep(wrong, budgets_of(wrong), 12.34)
    assert kept.measured(wrong).seconds == 12.3
    found = {row.quantity: (row.apart, row.why) for row in of_case(wrong, made.RESULT).rows}
    assert found == {"stiffness": (False, "for a reason"), "the same": (True, "")}


def check_statement(case, plan, names):
    """Reruns and corrections are about rows, levels and values that there are."""
    for rerun in plan.statement.reruns:
        assert any(rerun.about(name) for name in names), rerun.what
        plan.before(rerun)
    assert plan.statement.headline in ("", *names)
    assert plan.statement.finer == 0 or plan.statement.finer > case.levels[-1]
    for step in first(plan):
        inputs_of(plan, step)
    values = case.analytic(case.inputs()) if plan.statement.corrected else {}
    for one in plan.statement.corrected:
        assert one.key in values
        assert one.key != names[one.row].analytic, one.row


def check_reasons(plan, found):
    """Every row that is not decomposed has a reason, and every reason such a row."""
    names = [one.pair.name for one in found.rows if not apart(one.balance)]
    assert [name for name in names if not plan.statement.reason(name)] == []
    for left in plan.statement.left:
        for pattern in left.rows:
            alone = Statement(left=(Left((pattern,), left.why),))
            assert any(alone.reason(name) for name in names), pattern


def check_reruns(found):
    """No cause is without a contribution because of an error in the suite."""
    notes = {part.note for one in found.rows for part in one.balance.parts}
    assert [note for note in notes if "Error:" in note] == []


@pytest.mark.slow("the rows of all cases")
def test_statements_of_all_cases_are_about_what_there_is():
    for case in CASES:
        plan = plan_of(case.id)
        names = {pair.name: pair for pair in plan.rows}
        check_statement(case, plan, names)
        if found := measured(plan):  # for this code
            check_reasons(plan, found)
            check_reruns(found)

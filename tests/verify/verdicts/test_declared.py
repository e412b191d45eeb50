"""Declarations: complete, of rows that exist, and of the safe side that the cases state."""

import pytest

from verify.app.explain import row_ids
from verify.cases.registry import find
from verify.core.verdicts import Form, Safe
from verify.papers.ledger import papers
from verify.papers.numbers import numbers
from verify.verdicts.declared import declared

SIDES = {Safe.ABOVE: "too high", Safe.BELOW: "too low"}
FORMULAS = [(key, f) for key, each in declared().items() for f in each.formulas]
CASES = sorted({row.partition("/")[0] for _, f in FORMULAS for row in f.rows})


@pytest.mark.parametrize("paper", papers(), ids=lambda p: p.key)
def test_each_erratum_about_an_equation_is_declared_there(paper):
    """As one that changes its number, or as notation: none is dropped."""
    for erratum in paper.errata:
        for number in numbers(erratum.place):
            forms = declared()[paper.key].of(number)
            listed = [e for f in forms for e in f.errata + f.notation]
            assert erratum.id in listed, (paper.key, number)


def compared(case_id):
    """Key of the formula's value that each row of a case compares, by the row's id."""
    case = find(case_id)
    return {f"{case_id}/{check.name}": getattr(check, "analytic", "")
            for check in case.checks if hasattr(check, "name")}  # fmt: skip


@pytest.mark.slow("formulas of many cases are evaluated to name their rows")
@pytest.mark.parametrize("case_id", CASES)
def test_rows_exist_and_agree_with_their_case_on_form_and_safe_side(case_id):
    case = find(case_id)
    known = set(row_ids(case, case.inputs(), paper=True))
    keys = compared(case_id)
    quantities = {q.name: q for q in case.inputs.quantities()}
    for _, f in FORMULAS:
        for row in (r for r in f.rows if r.startswith(f"{case_id}/")):
            assert row in known
            quantity = quantities.get(keys.get(row, ""))
            if quantity is None:
                continue
            if quantity.safe and f.safe is not Safe.NEITHER:
                assert quantity.safe == SIDES[f.safe], (f.name, f.form, row)
            if quantity.form == "as printed":
                assert f.form is Form.PRINTED, (f.name, row)

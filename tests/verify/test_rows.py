"""Every row of every case is as its claim has it."""

import pytest

from verify.cases.registry import CASES, find
from verify.core.case import Context
from verify.core.results import Status


def rows_of(case):
    """Names of all rows, known without any finite elements."""
    context = Context(case.id, case.inputs(), case.analytic(case.inputs()), (), is_paper=True)
    for check in case.checks:
        found = check.skipped(case.id, "") if check.needs_fem else check.rows(context)
        yield from (row.quantity for row in found)


@pytest.mark.parametrize("case_id", CASES.ids)
def test_no_row_is_red_and_each_is_known_beforehand(case_id, of_paper):
    case = find(case_id)
    rows = of_paper(case).rows
    red = {row.quantity: row.reason for row in rows if row.status in (Status.FAIL, Status.SKIP)}
    assert not red
    names = [row.quantity for row in rows]
    assert names == list(rows_of(case))
    assert len(set(names)) == len(names)


def test_a_full_run_compares_printed_numbers_only_with_the_paper_s_inputs(judged):
    case = find("spring-accordion")
    own = case.inputs(n=12)
    assert not [row for row in judged(case, own).rows if row.published]

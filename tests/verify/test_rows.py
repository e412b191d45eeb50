"""Every row of every quick case is a test of its own."""

import pytest

from verify.cases.registry import CASES
from verify.core.case import Context
from verify.core.results import Status


def rows_of(case):
    """Names of all rows, known without any finite elements."""
    context = Context(case.id, case.inputs(), case.analytic(case.inputs()), (), is_paper=True)
    for check in case.checks:
        found = check.skipped(case.id, "") if check.needs_fem else check.rows(context)
        yield from (row.quantity for row in found)


ROWS = [
    pytest.param(case, name, id=f"{case.id}: {name}", marks=pytest.mark.xdist_group(case.id))
    for case in CASES
    if case.quick
    for name in rows_of(case)
]


@pytest.mark.parametrize(("case", "name"), ROWS)
def test_row_is_not_red(case, name, of_paper):
    (row,) = [row for row in of_paper(case).rows if row.quantity == name]
    assert row.status not in (Status.FAIL, Status.SKIP), row.reason


@pytest.mark.parametrize(
    "case", [pytest.param(c, id=c.id, marks=pytest.mark.xdist_group(c.id)) for c in CASES]
)
def test_no_row_is_unknown_beforehand(case, of_paper):
    names = [row.quantity for row in of_paper(case).rows]
    assert names == list(rows_of(case))
    assert len(set(names)) == len(names)


def test_a_full_run_compares_printed_numbers_only_with_the_paper_s_inputs(judged):
    case = next(c for c in CASES if c.id == "spring-accordion")
    own = case.inputs(n=12)
    assert not [row for row in judged(case, own).rows if row.published]

"""Rows of a case at the inputs of the paper, with stored or changed levels."""

from dataclasses import replace

from tests.conftest import solved
from verify.core.case import Context
from verify.core.results import Status


def context(case, values=None, arrays=None):
    """What the checks of a case read; values and arrays of the finest level may be others."""
    q = case.inputs()
    levels = [level.result for level in solved(case, q)]
    finest = levels[-1]
    levels[-1] = replace(
        finest, values=finest.values | (values or {}), arrays=finest.arrays | (arrays or {})
    )
    return Context(case.id, q, case.analytic(q), levels, is_paper=True)


def rows(case, name="", of=None):
    """Rows of the checks whose name begins so."""
    of = of or context(case)
    return [row for check in case.checks if check.name.startswith(name) for row in check.rows(of)]


def failed(case, name="", of=None):
    """The quantities of those rows that fail."""
    return {row.quantity for row in rows(case, name, of) if row.status is Status.FAIL}

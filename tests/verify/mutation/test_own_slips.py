"""No approximation is held to an interval that moves along with its own formula.

The formula's value slips by the row's demand, at the middle of what is expected and with finite
elements that know everything: the row must turn red, whatever its interval makes of the value.
"""

from verify.cases.registry import CASES
from verify.core.results import Status
from verify.judging import judge
from verify.judging.checks import Approximation


def hiding(case):
    """Rows that a slip of their own formula leaves in another state than red."""
    q, checks = case.inputs(), [c for c in case.checks if isinstance(c, Approximation)]
    values = case.analytic(q) if checks else {}
    for check in checks:
        value = values.get(check.analytic)
        if value is None or check.interval is None:  # taken from stored arrays, or shown
            continue
        if (expected := check.interval(q, values)) is None:
            continue
        for p in (check.demand, -check.demand):
            slipped = value * (1 + p)
            interval = check.interval(q, dict(values) | {check.analytic: slipped})
            verdict = judge.approximation(
                slipped, value / (1 + sum(expected) / 2), U=0.0, interval=interval,
                demand=check.demand,
            )  # fmt: skip
            if verdict.status is not Status.FAIL:
                yield check.name, p


def test_no_interval_moves_along_with_its_own_formula():
    assert {case.id: found for case in CASES if (found := list(hiding(case)))} == {}

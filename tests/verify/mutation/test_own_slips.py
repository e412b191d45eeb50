"""No interval of an approximation moves with the formula that it judges.

The value of the formula changes by the required sensitivity, from the middle of its interval and
with exact finite elements: the row must fail, whatever its interval derives from the value.
"""

from verify.cases.registry import CASES
from verify.core.results import Status
from verify.judging import judge
from verify.judging.checks import Approximation


def hiding(case):
    """Rows that do not fail under a change of their formula."""
    q, checks = case.inputs(), [c for c in case.checks if isinstance(c, Approximation)]
    values = case.analytic(q) if checks else {}
    for check in checks:
        value = values.get(check.analytic)
        if value is None or check.interval is None:  # taken from stored arrays, or SHOWN
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


def test_no_interval_moves_with_its_formula():
    assert {case.id: found for case in CASES if (found := list(hiding(case)))} == {}

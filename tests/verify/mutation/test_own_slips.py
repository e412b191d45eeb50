"""No approximation is held to an interval that moves along with its own formula.

The formula's value slips by the row's demand, at the middle of what is expected and with finite
elements that know everything: the row must turn red, whatever its interval makes of the value.
"""

from verify.cases.registry import CASES
from verify.core.case import Case
from verify.core.results import Status
from verify.judging import judge
from verify.judging.checks import Approximation


def hiding(case: Case) -> dict[str, Status]:
    """Rows that a slip of their own formula leaves in another state than red."""
    q, checks = case.inputs(), [c for c in case.checks if isinstance(c, Approximation)]
    values = case.analytic(q) if checks else {}
    found = {}
    for check in checks:
        key = check.analytic
        if key not in values or check.interval is None:  # taken from stored arrays, or shown
            continue
        value, expected = values[key], check.interval(q, values)
        if expected is None:
            continue
        reference = value / (1 + sum(expected) / 2)
        for p in (check.demand, -check.demand):
            slipped = dict(values) | {key: value * (1 + p)}
            verdict = judge.approximation(
                slipped[key], reference, U=0.0, interval=check.interval(q, slipped),
                demand=check.demand,
            )  # fmt: skip
            if verdict.status is not Status.FAIL:
                found[f"{check.name}, {p:+.1%}"] = verdict.status
    return found


def test_no_interval_moves_along_with_its_own_formula():
    assert {case.id: found for case in CASES if (found := hiding(case))} == {}

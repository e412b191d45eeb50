"""Run cases through the shared cache; every process computes what it misses once."""

from collections.abc import Callable
from functools import cache

import pytest

from verify.cache import default_folder
from verify.case import Case
from verify.inputs import Inputs
from verify.results import CaseResult, Row, Status
from verify.run import Job, judge_case, solve_level


@cache
def solved(case: Case, inputs: Inputs):
    return [solve_level(case, inputs, level, default_folder()) for level in case.levels]


@pytest.fixture(scope="session")
def judged() -> Callable[..., CaseResult]:
    """Judge a case on inputs (the paper's by default), with its finite elements from the cache."""

    def judge(case: Case, inputs: Inputs | None = None) -> CaseResult:
        q = case.inputs() if inputs is None else inputs
        return judge_case(Job(case, q), solved(case, q))

    return judge


@pytest.fixture(scope="session")
def red() -> Callable[[CaseResult], list[Row]]:
    """The rows of a result that failed."""
    return lambda result: [row for row in result.rows if row.status is Status.FAIL]

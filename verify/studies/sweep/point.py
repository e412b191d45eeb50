"""One point of a sweep: formulas and finite elements at one set of inputs, in any process.

The result contains, for every level, all numbers that any row compares. Therefore, no new solution
is necessary if different rows are selected or a rule of judging is changed.
"""

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from math import nan
from typing import Any

import numpy as np

from verify.core import source_code
from verify.core.case import Case, Portion
from verify.core.inputs import Inputs
from verify.jobs.guard import named, of_machine, unsolved
from verify.studies.sweep.pairs import LEVELS, whole


class OtherCodeError(RuntimeError):
    """The code of a worker process differs from the code of the client."""


@dataclass(frozen=True)
class Solution:
    """Result of a point: values [SI] by key; for finite elements, one value per level.

    The levels are in order from coarse to fine. `u_it` is the largest iteration uncertainty of all
    levels. `problem_formulas` and `problem_fe` state in one line why formulas or finite elements
    have no values. `lost` is True if the process ended unexpectedly or the machine failed.
    """

    formulas: Mapping[str, float]
    h: tuple[float, ...]
    fe: Mapping[str, tuple[float, ...]]
    u_it: Mapping[str, float]
    problem_formulas: str = ""
    problem_fe: str = ""
    seconds: float = 0.0
    lost: bool = False


@dataclass(frozen=True)
class Task:
    """A point to solve.

    `formulas` and `fe` state whether formulas and finite elements are to be computed; `code`
    contains the hashes of their sources.
    """

    number: int
    case: str
    portion: str
    inputs: Inputs
    formulas: bool
    fe: bool
    code: tuple[str, str]


def solve_batch(tasks: Sequence[Task]) -> list[Solution]:
    """Solutions of several points, solved one after the other.

    Raises OtherCodeError if the code of this process differs from that of the sweep.
    """
    return [solve_point(task) for task in tasks]


def solve_point(task: Task) -> Solution:
    """Solution of a point; an error in the computation is reported in the solution.

    Raises OtherCodeError if the code of this process differs from that of the sweep.
    """
    case, part = _known(task.case, task.portion)
    if code_of(case, part) != task.code:
        raise OtherCodeError(
            f"the code of {task.case} in this process differs from the code of the sweep"
        )
    start = time.perf_counter()
    found = Solution({}, (), {}, {})
    with np.errstate(all="ignore"):
        if task.formulas:
            found = _with_formulas(found, case, task.inputs)
        if task.fe:
            found = _with_fe(found, part, task.inputs)
    return replace(found, seconds=time.perf_counter() - start)


def code_of(case: Case, part: Portion) -> tuple[str, str]:
    """Hashes of the sources of the formulas and of the finite elements of a case."""
    return source_code.whole_source_of(case.analytic), source_code.source_of(part.fem)


@cache
def _known(case: str, portion: str) -> tuple[Case, Portion]:
    from verify.cases.registry import CASES, find  # a spawned process knows no cases yet

    found = find(case, CASES)
    return found, next(p for p in (*found.portions, whole(found)) if p.name == portion)


def _with_formulas(found: Solution, case: Case, inputs: Any) -> Solution:
    try:
        values = case.analytic(inputs)
        return replace(found, formulas={key: float(value) for key, value in values.items()})
    except Exception as error:  # any error concerns only this point
        problem = _message("formulas", error)
        return replace(found, problem_formulas=problem, lost=of_machine(error))


def _with_fe(found: Solution, part: Portion, inputs: Any) -> Solution:
    levels = []
    for level in part.levels[:LEVELS]:
        try:
            levels.append(part.fem(inputs, level))
        except Exception as error:  # gmsh raises Exception itself
            problem = _message(f"level {level}", error)
            return replace(found, problem_fe=problem, lost=of_machine(error))
    keys = dict.fromkeys(key for one in levels for key in one.values)
    return replace(
        found,
        h=tuple(float(one.h) for one in levels),
        fe={key: tuple(float(one.values.get(key, nan)) for one in levels) for key in keys},
        u_it={key: max(float(one.u_it.get(key, 0.0)) for one in levels) for key in keys},
    )


def _message(where: str, error: Exception) -> str:
    if unsolved(error):
        return f"not converged: {where}: {' '.join(str(error).split())}"
    return f"{where}: {named(error)}"

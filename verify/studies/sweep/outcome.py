"""A solved sweep as numbers to judge: per point and pair the error of the formula, and its bar."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from verify.core.figures import Array
from verify.jobs.guard import named
from verify.studies.sweep.pairs import Compared, Known, Pair, compared
from verify.studies.sweep.point import Solution
from verify.studies.sweep.run import Solved


@dataclass(frozen=True)
class Course:
    """One pair over all points of the plan, in its order.

    `formula`, `fe`, `U` [SI], `error` = (formula - FE)/scale and its expanded uncertainty
    `U_error` are (m,), NaN if there is none; `problems` give the reasons, "" if there is a value.
    """

    pair: Pair
    formula: Array
    fe: Array
    U: Array
    error: Array
    U_error: Array
    problems: tuple[str, ...]


@dataclass(frozen=True)
class Outcome:
    """A solved sweep and its results, one for each selected pair."""

    solved: Solved
    courses: tuple[Course, ...]

    @property
    def problems(self) -> tuple[str, ...]:
        """Reasons why points have no finite elements or no formulas, by point."""
        return tuple(one.problem_fe or one.problem_formulas for one in self.solved.solutions)


def outcome(solved: Solved) -> Outcome:
    """The courses of a solved sweep."""
    points = [
        Known(solved.plan.case.id, inputs, one.formulas, one.h, one.fe, one.u_it)
        for inputs, one in zip(solved.inputs, solved.solutions, strict=True)
    ]
    return Outcome(solved, tuple(_course(pair, solved, points) for pair in solved.plan.chosen))


def _course(pair: Pair, solved: Solved, points: Sequence[Known]) -> Course:
    found = [_compared(pair, *both) for both in zip(solved.solutions, points, strict=True)]
    return Course(
        pair=pair,
        formula=np.array([one.formula for one in found]),
        fe=np.array([one.fe for one in found]),
        U=np.array([one.U for one in found]),
        error=np.array([one.error for one in found]),
        U_error=np.array([one.U_error for one in found]),
        problems=tuple(one.problem for one in found),
    )


def _compared(pair: Pair, one: Solution, point: Known) -> Compared:
    if problem := one.problem_fe or one.problem_formulas:
        formula = one.formulas.get(pair.analytic, np.nan)
        return Compared(formula, np.nan, np.nan, np.nan, np.nan, problem)
    try:
        return compared(pair, point)
    except (ArithmeticError, LookupError, TypeError, ValueError) as error:
        return Compared(np.nan, np.nan, np.nan, np.nan, np.nan, named(error))

"""Results of a solved sweep: error of the formula and its uncertainty for each point and pair."""

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
    """Results of one compared pair at all points of the plan, in the order of the plan.

    `formula`, `fe` and its expanded uncertainty `U` [SI] have the shape (m,). `error` is (formula -
    FE)/scale, and `U_error` its expanded uncertainty. Values that do not exist are NaN. `problems`
    contains the reasons, "" if the values exist.
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
        """For each point, the reason why finite elements or formulas have no values; "" if none."""
        return tuple(one.problem_fe or one.problem_formulas for one in self.solved.solutions)


def outcome(solved: Solved) -> Outcome:
    """Results of a solved sweep for all selected pairs."""
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

"""A solved sweep as numbers to judge: per point and pair the error of the formula, and its bar."""

from dataclasses import dataclass

import numpy as np

from verify.shown import Array
from verify.sweep.pairs import Compared, Pair, compared
from verify.sweep.point import Solution
from verify.sweep.run import Solved


@dataclass(frozen=True)
class Course:
    """One pair over all points of the plan, in its order.

    `formula`, `fe`, `U` [SI], `error` = (formula - FE)/scale and its expanded uncertainty
    `U_error` are (m,), NaN where there is none; `problems` say why, "" where there is one.
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
    """A solved sweep and its courses, one for each pair that was chosen."""

    solved: Solved
    courses: tuple[Course, ...]

    @property
    def problems(self) -> tuple[str, ...]:
        """Why a point has no finite elements or no formulas, by point; "" for most."""
        return tuple(one.problem_fe or one.problem_formulas for one in self.solved.solutions)


def outcome(solved: Solved) -> Outcome:
    """The courses of a solved sweep."""
    chosen = solved.plan.chosen
    return Outcome(solved, tuple(_course(pair, solved.solutions) for pair in chosen))


def _course(pair: Pair, solutions: tuple[Solution, ...]) -> Course:
    found = [_compared(pair, one) for one in solutions]
    return Course(
        pair=pair,
        formula=np.array([one.formula for one in found]),
        fe=np.array([one.fe for one in found]),
        U=np.array([one.U for one in found]),
        error=np.array([one.error for one in found]),
        U_error=np.array([one.U_error for one in found]),
        problems=tuple(one.problem for one in found),
    )


def _compared(pair: Pair, one: Solution) -> Compared:
    if problem := one.problem_fe or one.problem_formulas:
        formula = one.formulas.get(pair.analytic, np.nan)
        return Compared(formula, np.nan, np.nan, np.nan, np.nan, problem)
    return compared(pair, one.formulas, one.h, one.fe, one.u_it)

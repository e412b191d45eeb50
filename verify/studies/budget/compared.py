"""Values that a row compares in one solution: formula, finite elements, and their scale."""

import math
from dataclasses import dataclass, replace
from typing import Any

from verify.core import units
from verify.core.case import Context, FemResult
from verify.judging.checks import Approximation
from verify.judging.claims import FemClaim, rows_of
from verify.studies.budget.solve import Solution
from verify.studies.sweep.pairs import Pair

ALIKE = (4.0, 2.0, 1.0)  # mesh sizes of one solution, if a claim needs three


@dataclass(frozen=True)
class Values:
    """Compared values and the divisor of their difference [SI]; missing values are NaN."""

    formula: float
    fe: float
    scale: float
    u_it: float = 0.0

    @property
    def error(self) -> float:
        """Error (formula - FE)/scale; NaN if there is no scale."""
        return (self.formula - self.fe) / self.scale if self.scale else math.nan


NONE = Values(math.nan, math.nan, math.nan)


def values(pair: Pair, inputs: Any, found: Solution) -> Values:
    """Compared values of a row in one solution.

    If the row compares quantities derived from the stored values, the claim computes the row, and
    the compared values are read from this row.
    """
    if found.problem:
        return NONE
    if not pair.plain:
        return _by_its_row(pair, inputs, found)
    formula, v = found.formulas.get(pair.analytic, math.nan), found.fe.get(pair.fem, math.nan)
    scale = abs(found.formulas.get(pair.scale, math.nan) if pair.scale else v)
    return Values(formula, v, scale, found.u_it.get(pair.fem, 0.0))


def _by_its_row(pair: Pair, inputs: Any, found: Solution) -> Values:
    levels = [FemResult(h=h * found.h, values=found.fe, u_it=found.u_it) for h in ALIKE]
    claim: FemClaim = pair.claim
    if isinstance(claim, Approximation):
        claim = replace(claim, interval=None)  # may cost more than the solution
    paper = inputs == type(inputs)()
    try:
        rows = rows_of(claim, Context("", inputs, found.formulas, levels, paper))
    except (LookupError, ValueError, ArithmeticError, TypeError):  # its data are not stored
        return NONE
    row = next((row for row in rows if row.levels and row.analytic is not None), None)
    if row is None or row.analytic is None or row.grid is None or not row.scale:
        return NONE
    f = units.factor(pair.unit)
    v = row.levels[-1][1]
    return Values(
        row.analytic * f, v * f, (row.scale if pair.scale else abs(v)) * f, row.grid.u_it * f
    )

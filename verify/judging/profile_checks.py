"""Checks of profiles and of errors over a parameter: L2 norm, coefficients, estimates."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from verify.core.case import Context
from verify.core.results import Kind, Row, Status
from verify.judging import judge
from verify.judging.checks import Approximation, Fact, Identity
from verify.judging.claims import Claim

Array = NDArray[np.float64]
Points = tuple[list[float], list[float], list[float]]  # parameter, error, its uncertainty


def l2_error(error: Array, norm: Array, weight: Array) -> float:
    """L2 norm of `error` (n,) divided by that of `norm` (n,); points have the weights (n,)."""
    return float(np.sqrt((error**2 @ weight) / (norm**2 @ weight)))


@dataclass(frozen=True, kw_only=True)
class ProfileError(Identity):
    """Check that the L2 error of a profile decreases at its theoretical order."""

    swept = False  # needs the pressures of every integration point

    errors: Callable[[Context], list[float]]

    def rows(self, context: Context) -> list[Row]:
        fem = [
            replace(result, values={**result.values, self.fem: error})
            for result, error in zip(context.fem, self.errors(context), strict=True)
        ]
        return super().rows(replace(context, fem=fem))


@dataclass(frozen=True, kw_only=True)
class Within(Fact):
    """Check that the error of a profile is within the accepted error `accepted`.

    `margin` is `accepted` minus the error.
    """

    accepted: float

    def rows(self, context: Context) -> list[Row]:
        error = self.accepted - self.margin(context)[0]
        words = f"{100 * error:.2f} %"
        return [replace(row, reason=f"{row.reason}: {words}") for row in super().rows(context)]


@dataclass(frozen=True, kw_only=True)
class Coefficient(Claim):
    """Check that d = c eps^2 + e eps^4 has the theoretical coefficient c.

    `points(context)` returns eps, d = formula/FE - 1 and the standard uncertainty of d.
    """

    kind = Kind.TREND

    points: Callable[[Context], Points]
    theory: float

    def rows(self, context: Context) -> list[Row]:
        eps, d, u = self.points(context)
        try:
            c, U = judge.quadratic_coefficient(eps, d, u)
        except ValueError as error:
            verdict = judge.Verdict(Status.FAIL, f"the coefficient cannot be computed: {error}")
            return [self._row(context.case, Kind.TREND, verdict, analytic=self.theory)]
        verdict = judge.difference(c, self.theory, U=U, scale=abs(self.theory), demand=self.demand)
        return [
            self._row(
                context.case, Kind.TREND, verdict, analytic=self.theory, fem=c,
                scale=abs(self.theory), u_num=U / judge.COVERAGE,
                levels=tuple(zip(eps, d, strict=True)), levels_u=tuple(u),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Estimated(Approximation):
    """Comparison of a model with the half-space.

    If, at user inputs, the allowed difference is not known beforehand, a row that would fail is
    SHOWN instead.
    """

    def rows(self, context: Context) -> list[Row]:
        rows = super().rows(context)
        judged = self.interval and self.interval(context.inputs, context.analytic)
        if context.is_paper or judged:
            return rows
        return [
            replace(row, status=Status.SHOWN, reason=f"cannot be judged: {row.reason}")
            if row.status is Status.FAIL
            else row
            for row in rows
        ]

"""Claims of the line contacts: profiles, and coefficients of what is neglected."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from verify.core.case import Context, FemResult
from verify.core.figures import Array
from verify.core.results import Kind, Row, Status
from verify.judging import judge
from verify.judging.checks import Fact, Identity
from verify.judging.claims import Claim
from verify.judging.convergence import grid_convergence

Points = tuple[list[float], list[float], list[float]]  # a/R, error of Hertz, its uncertainty

PROFILE = 0.03  # acceptance figure of q(x) in L2
BLUNT = 1e-3  # of Hertz's shear over the finite elements': smoothed stresses are no sharper
LIMITS = "acceptance figure of the contact models"


@dataclass(frozen=True, kw_only=True)
class ProfileError(Identity):
    """The L2 distance of a profile from the exact one vanishes with the mesh, as its order says."""

    swept = False  # needs the pressures of every integration point

    errors: Callable[[Context], list[float]]

    def rows(self, context: Context) -> list[Row]:
        fem = [
            replace(result, values={**result.values, self.fem: error})
            for result, error in zip(context.fem, self.errors(context), strict=True)
        ]
        return super().rows(replace(context, fem=fem))


def l2_errors(pressure: Callable[[Array], Array]) -> Callable[[Context], list[float]]:
    """Relative L2 errors of the finite-element pressure, per level, at its integration points."""

    def errors(context: Context) -> list[float]:
        found = []
        for result in context.fem:
            x, p, weight = (result.arrays[key] for key in ("x", "p", "weight"))
            exact = pressure(x)
            found.append(float(np.sqrt(((p - exact) ** 2 @ weight) / (exact**2 @ weight))))
        return found

    return errors


def relative_uncertainty(levels: Sequence[FemResult], key: str) -> float:
    """Standard uncertainty of the finest value over itself; infinite where it does not converge."""
    h, v = [r.h for r in levels], [r.values[key] for r in levels]
    u_it = max(r.u_it.get(key, 0.0) for r in levels)
    grid = grid_convergence(h, v, formal=2.0, scale=abs(v[-1]), u_it=u_it)
    return judge.numerical_uncertainty(grid, u_it) / abs(v[-1])


@dataclass(frozen=True, kw_only=True)
class Coefficient(Claim):
    """d = c eps^2 + e eps^4 with the c that theory gives (kind trend).

    `points(context)` gives eps, d = formula/FE - 1 and its standard uncertainty.
    """

    kind = Kind.TREND

    points: Callable[[Context], Points]
    theory: float

    def rows(self, context: Context) -> list[Row]:
        eps, d, u = self.points(context)
        try:
            c, U = judge.quadratic_coefficient(eps, d, u)
        except ValueError as error:
            verdict = judge.Verdict(Status.FAIL, f"no coefficient: {error}")
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
class NearHertz(Fact):
    """A pressure profile within the acceptance figure of Hertz's, and how near it is."""

    def rows(self, context: Context) -> list[Row]:
        error = PROFILE - self.margin(context)[0]
        return [replace(row, reason=f"{row.reason}: {error:.2%}") for row in super().rows(context)]

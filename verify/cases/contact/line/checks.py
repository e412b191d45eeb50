"""Claims of the line contacts: profiles, coefficients of what is neglected, balances."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from verify.cases.contact.line import figures as contact_line_shown
from verify.core.case import Context
from verify.core.figures import Array
from verify.core.results import Kind, Row, Status
from verify.judging import judge
from verify.judging.checks import Exact, Fact, Identity
from verify.judging.claims import Claim
from verify.judging.convergence import grid_convergence

Points = Callable[[Context], tuple[list[float], list[float], list[float]]]

FLOOR = 3e-4  # of Hertz/FE - 1: nothing sharper is claimed at one load
PROFILE = 0.03  # acceptance figure of q(x) in L2
SHARP = {"p0": 5e-4, "a": 1e-3, "approach": 1e-3}  # acceptance
LIMITS = "acceptance figure of the contact models"
ROUND = "direct solve; the load is met within 1e-12 of itself"

BALANCES = tuple(
    Exact(name=name, symbol=symbol, unit=unit, fem=key, scale=scale, bound=1e-8, bound_reason=ROUND)
    for name, symbol, unit, key, scale in (
        ("balance of forces across", "ΣF_x", "N/mm", "balance x", "P"),
        ("balance of forces along the load", "ΣF_y", "N/mm", "balance y", "P"),
        ("balance of moments", "ΣM", "N", "moment", "P R"),
    )
)


def about(
    m: float, unknown: float, *, least: float = FLOOR, demand: float = judge.DEMAND
) -> tuple[float, float] | None:
    """Interval m ± unknown, `least` at least; None where it says less than the row demands.

    There the bodies are too small for an estimate, and the formula's error is measured.
    """
    unknown = max(float(unknown), least)
    return (m - unknown, m + unknown) if unknown <= demand / 2 else None


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


def l2_errors(
    pressure: Callable[[Context, Array], Array],
) -> Callable[[Context], list[float]]:
    """Relative L2 errors of the finite-element pressure, per level, at its integration points."""

    def errors(context: Context) -> list[float]:
        found = []
        for result in context.fem:
            x, p, weight = (result.arrays[key] for key in ("x", "p", "weight"))
            exact = pressure(context, x)
            found.append(float(np.sqrt(((p - exact) ** 2 @ weight) / (exact**2 @ weight))))
        return found

    return errors


def relative_uncertainty(context: Context, key: str) -> float:
    """Standard uncertainty of the finest value over itself; infinite where it does not converge."""
    h, v = context.series(key)
    u_it = max(r.u_it.get(key, 0.0) for r in context.fem)
    grid = grid_convergence(h, v, formal=2.0, scale=abs(v[-1]), u_it=u_it)
    return judge.numerical_uncertainty(grid, u_it) / abs(v[-1])


@dataclass(frozen=True, kw_only=True)
class Coefficient(Claim):
    """d = c eps^2 + e eps^4 with the c that theory gives (kind trend).

    `points(context)` gives eps, d = formula/FE - 1 and its standard uncertainty.
    """

    kind = Kind.TREND

    points: Points
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


def hertz_profile() -> Fact:
    """The pressure profile is Hertz's within the acceptance figure."""

    def margin(context: Context) -> tuple[float, float]:
        errors = l2_errors(contact_line_shown.hertz_pressure)(context)
        return PROFILE - errors[-1], abs(errors[-1] - errors[-2])

    name = f"pressure profile within {PROFILE:.0%} of Hertz's in L2"
    return NearHertz(name=name, symbol="e_2", unit="1", margin=margin)

"""Kinds of comparisons of a formula with finite elements, each judged by `judge`."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from verify.core.case import Context
from verify.core.results import Kind, Row, Status
from verify.judging import judge
from verify.judging.claims import Claim, FemClaim
from verify.judging.convergence import fit_order


@dataclass(frozen=True, kw_only=True)
class Identity(FemClaim):
    """Comparison of a formula and finite elements that solve the same problem: |FE - formula| <= U.

    `residual` is the analytic key of the standard uncertainty of a truncated series, relative to
    the scale of the row.
    """

    kind = Kind.IDENTITY

    analytic: str
    residual: str = ""

    def rows(self, context: Context) -> list[Row]:
        r = context.analytic[self.analytic]
        scale = abs(context.analytic[self.scale]) if self.scale else abs(r)
        grid, u_num, u_it = self.convergence(context, scale)
        convergence = self.converges(context, grid, u_it, scale)
        u_ref = context.analytic[self.residual] * scale if self.residual else 0.0
        if not grid.converges:
            verdict = judge.Verdict(Status.FAIL, "does not converge")
        else:
            v, U = context.series(self.fem)[1][-1], judge.expanded(u_num, u_ref)
            verdict = judge.difference(v, r, U=U, scale=scale, demand=self.demanded(context))
        row = self._row(
            context.case, Kind.IDENTITY, verdict, analytic=r, scale=scale, scale_name=self.scale,
            u_ref=u_ref, u_input=0.0, **self.numbers(context, grid, u_num, u_it, scale),
        )  # fmt: skip
        return [row, convergence]


@dataclass(frozen=True, kw_only=True)
class Approximation(FemClaim):
    """Comparison of a formula that neglects an effect with finite elements that include it.

    The model error m = formula/FE - 1 must be in an interval derived beforehand. `interval(inputs,
    analytic values)` must not use the finite elements of the row; `source` is the source of the
    interval. Without an interval, the row is SHOWN.
    """

    kind = Kind.APPROXIMATION

    analytic: str
    interval: Callable[[Any, Any], tuple[float, float] | None] | None
    source: str

    def rows(self, context: Context) -> list[Row]:
        formula, v = context.analytic[self.analytic], context.series(self.fem)[1][-1]
        grid, u_num, u_it = self.convergence(context, abs(formula))
        convergence = self.converges(context, grid, u_it, abs(formula))
        limits = self.interval and self.interval(context.inputs, context.analytic)
        if not grid.converges:
            verdict = judge.Verdict(Status.FAIL, "does not converge")
        else:
            U = judge.expanded(u_num)
            verdict = judge.approximation(
                formula, v, U=U, interval=limits, demand=self.demanded(context)
            )
        row = self._row(
            context.case, Kind.APPROXIMATION, verdict, analytic=formula, scale=abs(v),
            interval=limits, interval_source=self.source,
            **self.numbers(context, grid, u_num, u_it, abs(formula)),
        )  # fmt: skip
        return [row, convergence]


@dataclass(frozen=True, kw_only=True)
class Order(Claim):
    """Check that errors relative to an exact value decrease with the theoretical order."""

    kind = Kind.TREND
    paper_only: bool = True  # of the elements, not of the formula

    errors: Callable[[Context], tuple[list[float], list[float]]]
    order: float

    def rows(self, context: Context) -> list[Row]:
        if not context.is_paper:
            return []
        try:
            h, e = self.errors(context)
            fit = fit_order(h, e)
        except ValueError as error:
            verdict = judge.Verdict(Status.FAIL, f"the order cannot be computed: {error}")
            return [self._row(context.case, Kind.TREND, verdict, analytic=self.order)]
        verdict = judge.difference(
            fit.order, self.order, U=judge.expanded(fit.u), scale=self.order, demand=self.demand
        )
        if verdict.difference is not None and abs(verdict.difference) > (verdict.tolerance or 0):
            reason = f"order {fit.order:.2f} ± {judge.expanded(fit.u):.1g}, theory {self.order:g}"
            verdict = replace(verdict, reason=reason)
        return [
            self._row(
                context.case, Kind.TREND, verdict, analytic=self.order, fem=fit.order,
                scale=self.order, u_num=fit.u, order=fit.order, formal_order=self.order,
                levels=tuple(zip(h, e, strict=True)),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Exact(Claim):
    """Check that a balance of finite elements holds to round-off: |residual| <= bound x scale."""

    kind = Kind.EXACT

    fem: str
    scale: str  # analytic key of the natural magnitude

    bound: float
    bound_reason: str

    def rows(self, context: Context) -> list[Row]:
        v = context.series(self.fem)[1][-1]
        scale = abs(context.analytic[self.scale])
        verdict = judge.exact(v, bound=self.bound, scale=scale, demand=self.demand)
        return [
            self._row(
                context.case, Kind.EXACT, verdict, fem=v, scale=scale, scale_name=self.scale,
                interval_source=self.bound_reason,
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Limit(Claim):
    """Check that the formula is exact for eps = 0: d = d0 + c eps^q with d0 = 0.

    `points(context)` returns eps, d = formula/FE - 1 and the standard uncertainty of d.
    """

    kind = Kind.ASYMPTOTIC

    points: Callable[[Context], tuple[list[float], list[float], list[float]]]
    exponent: float | None

    def rows(self, context: Context) -> list[Row]:
        eps, d, u = self.points(context)
        try:
            fit = judge.fit_limit(eps, d, u)
        except (ValueError, RuntimeError) as error:
            verdict = judge.Verdict(Status.FAIL, f"the limit cannot be computed: {error}")
            return [self._row(context.case, Kind.ASYMPTOTIC, verdict)]
        verdict = judge.asymptotic(fit, q=self.exponent, scale=1.0, demand=self.demand)
        return [
            self._row(
                context.case, Kind.ASYMPTOTIC, verdict, fem=fit.d0, analytic=0.0, scale=1.0,
                order=fit.q, formal_order=self.exponent, levels=tuple(zip(eps, d, strict=True)),
                levels_u=tuple(u),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Fact(Claim):
    """A statement that is true or false, judged by a margin.

    `margin(context)` returns the margin and its expanded uncertainty; the statement is true if the
    margin exceeds the uncertainty.
    """

    kind = Kind.FACT

    margin: Callable[[Context], tuple[float, float]]
    fem_needed: bool = True

    @property
    def needs_fem(self) -> bool:
        return self.fem_needed

    def rows(self, context: Context) -> list[Row]:
        margin, U = self.margin(context)
        verdict = judge.fact(margin, U)
        return [self._row(context.case, Kind.FACT, verdict, published=self._printed(context))]


Margin = Callable[[Context], tuple[float, float, str]]


@dataclass(frozen=True, kw_only=True)
class Accepted(Claim):
    """A statement with an acceptance limit that is valid for the paper's inputs only.

    At user inputs, the row is SHOWN. `margin` returns the margin of the error to the limit, the
    expanded uncertainty of the margin, and a text that states the error. A statement for fitted
    inputs is CALIBRATED; `fitted` names these inputs.
    """

    kind = Kind.FACT

    margin: Margin
    fem_needed: bool = True
    fitted: str = ""

    @property
    def needs_fem(self) -> bool:
        return self.fem_needed

    def rows(self, context: Context) -> list[Row]:
        margin, U, words = self.margin(context)
        verdict = judge.fact(margin, U)
        reason = f"{verdict.reason}: {words}"
        final = replace(verdict, reason=reason)
        if self.fitted and verdict.status is Status.PASS:
            final = replace(final, status=Status.CALIBRATED, reason=f"{reason}; {self.fitted}")
        if not context.is_paper:
            final = judge.Verdict(Status.SHOWN, words)
        return [self._row(context.case, Kind.FACT, final, published=self._printed(context))]

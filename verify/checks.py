"""The kinds of claims that cases make, each judged by `verify.judge`.

Keys name SI values of the analytic or finite-element side; rows carry display units.
"""

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from verify import judge, units
from verify.case import Context
from verify.convergence import GridConvergence, fit_order, grid_convergence
from verify.published.ledger import erratum, published
from verify.results import Kind, Partner, Published, Row, Status

NO_UNCERTAINTY = "scatter, supports and mesh are not stated: compared, not judged"


@dataclass(frozen=True, kw_only=True)
class Claim(ABC):
    """What all claims have. `printed` lists published values ("paper:id") shown beside the row."""

    kind: ClassVar[Kind]

    name: str
    symbol: str
    unit: str
    demand: float = judge.DEMAND
    demand_reason: str = ""
    printed: tuple[str, ...] = ()

    @property
    def needs_fem(self) -> bool:
        """Whether the claim compares with finite elements."""
        return True

    @abstractmethod
    def rows(self, context: Context) -> list[Row]:
        """Judge the claim."""

    def skipped(self, case: str, reason: str) -> list[Row]:
        """The rows that `rows` would give, not run."""
        return [self._row(case, self.kind, judge.Verdict(Status.SKIP, reason))]

    def _row(self, case: str, kind: Kind, verdict: judge.Verdict, **more: Any) -> Row:
        more = {"demand": self.demand, "demand_reason": self.demand_reason} | more
        return make_row(case, kind, verdict, self.name, self.symbol, self.unit, **more)

    def _printed(self, context: Context) -> tuple[Published, ...]:
        return tuple(beside(r, self.unit) for r in self.printed) if context.is_paper else ()


def make_row(
    case: str, kind: Kind, verdict: judge.Verdict, name: str, symbol: str, unit: str, **more: Any
) -> Row:
    """A row in the display unit from a verdict and further fields in SI."""
    f = units.factor(unit)
    dimensional = ("analytic", "fem", "scale", "u_num", "u_ref", "u_input")
    scaled = {k: v / f if k in dimensional and v is not None else v for k, v in more.items()}
    if partner := scaled.get("partner"):
        scaled["partner"] = Partner(by=partner.by, value=partner.value / f)
    return Row(
        case=case, quantity=name, symbol=symbol, unit=unit, kind=kind,
        status=verdict.status, reason=verdict.reason, detects=verdict.detects,
        difference=None if verdict.difference is None else verdict.difference / f,
        tolerance=None if verdict.tolerance is None else verdict.tolerance / f,
        **scaled,
    )  # fmt: skip


def beside(reference: str, unit: str) -> Published:
    """The printed value `reference` in `unit`."""
    value = published(reference)
    return Published(
        document=reference.partition(":")[0], id=value.id, place=value.place, kind=value.kind,
        printed=value.printed, unit=value.unit,
        value=value.value * units.factor(value.unit) / units.factor(unit),
    )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class FemClaim(Claim):
    """A claim about finite-element values `fem`, whose order in theory is `formal`."""

    fem: str
    formal: float | None = None
    scale: str = ""  # analytic key of the natural magnitude; the reference itself where empty

    def convergence(self, context: Context, scale: float) -> tuple[GridConvergence, float, float]:
        """Grid convergence, standard uncertainty u_num and u_it of the finest value [SI]."""
        h, v = context.series(self.fem)
        u_it = max(r.u_it.get(self.fem, 0.0) for r in context.fem)
        if not all(map(math.isfinite, v)):  # a level that did not converge is no number
            return GridConvergence("diverging", math.inf), math.inf, u_it
        grid = grid_convergence(h, v, formal=self.formal, scale=scale, u_it=u_it)
        return grid, judge.numerical_uncertainty(grid, u_it), u_it

    def skipped(self, case: str, reason: str) -> list[Row]:
        beside_it = self._convergence_row(case, judge.Verdict(Status.SKIP, reason))
        return [*super().skipped(case, reason), beside_it]

    def _convergence_row(self, case: str, verdict: judge.Verdict, **more: Any) -> Row:
        name = f"{self.name}: convergence"
        return make_row(case, Kind.FACT, verdict, name, "p", "1", **more)

    def converges(self, context: Context, grid: GridConvergence, u_it: float, scale: float) -> Row:
        """The row that convergence has to itself, beside agreement."""
        h, v = context.series(self.fem)
        if grid.behaviour == "monotone" and grid.order is not None:
            fine = abs(v[-1] - v[-2])
            noise = 4 * u_it / (fine * math.log(h[-2] / h[-1]))
            verdict = judge.fact(grid.order - 0.5, noise)
            reason = f"order {grid.order:.2f}, above 0.5"
        elif grid.behaviour == "round-off":
            verdict, reason = judge.fact(1.0, 0.0), "the last differences are round-off"
        else:
            margin = 1 - grid.gci / (self.demanded(context) * scale)
            verdict = judge.fact(margin, 0.0)
            reason = f"{grid.behaviour}: spread of the last three values against the demand"
        if not grid.converges:
            verdict, reason = judge.Verdict(Status.FAIL), "does not converge"
        if verdict.status is Status.FAIL and verdict.reason:
            reason = f"{verdict.reason}; {reason}"
        return self._convergence_row(
            context.case,
            replace(verdict, reason=reason),
            analytic=self.formal,
            fem=grid.order,
            formal_order=self.formal,
        )

    def demanded(self, context: Context) -> float:
        """The acceptance figure for the paper's numbers, the suite's default for one's own."""
        return self.demand if context.is_paper else max(self.demand, judge.DEMAND)

    def numbers(self, context: Context, grid: GridConvergence, u_num: float) -> dict[str, Any]:
        """What every finite-element row records."""
        f = units.factor(self.unit)
        h, v = context.series(self.fem)
        return {
            "fem": v[-1], "u_num": u_num, "formal_order": self.formal,
            "order": grid.behaviour if grid.behaviour == "round-off" else grid.order,
            "levels": tuple((a, b / f) for a, b in zip(h, v, strict=True)),
            "published": self._printed(context),
            "demand": self.demanded(context),
        }  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Identity(FemClaim):
    """Formula and finite elements solve the same problem: |FE - formula| <= U."""

    kind = Kind.IDENTITY

    analytic: str

    def rows(self, context: Context) -> list[Row]:
        r = context.analytic[self.analytic]
        scale = abs(context.analytic[self.scale]) if self.scale else abs(r)
        grid, u_num, u_it = self.convergence(context, scale)
        convergence = self.converges(context, grid, u_it, scale)
        if not grid.converges:
            verdict = judge.Verdict(Status.FAIL, "does not converge")
        else:
            v, U = context.series(self.fem)[1][-1], judge.expanded(u_num)
            verdict = judge.difference(v, r, U=U, scale=scale, demand=self.demanded(context))
        row = self._row(
            context.case, Kind.IDENTITY, verdict, analytic=r, scale=scale, scale_name=self.scale,
            u_ref=0.0, u_input=0.0, **self.numbers(context, grid, u_num),
        )  # fmt: skip
        return [row, convergence]


@dataclass(frozen=True, kw_only=True)
class Approximation(FemClaim):
    """A formula that neglects something: m = formula/FE - 1 in an interval known beforehand.

    `interval(inputs, analytic values)` must not look at these finite elements; `source` says
    where it comes from. Without an interval the row is SHOWN.
    """

    kind = Kind.APPROXIMATION

    analytic: str
    interval: Callable[[Any, Any], tuple[float, float] | None] | None
    source: str

    def rows(self, context: Context) -> list[Row]:
        formula = context.analytic[self.analytic]
        grid, u_num, u_it = self.convergence(context, abs(formula))
        convergence = self.converges(context, grid, u_it, abs(formula))
        limits = self.interval and self.interval(context.inputs, context.analytic)
        if not grid.converges:
            verdict = judge.Verdict(Status.FAIL, "does not converge")
        else:
            v, U = context.series(self.fem)[1][-1], judge.expanded(u_num)
            verdict = judge.approximation(
                formula, v, U=U, interval=limits, demand=self.demanded(context)
            )
        row = self._row(
            context.case, Kind.APPROXIMATION, verdict, analytic=formula, scale=abs(formula),
            interval=limits, interval_source=self.source, **self.numbers(context, grid, u_num),
        )  # fmt: skip
        return [row, convergence]


@dataclass(frozen=True, kw_only=True)
class PrintedTheory(Claim):
    """The formula against the number that the paper computed from it: the last digit decides."""

    kind = Kind.IDENTITY

    analytic: str
    reference: str

    @property
    def needs_fem(self) -> bool:
        return False

    def rows(self, context: Context) -> list[Row]:
        if not context.is_paper:
            return []
        v, entry = context.analytic[self.analytic], published(self.reference)
        f = units.factor(entry.unit)
        r, u = entry.value * f, entry.standard_uncertainty
        shown = {"analytic": v, "published": (beside(self.reference, self.unit),)}
        if u is None:
            verdict = judge.Verdict(Status.SHOWN, "printed as approximate", v - r)
            return [self._row(context.case, Kind.APPROXIMATION, verdict, scale=abs(r), **shown)]
        verdict = judge.difference(
            v, r, U=judge.expanded(0.0, u * f), scale=abs(r), demand=self.demand
        )
        partner = Partner(by=f"printed {entry.printed}", value=r)
        return [
            self._row(
                context.case, Kind.IDENTITY, verdict, scale=abs(r), u_num=0.0, u_ref=u * f,
                u_input=0.0, partner=partner, **shown,
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class PrintedMeasurement(Claim):
    """A test or a commercial finite-element value without stated uncertainty: SHOWN."""

    kind = Kind.APPROXIMATION

    analytic: str
    reference: str

    @property
    def needs_fem(self) -> bool:
        return False

    def rows(self, context: Context) -> list[Row]:
        if not context.is_paper:
            return []
        v, entry = context.analytic[self.analytic], published(self.reference)
        r = entry.value * units.factor(entry.unit)
        verdict = judge.Verdict(Status.SHOWN, f"formula {v / r - 1:+.1%}: {NO_UNCERTAINTY}", v - r)
        return [
            self._row(
                context.case, Kind.APPROXIMATION, verdict, analytic=v, scale=abs(r),
                partner=Partner(by=f"printed {entry.kind} {entry.printed}", value=r),
                published=(beside(self.reference, self.unit),),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Order(Claim):
    """Errors against an exact value fall with the order that theory gives (kind trend)."""

    kind = Kind.TREND

    errors: Callable[[Context], tuple[list[float], list[float]]]
    order: float

    def rows(self, context: Context) -> list[Row]:
        if not context.is_paper:  # speaks of the elements, not of the formula
            return []
        try:
            h, e = self.errors(context)
            fit = fit_order(h, e)
        except ValueError as error:
            verdict = judge.Verdict(Status.FAIL, f"no order: {error}")
            return [self._row(context.case, Kind.TREND, verdict, analytic=self.order)]
        verdict = judge.difference(
            fit.order, self.order, U=judge.expanded(fit.u), scale=self.order, demand=self.demand
        )
        return [
            self._row(
                context.case, Kind.TREND, verdict, analytic=self.order, fem=fit.order,
                scale=self.order, u_num=fit.u, order=fit.order, formal_order=self.order,
                levels=tuple(zip(h, e, strict=True)),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Exact(Claim):
    """A finite-element balance that holds to round-off: |residual| <= bound x scale."""

    kind = Kind.EXACT

    fem: str
    scale: str  # analytic key of the natural magnitude

    bound: float
    bound_reason: str

    def rows(self, context: Context) -> list[Row]:
        v = context.series(self.fem)[1][-1]
        scale = abs(context.analytic[self.scale])
        verdict = judge.exact(v, bound=self.bound, scale=scale)
        return [
            self._row(
                context.case, Kind.EXACT, verdict, fem=v, scale=scale, scale_name=self.scale,
                interval_source=self.bound_reason,
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Limit(Claim):
    """The formula becomes exact as eps goes to 0: d = d0 + c eps^q with d0 = 0 (asymptotic).

    `points(context)` gives eps, d = formula/FE - 1 and its standard uncertainty.
    """

    kind = Kind.ASYMPTOTIC

    points: Callable[[Context], tuple[list[float], list[float], list[float]]]
    exponent: float | None

    def rows(self, context: Context) -> list[Row]:
        eps, d, u = self.points(context)
        try:
            fit = judge.fit_limit(eps, d, u)
        except (ValueError, RuntimeError) as error:
            verdict = judge.Verdict(Status.FAIL, f"no limit: {error}")
            return [self._row(context.case, Kind.ASYMPTOTIC, verdict)]
        verdict = judge.asymptotic(fit, q=self.exponent, scale=1.0, demand=self.demand)
        return [
            self._row(
                context.case, Kind.ASYMPTOTIC, verdict, fem=fit.d0, analytic=0.0, scale=1.0,
                order=fit.q, formal_order=self.exponent, levels=tuple(zip(eps, d, strict=True)),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Fact(Claim):
    """A statement that holds or not: `margin(context)` and its expanded uncertainty."""

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


@dataclass(frozen=True, kw_only=True)
class Contradiction(Claim):
    """A printed number that the paper's own formulas contradict: NOTE, with its ledger entry.

    `analytic` must exceed the printed `reference` surely; where it does not, the ledger is wrong
    and the row fails. `erratum` names the entry ("paper:id").
    """

    kind = Kind.FACT

    analytic: str
    reference: str
    erratum: str

    @property
    def needs_fem(self) -> bool:
        return False

    def rows(self, context: Context) -> list[Row]:
        if not context.is_paper:
            return []
        entry, v = published(self.reference), context.analytic[self.analytic]
        f = units.factor(entry.unit)
        U = judge.expanded(0.0, (entry.standard_uncertainty or 0.0) * f)
        verdict = judge.fact(v - entry.value * f, U)
        if verdict.status is Status.PASS:
            why = erratum(self.erratum)
            verdict = replace(
                verdict, status=Status.NOTE, reason=f"ledger {self.erratum}: {why.right}"
            )
        else:
            verdict = replace(verdict, reason=f"ledger {self.erratum} says otherwise")
        partner = Partner(by=f"printed {entry.printed}", value=entry.value * f)
        return [
            self._row(
                context.case, Kind.FACT, verdict, analytic=v, scale=abs(entry.value * f),
                partner=partner, published=(beside(self.reference, self.unit),),
            )
        ]  # fmt: skip

"""Base classes of the claims of a case, and functions that make their rows and verdicts.

Keys refer to SI values of the formulas or of the finite elements; rows are in display units.
"""

import math
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from verify.core import units
from verify.core.case import Check, Context
from verify.core.results import Grid, Kind, Partner, Published, Row, Status
from verify.judging import judge
from verify.judging.convergence import (
    LEAST_ORDER,
    GridConvergence,
    grid_convergence,
    order_from_iteration,
)
from verify.papers.ledger import published

STATED = ("formula", "equation", "form", "safe", "shares")  # of the formula, in every row


@dataclass(frozen=True, kw_only=True)
class Claim(ABC):
    """Base class of all claims, each of which gives rows of the report.

    `printed` lists published values ("paper:id") that are displayed with the row. `formula` is the
    key of the judged value of the formulas, and `equation` the number or source of the equation.
    `form` is "as printed" or "corrected". `safe` is the safe side of the error, "too high" or
    "too low". `shares` states what formula and reference have in common besides the inputs.
    """

    kind: ClassVar[Kind]
    name: str
    symbol: str
    unit: str
    demand: float = judge.DEMAND
    demand_reason: str = ""
    printed: tuple[str, ...] = ()
    formula: str = ""
    equation: str = ""
    form: str = ""
    safe: str = ""
    shares: str = ""
    paper_only: bool = False  # applies only to the paper's inputs; user inputs have no such row

    @property
    def needs_fem(self) -> bool:
        """Whether the claim compares with finite elements."""
        return True

    @abstractmethod
    def rows(self, context: Context) -> list[Row]:
        """Rows of the judged claim."""

    def skipped(self, case: str, reason: str) -> list[Row]:
        """Rows of the claim with status SKIP, if nothing was run."""
        return [self._row(case, self.kind, judge.Verdict(Status.SKIP, reason))]

    def _row(self, case: str, kind: Kind, verdict: judge.Verdict, **more: Any) -> Row:
        own = {"demand": self.demand, "demand_reason": self.demand_reason}
        more = own | {name: getattr(self, name) for name in STATED} | more
        return make_row(case, kind, verdict, self.name, self.symbol, self.unit, **more)

    def _printed(self, context: Context) -> tuple[Published, ...]:
        return tuple(beside(r, self.unit) for r in self.printed) if context.is_paper else ()


def rows_of(check: Check, context: Context) -> list[Row]:
    """Rows of a check.

    Empty if the check applies to the paper's inputs only and the inputs differ.
    """
    return [] if check.paper_only and not context.is_paper else check.rows(context)


def make_row(
    case: str, kind: Kind, verdict: judge.Verdict, name: str, symbol: str, unit: str, **more: Any
) -> Row:
    """A row in display units, made from a verdict and further fields in SI units."""
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
    """The printed value with the key `reference`, converted to `unit`."""
    value = published(reference)
    return Published(
        document=reference.partition(":")[0], id=value.id, place=value.place, kind=value.kind,
        printed=value.printed, unit=value.unit,
        value=value.value * units.factor(value.unit) / units.factor(unit),
    )  # fmt: skip


def convergence_verdict(
    grid: GridConvergence, h: Sequence[float], v: Sequence[float], u_it: float, allowed: float
) -> judge.Verdict:
    """Verdict on the convergence of the values `v` on meshes of sizes `h`.

    The observed order must exceed 0.5 by more than the effect of iteration. Otherwise, the grid
    convergence index must be below `allowed`. If the error of iteration can move the order below
    0.5, the index is three times the spread of the values, so that the verdict is the same for
    orders just above and just below 0.5. `v`, `u_it` and `allowed` have the same unit.
    """
    if grid.behaviour == "monotone" and grid.order is not None:
        verdict = judge.fact(grid.order - LEAST_ORDER, order_from_iteration(h, v, u_it))
        reason = f"order {grid.order:.2f}, above 0.5"
        spread = max(v[-3:]) - min(v[-3:])
        if verdict.status is Status.FAIL and 3 * spread < allowed:
            verdict = judge.fact(1 - 3 * spread / allowed, 0.0)
            reason = (
                f"order {grid.order:.2f} ± u_it, not certainly above 0.5; instead, three "
                "times the spread of the last three values is compared with the limit"
            )
    elif grid.behaviour == "round-off":
        verdict, reason = judge.fact(1.0, 0.0), "the last differences are round-off"
    else:
        verdict = judge.fact(1 - grid.gci / allowed, 0.0)
        reason = (
            f"{grid.behaviour} series of values: the grid "
            "convergence index is compared with the limit"
        )
    if not grid.converges:
        verdict, reason = judge.Verdict(Status.FAIL), "does not converge"
    if verdict.status is Status.FAIL and verdict.reason:
        reason = f"{verdict.reason}; {reason}"
    return replace(verdict, reason=reason)


@dataclass(frozen=True, kw_only=True)
class FemClaim(Claim):
    """A claim about finite-element values with the key `fem`.

    `formal` is the theoretical order of convergence. `by` is the name of another method that gives
    these values and is refined like a mesh. A sweep includes the claim if it can be judged from
    values only (`swept`). At user inputs, the smallest relative error that must make the row fail
    is at least `own_demand`, for the reason `own_reason`.
    """

    swept: ClassVar[bool] = True

    fem: str
    by: str = ""
    formal: float | None = None
    scale: str = ""  # analytic key of the natural magnitude; if empty, the reference
    own_demand: float = judge.DEMAND
    own_reason: str = "the suite's default for user inputs"

    def convergence(self, context: Context, scale: float) -> tuple[GridConvergence, float, float]:
        """Grid convergence, u_num of the finest value, and the largest u_it of all levels [SI]."""
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
        """Convergence row of the comparison."""
        h, v = context.series(self.fem)
        verdict = convergence_verdict(grid, h, v, u_it, self.demanded(context) * scale)
        return self._convergence_row(
            context.case,
            verdict,
            analytic=self.formal,
            fem=grid.order,
            formal_order=self.formal,
            grid=self._recorded(context, grid, u_it, scale),
        )

    def demanded(self, context: Context) -> float:
        """Smallest relative error that must make the row fail.

        At user inputs, it is at least `own_demand`.
        """
        return self.demand if context.is_paper else max(self.demand, self.own_demand)

    def _recorded(self, context: Context, grid: GridConvergence, u_it: float, scale: float) -> Grid:
        """Grid convergence with all data from which it was judged, in the display unit."""
        f = units.factor(self.unit)
        h, v = context.series(self.fem)
        return Grid(
            unit=self.unit, levels=tuple((a, b / f) for a, b in zip(h, v, strict=True)),
            scale=scale / f, allowed=self.demanded(context) * scale / f, behaviour=grid.behaviour,
            gci=grid.gci / f, u_it=u_it / f, order=grid.order, formal=self.formal,
            used=grid.used, factor=grid.factor,
        )  # fmt: skip

    def numbers(
        self, context: Context, grid: GridConvergence, u_num: float, u_it: float, scale: float
    ) -> dict[str, Any]:
        """Fields of `Row` that are common to all comparisons with finite elements.

        `scale` is the scale of the convergence check [SI].
        """
        recorded = self._recorded(context, grid, u_it, scale)
        finest = context.series(self.fem)[1][-1]
        partner = Partner(by=self.by, value=finest) if self.by else None
        return {
            "fem": None if partner else finest, "partner": partner,
            "u_num": u_num, "formal_order": self.formal,
            "order": grid.behaviour if grid.behaviour == "round-off" else grid.order,
            "levels": recorded.levels, "grid": recorded,
            "published": self._printed(context),
            "demand": self.demanded(context),
            "demand_reason": self.demand_reason
            if self.demanded(context) == self.demand
            else self.own_reason,
        }  # fmt: skip

"""Kinds of claims about the ensemble: shares, spreads, exact, fitted and contradicted claims."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from verify.cases.rotor.sprag.assertions import Members, Statement, opposite
from verify.cases.rotor.sprag.layout import PARAMETERS
from verify.core import units
from verify.core.case import Context
from verify.core.figures import Array
from verify.core.results import Kind, Partner, Row, Status
from verify.judging import judge
from verify.judging.claims import Claim
from verify.papers.ledger import published

Arrays = Mapping[str, Array]
COARSE = 2e-4  # accepted error of the mesh with one beam element for each element of the paper
NO_SETS = "no set of parameters gives the three printed critical speeds"
FITTED = f"in each set, {len(PARAMETERS)} parameters were fitted to three critical speeds"


def arrays(context: Context) -> Arrays:
    """Arrays of the results on the paper's mesh, including those of the ensemble."""
    return context.fem[0].arrays


def band(values: Array, factor: float = 1.0, digits: int = 3) -> str:
    """Text with the median, 5th and 95th percentile of values over the members."""
    low, middle, high = (float(v) / factor for v in np.percentile(values, (5, 50, 95)))
    return f"{middle:.{digits}g} ({low:.{digits}g} to {high:.{digits}g})"


@dataclass(frozen=True, kw_only=True)
class Share(Claim):
    """Share of the sets of parameters in which a claim holds; the status is always CALIBRATED."""

    kind = Kind.FACT

    holds: Callable[[Context], Members]
    of: str = "sets"

    def asked(self, context: Context) -> Members:
        """Mask (m,) of the sets for which a claim is evaluated; here true for all sets."""
        return np.ones(self.holds(context).size, dtype=bool)

    def words(self, context: Context) -> str:
        held = self.holds(context)
        return f"this result is reached from {int(held.sum())} of the {held.size} {self.of}"

    def rows(self, context: Context) -> list[Row]:
        held, asked = self.holds(context), self.asked(context)
        if not held.size:
            verdict = judge.Verdict(Status.FAIL, NO_SETS)
        elif not asked.any():
            verdict = judge.Verdict(
                Status.SKIP, "no set of parameters has the peaks that the statement compares"
            )
        else:
            reason = f"{self.words(context)}; {FITTED}"
            verdict = judge.Verdict(Status.CALIBRATED, reason)
            share = Partner(by=f"share of {self.of}", value=float(held[asked].mean()))
            return [self._row(context.case, Kind.FACT, verdict, partner=share)]
        return [self._row(context.case, Kind.FACT, verdict)]


@dataclass(frozen=True, kw_only=True)
class Claimed(Share):
    """A statement of the paper, evaluated for the sets in which all compared peaks exist.

    The statement is also evaluated with opposite unbalances. The numbers that the paper prints in
    its statements are node numbers, not values of the response.
    """

    statement: Statement

    def asked(self, context: Context) -> Members:
        return self.statement.asked(arrays(context))

    def words(self, context: Context) -> str:
        a = arrays(context)
        other = held_of(self.statement, opposite(a))
        return (
            f"the statement holds in {held_of(self.statement, a)}; with opposite unbalances, in "
            f"{other}"
        )


def held_of(statement: Statement, a: Arrays) -> str:
    """Text: number of sets in which a statement holds, of the sets that have all compared peaks."""
    held, asked = statement.holds(a), statement.asked(a)
    with_peak = "" if asked.all() else " in which all compared peaks exist"
    return f"{int((held & asked).sum())} of the {int(asked.sum())} parameter sets{with_peak}"


@dataclass(frozen=True, kw_only=True)
class Spread(Claim):
    """Median, 5th and 95th percentile, over the members, of a value that is not printed."""

    kind = Kind.FACT

    values: Callable[[Context], Array]
    words: str = ""

    def rows(self, context: Context) -> list[Row]:
        values, f = self.values(context), units.factor(self.unit)
        if not values.size:
            verdict = judge.Verdict(Status.FAIL, NO_SETS)
            return [self._row(context.case, Kind.FACT, verdict)]
        spread = (
            f"median of all sets (5th to 95th percentile): {band(values, f)} {self.unit}"
        ).removesuffix(" 1")
        verdict = judge.Verdict(Status.CALIBRATED, f"{spread}{self.words}; {FITTED}")
        return [
            self._row(
                context.case, Kind.FACT, verdict,
                partner=Partner(by="median of sets", value=float(np.median(values))),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Rounded(Claim):
    """A property exact to round-off for each member: the largest residual is below `bound`."""

    kind = Kind.EXACT

    residual: Callable[[Context], float]
    bound: float
    bound_reason: str
    scale_name: str

    def rows(self, context: Context) -> list[Row]:
        v = self.residual(context)
        verdict = judge.exact(v, bound=self.bound, scale=1.0, demand=self.demand)
        return [
            self._row(
                context.case, Kind.EXACT, verdict, fem=v, scale=1.0, scale_name=self.scale_name,
                interval_source=self.bound_reason, published=self._printed(context),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class FittedTo(Claim):
    """A critical speed of the system fitted from mid-range parameters, and its printed value.

    The speed was fitted with the mesh of the paper; the formula is the exact model of the same
    system. The status is CALIBRATED if the formula differs from the printed value by at most 2e-4
    of that value, otherwise FAIL.
    """

    kind = Kind.APPROXIMATION
    paper_only: bool = True

    analytic: str

    @property
    def needs_fem(self) -> bool:
        return False

    def rows(self, context: Context) -> list[Row]:
        if not context.is_paper:
            return []
        v, entry = context.analytic[self.analytic], published(self.printed[0])
        r = entry.value * units.factor(entry.unit)
        status = Status.CALIBRATED if abs(v / r - 1) <= COARSE else Status.FAIL
        verdict = judge.Verdict(
            status,
            "the speed by transfer matrices differs from the printed speed by "
            f"{v / r - 1:+.1e} of the printed speed; {FITTED}",
            v - r,
        )
        return [
            self._row(
                context.case, Kind.APPROXIMATION, verdict, analytic=v, scale=abs(r),
                partner=Partner(by=f"printed {entry.printed}", value=r),
                published=self._printed(context),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Drawn(Claim):
    """Node numbers and unknowns per node of the model, compared with the printed ones."""

    kind = Kind.FACT

    margin: Callable[[Context], float]

    @property
    def needs_fem(self) -> bool:
        return False

    def rows(self, context: Context) -> list[Row]:
        verdict = judge.fact(self.margin(context), 0.0)
        verdict = replace(
            verdict, reason=f"{verdict.reason}; {len(self.printed)} printed numbers were compared"
        )
        return [self._row(context.case, Kind.FACT, verdict)]

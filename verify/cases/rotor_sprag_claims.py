"""Claims about the system with sprag clutch: identities, what is fitted, what follows in shares."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from verify import judge, units
from verify.case import Context
from verify.cases.rotor_sprag_facts import STATEMENTS, Members, Statement
from verify.cases.rotor_sprag_inputs import PRINTED
from verify.cases.rotor_sprag_layout import PARAMETERS
from verify.cases.rotor_sprag_model import MODES, ORDERS
from verify.checks import Accepted, Identity
from verify.claims import Claim
from verify.published.ledger import published
from verify.results import Kind, Partner, Row, Status
from verify.shown import Array

Arrays = Mapping[str, Array]
BEAMS = 5e-6  # acceptance figures of the beams against the exact model: 8 in each element,
COARSE = 2e-4  # and one
BARS = 1e-5  # the same for elements of torsion, whose twist is linear
WITHIN_PRINTED = 3e-3
FITTED = f"{len(PARAMETERS)} unknowns fitted to three speeds"


def arrays(context: Context) -> Arrays:
    """Those of the paper's own mesh, with the ensemble."""
    return context.fem[0].arrays


def band(values: Array, factor: float = 1.0, digits: int = 3) -> str:
    """Low (5 %), median and high (95 %) of members in words."""
    low, middle, high = (float(v) / factor for v in np.percentile(values, (5, 50, 95)))
    return f"{middle:.{digits}g} ({low:.{digits}g} to {high:.{digits}g})"


@dataclass(frozen=True, kw_only=True)
class Share(Claim):
    """In how many members a statement of the paper holds: CALIBRATED, whatever the share."""

    kind = Kind.FACT

    holds: Callable[[Arrays], Members]
    of: str = "members"

    def rows(self, context: Context) -> list[Row]:
        held = self.holds(arrays(context))
        if not held.size:
            verdict = judge.Verdict(Status.FAIL, "no member hits the three critical speeds")
            return [self._row(context.case, Kind.FACT, verdict)]
        said = f"holds in {int(held.sum())} of {held.size} {self.of}; {FITTED}"
        verdict = judge.Verdict(Status.CALIBRATED, said)
        return [
            self._row(
                context.case, Kind.FACT, verdict,
                partner=Partner(by=f"share of {self.of}", value=float(held.mean())),
                published=self._printed(context),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Spread(Claim):
    """The median over the members of what the paper does not print; its 5 to 95 % in words."""

    kind = Kind.FACT

    values: Callable[[Context], Array]
    words: str = ""

    def rows(self, context: Context) -> list[Row]:
        values, f = self.values(context), units.factor(self.unit)
        if not values.size:
            verdict = judge.Verdict(Status.FAIL, "no member hits the three critical speeds")
            return [self._row(context.case, Kind.FACT, verdict)]
        said = f"5 to 95 % of members: {band(values, f)} {self.unit}".removesuffix(" 1")
        verdict = judge.Verdict(Status.CALIBRATED, f"{said}{self.words}; {FITTED}")
        return [
            self._row(
                context.case, Kind.FACT, verdict,
                partner=Partner(by="median of members", value=float(np.median(values))),
                published=self._printed(context),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Rounded(Claim):
    """What every member must have to round-off: the largest `residual` over `bound`."""

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
    """A critical speed of the central system, fitted to the printed one: CALIBRATED within 2e-4.

    It was fitted on the paper's mesh; the formula is the exact model of the same system.
    """

    kind = Kind.APPROXIMATION
    paper_only: ClassVar[bool] = True

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
        verdict = judge.Verdict(status, f"exact model {v / r - 1:+.1e}; {FITTED}", v - r)
        return [
            self._row(
                context.case, Kind.APPROXIMATION, verdict, analytic=v, scale=abs(r),
                partner=Partner(by=f"printed {entry.printed}", value=r),
                published=self._printed(context),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Noted(Claim):
    """A printed statement that contradicts itself or linear dynamics: NOTE with its ledger entry.

    `margin` says how surely, and in words; where it does not, the ledger is wrong: FAIL.
    """

    kind = Kind.FACT
    paper_only: ClassVar[bool] = True

    erratum: str
    margin: Callable[[Context], tuple[float, str]]

    def rows(self, context: Context) -> list[Row]:
        if not context.is_paper:
            return []
        margin, words = self.margin(context)
        verdict = judge.fact(margin, 0.0)
        if verdict.status is Status.PASS:
            said = f"{words}; ledger {self.erratum}"
            verdict = replace(verdict, status=Status.NOTE, reason=said)
        else:
            verdict = replace(verdict, reason=f"ledger {self.erratum} says otherwise: {words}")
        return [self._row(context.case, Kind.FACT, verdict, published=self._printed(context))]


def largest_error(context: Context, level: int, keys: tuple[str, ...]) -> float:
    v = context.fem[level].values
    return max(abs(v[key] / context.analytic[key] - 1) for key in keys)


FREQUENCIES = tuple(f"natural frequency {i + 1}" for i in range(MODES))


def printed_bound(context: Context) -> tuple[float, float, str]:
    """The paper's own mesh against the exact model."""
    error = largest_error(context, 0, FREQUENCIES)
    return WITHIN_PRINTED - error, 0.0, f"20 elements err by {error:.1e} at most"


def coarse(context: Context) -> tuple[float, float, str]:
    error = largest_error(context, 0, (*FREQUENCIES, *(f"forward critical {k}" for k in ORDERS)))
    return COARSE - error, 0.0, f"at most {error:.1e}"


def identity(name: str, symbol: str, unit: str, key: str, demand: float = BEAMS) -> Identity:
    return Identity(
        name=name, symbol=symbol, unit=unit, fem=key, analytic=key, formal=2, demand=demand,
        demand_reason="acceptance figure of beams against transfer matrices, 8 in each element",
    )  # fmt: skip


def shares(statement: Statement) -> Share:
    return Share(
        name=statement.name, symbol=statement.symbol, unit="1", holds=statement.holds,
        printed=statement.printed,
    )  # fmt: skip


def hit(context: Context) -> float:
    speeds = arrays(context)["critical, forward"]
    return float(np.abs(speeds / np.array(PRINTED) - 1).max(initial=0.0))


IDENTITIES = (
    *(identity(f"natural frequency {i + 1}, beams", f"f_{i + 1}", "Hz", key)
      for i, key in enumerate(FREQUENCIES)),
    *(identity(f"{whirl} critical speed {k}, beams", f"n_{k}", "r/min", f"{whirl} critical {k}")
      for whirl in ("forward", "backward") for k in ORDERS),
    *(identity(f"amplitude of node {n} at the rig's speed, no damping", f"x_{n}", "µm",
               f"amplitude {n}") for n in (4, 19)),
    identity("torsional frequency of the clutch", "f_c", "Hz", "torsion, clutch"),
    identity("torsional frequency of the inner shaft", "f_t", "Hz", "torsion, shaft", BARS),
    Identity(name="coupling of bending and torsion by the offset", symbol="K_xz", unit="N",
             fem="coupling", analytic="coupling", demand=1e-9,
             demand_reason="the same sums on both sides"),
    Accepted(name="20 elements against the exact model, frequencies 1 to 6", symbol="Δf/f",
             unit="1", margin=printed_bound, fitted="on a fitted system",
             printed=("huang2022:frequency-deviation-bound", "huang2022:compared-frequencies")),
    Accepted(name="20 elements against the exact model within 2e-4", symbol="Δf/f", unit="1",
             margin=coarse),
)  # fmt: skip
FITTED_SPEEDS = (
    *(FittedTo(name=f"critical speed {k}, central system", symbol=f"n_{k}", unit="r/min",
               analytic=f"forward critical {k}", printed=(f"huang2022:critical-speed-{k}",))
      for k in ORDERS),
    Rounded(name="every member has the three printed speeds", symbol="Δn/n", unit="1",
            residual=hit, bound=1.1e-8, scale_name="printed speed",
            bound_reason="where members are accepted, and round-off of another assembly"),
    Share(name="starts that meet all three speeds", symbol="", unit="1", of="starts",
          holds=lambda a: a["start met"] > 0),
    Share(name="starts that meet them inside the ranges", symbol="", unit="1", of="starts",
          holds=lambda a: a["start kept"] > 0),
)  # fmt: skip
SHARES = tuple(map(shares, STATEMENTS))

"""Claims that two values of one quantity agree within a tolerance stated beforehand.

The tolerance is an accepted error of the quantity, a statement of a paper, or a requirement of
the suite with its reason. It is never taken from the finite elements of the row. Such a claim is
judged like any comparison, with its detection limit.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from verify.core.case import Context
from verify.core.results import Kind, Partner, Row, Status
from verify.judging import judge
from verify.judging.claims import Claim

SUBJECT = "accepted error of this quantity"  # stated for that very quantity
EQUAL = 1e-9  # of the largest distance: pairs of symmetric places differ by round-off
BOTH_WAYS = "twice the accepted error, because the error may have either sign"


@dataclass(frozen=True)
class Pair:
    """A value, its reference, and the expanded uncertainty U of the reference [SI].

    `words` states the error. If the tolerance refers to a value other than `reference`, `allowed`
    is the permitted interval of the signed model error.
    """

    value: float
    reference: float
    U: float
    words: str
    allowed: tuple[float, float] | None = None


@dataclass(frozen=True, kw_only=True)
class Stated(Claim):
    """Base class of claims with an accepted error that is valid for the paper's inputs only.

    At user inputs, the error is SHOWN; with `everywhere`, it is also judged there. `source` is the
    origin of the accepted error: `SUBJECT`, a place in a paper, or a text by `suites`. `by` is the
    method of the reference; it is empty for finite elements.
    """

    accepted: float
    source: str
    by: str = ""
    fem_needed: bool = True
    everywhere: bool = False

    @property
    def needs_fem(self) -> bool:
        return self.fem_needed

    def _not_judged(self, context: Context, words: str, **more: Any) -> list[Row]:
        verdict = judge.Verdict(Status.SHOWN, words)
        printed = self._printed(context)
        return [self._row(context.case, Kind.FACT, verdict, published=printed, **more)]

    def _judged_here(self, context: Context) -> bool:
        return context.is_paper or self.everywhere

    def _beside(self, value: float) -> dict[str, Any]:
        return {"partner": Partner(by=self.by, value=value)} if self.by else {"fem": value}


@dataclass(frozen=True, kw_only=True)
class Agreement(Stated):
    """Check that one value agrees with another within the relative tolerance ± `accepted`.

    The claim is an approximation with this interval. If there are many pairs, `pair(context)`
    returns the pair with the largest difference.
    """

    kind = Kind.APPROXIMATION

    pair: Callable[[Context], Pair]

    def rows(self, context: Context) -> list[Row]:
        found = self.pair(context)
        if not self._judged_here(context):
            return self._not_judged(context, found.words)
        limits = found.allowed or (-self.accepted, self.accepted)
        verdict = judge.approximation(
            found.value, found.reference, U=found.U, interval=limits, demand=self.demand
        )
        return [
            self._row(
                context.case, self.kind, worded(verdict, found.words), analytic=found.value,
                scale=abs(found.reference), interval=limits, interval_source=self.source,
                u_num=found.U / judge.COVERAGE, published=self._printed(context),
                **self._beside(found.reference),
            )
        ]  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Deviation(Stated):
    """Check that the norm of a difference over a field or a set is below `accepted`.

    `size(context)` returns the norm relative to the whole, its expanded uncertainty, and a text
    that states the error. Formula and reference solve the same problem. If one of them changes by a
    fraction p of the whole, the norm changes by at most p.
    """

    kind = Kind.IDENTITY

    size: Callable[[Context], tuple[float, float, str]]
    whole: str  # divisor of the difference, in words

    def rows(self, context: Context) -> list[Row]:
        size, U, words = self.size(context)
        if not self._judged_here(context):
            return self._not_judged(context, words)
        verdict = judge.difference(size, 0.0, U=self.accepted - U, scale=1.0, demand=self.demand)
        return [
            self._row(
                context.case, self.kind, worded(verdict, words), analytic=0.0, scale=1.0,
                scale_name=self.whole, u_num=U / judge.COVERAGE, interval_source=self.source,
                published=self._printed(context), **self._beside(size),
            )
        ]  # fmt: skip


def farthest(values: NDArray[np.float64], references: NDArray[np.float64], u: float) -> Pair:
    """Pair of entries with the largest relative difference, from arrays of equal size.

    The relative expanded uncertainty of the reference is `u`. If several differences are equal
    except for round-off, the first pair is returned, so that the result is the same on any
    processor.
    """
    off = np.ravel(values / references - 1)
    size = np.abs(off)
    k = int(size.argmax())
    if np.isfinite(size[k]):
        k = int(np.argmax(size >= (1 - EQUAL) * size[k]))
    value, reference = float(np.ravel(values)[k]), float(np.ravel(references)[k])
    words = f"largest error {off[k]:+.2g}, among {off.size} compared values"
    return Pair(value, reference, u * abs(reference), words)


def suites(reason: str) -> str:
    """Text that gives `reason` as the source of an accepted error that only this suite requires."""
    return f"requirement of the suite: {reason}"


def demanded(accepted: float) -> dict[str, Any]:
    """Required sensitivity for the accepted error `accepted`: twice this error.

    The result is empty if twice the accepted error does not exceed the default of the suite, which
    then applies.
    """
    if 2 * accepted <= judge.DEMAND:
        return {}
    return {"demand": 2 * accepted, "demand_reason": BOTH_WAYS}


def worded(verdict: judge.Verdict, words: str) -> judge.Verdict:
    """The verdict, with a text that states the error appended to its reason."""
    reason = f"{verdict.reason}: {words}" if verdict.reason else words
    return replace(verdict, reason=reason)

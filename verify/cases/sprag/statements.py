"""Checks of statements and numbers that the paper prints for its sprag clutch."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from verify.cases.sprag.clutch.paper_fem import ANGLES
from verify.cases.sprag.inputs import IDENTIFIED
from verify.core.case import Context
from verify.core.figures import Array
from verify.core.results import Kind, Partner, Row, Status
from verify.judging import judge
from verify.judging.checks import Accepted
from verify.judging.claims import Claim

SLICED = 0.02  # accepted error of a pressure by slices; STRIPS: by strips
STRIPS = 0.003
WIDER = 0.045  # demand of a row with that interval
BY_STRIPS = "strips"
PLACE = "accepted errors of slices (2 %) and of strips (0.3 %)"
FITTED = f"the result depends on {len(IDENTIFIED)} identified inputs"
UNFITTED = "no wedge angle between {:.2g} and {:.2g}° gives the pressure printed at 25 N m".format(
    *np.degrees(ANGLES)
)

Measured = Mapping[str, Array]


def sliced(q: Any, _values: Any) -> tuple[float, float] | None:
    """Accepted interval of (slices - strips)/strips; None for a user's inputs."""
    return (-SLICED - STRIPS, SLICED + STRIPS) if q == type(q)() else None


def measured(context: Context) -> Measured:
    """Arrays of the reference at the finest level, by name."""
    return context.fem[-1].arrays


@dataclass(frozen=True, kw_only=True)
class OfPaper(Accepted):
    """Accepted statement that is evaluated for the paper's clutch only."""

    paper_only: bool = True

    def rows(self, context: Context) -> list[Row]:
        return super().rows(context) if context.is_paper else []


@dataclass(frozen=True, kw_only=True)
class Noted(Claim):
    """Statement of the paper that the paper's equations contradict.

    The status is NOTE with the entry of the ledger of errata if `margin` is positive, which means
    that the equations contradict the statement. Otherwise the ledger is wrong, and the status is
    FAIL.
    """

    kind = Kind.FACT
    paper_only: bool = True

    erratum: str
    margin: Callable[[Context], tuple[float, float, str]]

    def rows(self, context: Context) -> list[Row]:
        if not context.is_paper:
            return []
        margin, U, words = self.margin(context)
        verdict = judge.fact(margin, U)
        if verdict.status is Status.PASS:
            reason = f"{words}; ledger {self.erratum}"
            verdict = replace(verdict, status=Status.NOTE, reason=reason)
        else:
            reason = f"the result contradicts the ledger entry {self.erratum}: {words}"
            verdict = replace(verdict, reason=reason if math.isfinite(margin) else UNFITTED)
        return [self._row(context.case, Kind.FACT, verdict, published=self._printed(context))]


@dataclass(frozen=True, kw_only=True)
class Beside(Claim):
    """Value computed with identified inputs, compared with the number `figure` [SI].

    If inputs were `fitted` to the number, the status is CALIBRATED within `bound` and FAIL beyond.
    Otherwise the value is a prediction with the status SHOWN.
    """

    kind = Kind.APPROXIMATION
    paper_only: bool = True

    value: Callable[[Context], float]
    figure: float
    figure_is: str = "printed"
    words: str
    bound: float = math.inf
    fitted: str = ""

    def rows(self, context: Context) -> list[Row]:
        if not context.is_paper:
            return []
        v = self.value(context)
        if not math.isfinite(v):
            verdict = judge.Verdict(Status.FAIL, UNFITTED)
            return [self._row(context.case, Kind.APPROXIMATION, verdict, scale=self.figure,
                              published=self._printed(context))]  # fmt: skip
        error = v / self.figure - 1
        reason, status = f"the difference is {error:+.1%}; {self.words}", Status.SHOWN
        if self.fitted:
            status = Status.CALIBRATED if abs(error) < self.bound else Status.FAIL
            reason = f"{reason}; {self.fitted}"
        verdict = judge.Verdict(status, reason, v - self.figure)
        return [
            self._row(
                context.case, Kind.APPROXIMATION, verdict, analytic=v, scale=self.figure,
                partner=Partner(by=self.figure_is, value=self.figure),
                published=self._printed(context),
            )
        ]  # fmt: skip

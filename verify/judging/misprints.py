"""Checks of printed formulas and statements that contradict other statements of their paper."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from verify.core.case import Context
from verify.core.results import Kind, Row, Status
from verify.judging import judge
from verify.judging.claims import Claim


@dataclass(frozen=True, kw_only=True)
class Misprint(Claim):
    """A printed formula or statement that contradicts other statements of its paper.

    `margin` returns the margin of the contradiction, and a text. If the margin is positive, the row
    is a NOTE with its errata entry `erratum`. Otherwise, the entry is wrong and the row fails.
    """

    kind = Kind.FACT
    paper_only: bool = True

    erratum: str
    margin: Callable[[Context], tuple[float, str]]
    fem_needed: bool = True

    @property
    def needs_fem(self) -> bool:
        return self.fem_needed

    def rows(self, context: Context) -> list[Row]:
        if not context.is_paper:
            return []
        margin, words = self.margin(context)
        verdict = judge.fact(margin, 0.0)
        if verdict.status is Status.PASS:
            reason = f"{words}; ledger {self.erratum}"
            verdict = replace(verdict, status=Status.NOTE, reason=reason)
        else:
            verdict = replace(
                verdict,
                reason=f"ledger {self.erratum} is contradicted by the computed value: {words}",
            )
        return [self._row(context.case, Kind.FACT, verdict)]

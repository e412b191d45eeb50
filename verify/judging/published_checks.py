"""Claims that compare a formula with printed values, without finite elements."""

from abc import abstractmethod
from dataclasses import dataclass, replace

from verify.core import units
from verify.core.case import Context
from verify.core.results import Kind, Partner, Published, Row, Status
from verify.judging import judge
from verify.judging.claims import Claim, beside
from verify.papers.entries import Value
from verify.papers.ledger import erratum, published

NO_UNCERTAINTY = "not judged, because the paper states no uncertainty"


@dataclass(frozen=True, kw_only=True)
class PrintedClaim(Claim):
    """Comparison of the formula value `analytic` with the printed value `reference`.

    `reference` is a key "paper:id" or a value.
    """

    paper_only: bool = True

    analytic: str
    reference: str | Value

    @property
    def needs_fem(self) -> bool:
        return False

    def rows(self, context: Context) -> list[Row]:
        return [self.judged(context)] if context.is_paper else []

    @abstractmethod
    def judged(self, context: Context) -> Row:
        """Row of the claim, judged at the paper's inputs."""

    def _beside(self) -> tuple[Published, ...]:
        return (beside(self.reference, self.unit),) if isinstance(self.reference, str) else ()

    def _printed_value(self) -> Value:
        return published(self.reference) if isinstance(self.reference, str) else self.reference


@dataclass(frozen=True, kw_only=True)
class PrintedTheory(PrintedClaim):
    """Comparison of a formula with the number that the paper computed from it.

    U is 2/sqrt(3) times half a unit of the last printed digit.
    """

    kind = Kind.IDENTITY

    def judged(self, context: Context) -> Row:
        v, entry = context.analytic[self.analytic], self._printed_value()
        f = units.factor(entry.unit)
        r, u = entry.value * f, entry.standard_uncertainty
        fields = {"analytic": v, "published": self._beside()}
        if u is None:
            verdict = judge.Verdict(Status.SHOWN, "the value is printed as approximate", v - r)
            return self._row(context.case, Kind.APPROXIMATION, verdict, scale=abs(r), **fields)
        verdict = judge.difference(
            v, r, U=judge.expanded(0.0, u * f), scale=abs(r), demand=self.demand
        )
        partner = Partner(by=f"printed {entry.printed}", value=r)
        return self._row(
            context.case, Kind.IDENTITY, verdict, scale=abs(r), u_num=0.0, u_ref=u * f,
            u_input=0.0, partner=partner, **fields,
        )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class PrintedMeasurement(PrintedClaim):
    """Comparison with a printed value of a test or of finite elements; SHOWN, without a verdict."""

    kind = Kind.APPROXIMATION

    def judged(self, context: Context) -> Row:
        v, entry = context.analytic[self.analytic], self._printed_value()
        r = entry.value * units.factor(entry.unit)
        reason = (
            f"difference of the formula from the printed value {100 * (v / r - 1):+.1f} %, "
            f"{NO_UNCERTAINTY}"
        )
        verdict = judge.Verdict(Status.SHOWN, reason, v - r)
        return self._row(
            context.case, Kind.APPROXIMATION, verdict, analytic=v, scale=abs(r),
            partner=Partner(by=f"printed {entry.kind} {entry.printed}", value=r),
            published=self._beside(),
        )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Contradiction(PrintedClaim):
    """A printed number that contradicts the formulas of the paper; its row is a NOTE.

    `analytic` must exceed the printed `reference` by more than U; otherwise, the errata entry is
    wrong and the row fails. `erratum` is the key of the errata entry ("paper:id").
    """

    kind = Kind.FACT

    erratum: str

    def judged(self, context: Context) -> Row:
        entry, v = self._printed_value(), context.analytic[self.analytic]
        f = units.factor(entry.unit)
        U = judge.expanded(0.0, (entry.standard_uncertainty or 0.0) * f)
        verdict = judge.fact(v - entry.value * f, U)
        if verdict.status is Status.PASS:
            why = erratum(self.erratum)
            verdict = replace(
                verdict, status=Status.NOTE, reason=f"ledger {self.erratum}: {why.right}"
            )
        else:
            verdict = replace(verdict, reason=f"contradicts ledger {self.erratum}")
        partner = Partner(by=f"printed {entry.printed}", value=entry.value * f)
        return self._row(
            context.case, Kind.FACT, verdict, analytic=v, scale=abs(entry.value * f),
            partner=partner, published=self._beside(),
        )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Adopted(PrintedClaim):
    """A printed number that is used as an input; its row is a NOTE with the reason `why`.

    If there is a value of `analytic`, it is displayed with the number.
    """

    kind = Kind.FACT

    analytic: str = ""
    why: str

    def judged(self, context: Context) -> Row:
        v = context.analytic[self.analytic] if self.analytic else None
        entry = self._printed_value()
        r = entry.value * units.factor(entry.unit)
        return self._row(
            context.case, Kind.FACT, judge.Verdict(Status.NOTE, self.why), analytic=v,
            partner=Partner(by=f"printed {entry.printed}", value=r), published=self._beside(),
        )  # fmt: skip

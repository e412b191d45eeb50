"""The answer for a part: whether the part holds, its design value, its limits and its margin."""

import math
from dataclasses import dataclass
from enum import StrEnum

ROUND_OFF = 1e-9  # relative; a value equal to the limit satisfies it


class Verdict(StrEnum):
    """Verdict of the formulas on a part."""

    HOLDS = "holds"
    FAILS = "fails"
    CANNOT_SAY = "cannot say"


EXIT_STATUS = {Verdict.HOLDS: 0, Verdict.FAILS: 1, Verdict.CANNOT_SAY: 3}


@dataclass(frozen=True, kw_only=True)
class Quantity:
    """A value [SI] with its display unit."""

    key: str
    symbol: str
    value: float
    unit: str
    what: str


@dataclass(frozen=True, kw_only=True)
class Criterion:
    """A computed value [SI] and its limit [SI].

    With `minimum`, the value must not be below the limit; otherwise, the value must not exceed the
    limit. `source` is the source of the limit. `assumed` is True if the file does not give the
    limit. `doubt` is the reason why a value within the limit is not sufficient.
    """

    key: str
    what: str
    value: float
    limit: float
    unit: str
    source: str
    assumed: bool = False
    minimum: bool = False
    doubt: str = ""

    @property
    def margin(self) -> float:
        """Margin [1]: limit divided by value; for a minimum, value divided by limit.

        The criterion is met if the margin is at least 1.
        """
        above, below = (self.value, self.limit) if self.minimum else (self.limit, self.value)
        if below <= 0:
            return math.inf
        return max(above, 0.0) / below

    @property
    def is_met(self) -> bool:
        """Whether the value is within its limit."""
        return self.margin >= 1 - ROUND_OFF


@dataclass(frozen=True, kw_only=True)
class Answer:
    """Design value and criteria of a part, and sentences about effects without a criterion.

    `failures` are causes of failure other than a criterion, `unknowns` are reasons for which the
    verdict is undecided, and `remarks` describe effects that do not change the verdict.
    """

    design: Quantity | None
    criteria: tuple[Criterion, ...] = ()
    failures: tuple[str, ...] = ()
    unknowns: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()

    @property
    def verdict(self) -> Verdict:
        """Verdict of the part.

        The part fails if a criterion is not met, even if other quantities are unknown.
        """
        if self.failures or not all(c.is_met for c in self.criteria):
            return Verdict.FAILS
        return Verdict.CANNOT_SAY if self.unknowns or not self.criteria else Verdict.HOLDS

    @property
    def limiting(self) -> Criterion | None:
        """Criterion with the smallest margin.

        Criteria with a `doubt` are considered only if every criterion has one.
        """
        deciding = [c for c in self.criteria if not c.doubt] or self.criteria
        return min(deciding, key=lambda c: c.margin, default=None)

    @property
    def reasons(self) -> tuple[str, ...]:
        """Reasons for a verdict other than "holds"; criteria that are not met are not included."""
        if self.verdict is Verdict.FAILS:
            return self.failures
        if self.criteria or self.unknowns:
            return self.unknowns
        return ("no limit applies to this case: it compares formulas",)

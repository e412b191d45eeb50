"""Collects the criteria of one part."""

import math
from dataclasses import dataclass, field
from typing import Literal

from verify.answers.answer import Answer, Criterion, Quantity
from verify.answers.strengths import (
    BALL_STATIC,
    ROLLER_STATIC,
    SOURCES,
    Strength,
    contact_pressure,
)


@dataclass
class Assessment:
    """The criteria that a case's inputs and values are held to; `design` is the number to use.

    Without `with_design` a number to use that takes long to compute may be left out.
    """

    design: Quantity | None = None
    with_design: bool = True
    criteria: list[Criterion] = field(default_factory=list)
    failures: list[str] = field(default_factory=list)
    unknowns: list[str] = field(default_factory=list)

    def answer(self) -> Answer:
        """What has been collected."""
        return Answer(
            design=self.design, criteria=tuple(self.criteria), failures=tuple(self.failures),
            unknowns=tuple(self.unknowns),
        )  # fmt: skip

    def at_most(self, key: str, what: str, value: float, limit: float, unit: str, source: str,
                *, assumed: bool = False) -> None:  # fmt: skip
        """`value` [SI] must not exceed `limit` [SI]."""
        self._add(key, what, value, limit, unit, source, assumed=assumed, minimum=False)

    def at_least(self, key: str, what: str, value: float, limit: float, unit: str, source: str,
                 *, assumed: bool = False) -> None:  # fmt: skip
        """`value` [SI] must not be below `limit` [SI]."""
        self._add(key, what, value, limit, unit, source, assumed=assumed, minimum=True)

    def stress(self, key: str, what: str, value: float, strength: Strength) -> None:
        """A stress [Pa], by magnitude, beside the strength of the part."""
        if strength.value is None:
            self.unknowns.append(f"{what}: {strength.source}; give R_p")
            return
        self.at_most(key, what, abs(value), strength.value, "MPa", strength.source,
                     assumed=strength.assumed)  # fmt: skip

    def pressure(
        self, key: str, what: str, p: float, *moduli: float,
        given: float | None = None, contact: Literal["line", "point"] = "line",
        option: str = "give p_lim in freewheel-clutch or sprag-clutch",
    ) -> None:  # fmt: skip
        """A contact pressure [Pa] beside `given` or the standard's limit for these moduli [Pa].

        A pressure that is within the given limit and beyond the standard's is not decided.
        """
        point = contact == "point"
        limit = contact_pressure(given, *moduli, point=point)
        if limit.value is None:
            self.unknowns.append(f"{what}: {limit.source}; {option}")
            return
        standard = BALL_STATIC if point else ROLLER_STATIC
        self.at_most(key, what, p, limit.value, "MPa", limit.source, assumed=limit.assumed)
        if standard < p <= limit.value:
            self.unknowns.append(
                f"{what} {p / 1e6:.4g} MPa is within the given limit and beyond "
                f"{standard / 1e6:g} MPa, {SOURCES[standard]}"
            )

    def _add(self, key: str, what: str, value: float, limit: float, unit: str, source: str,
             *, assumed: bool, minimum: bool) -> None:  # fmt: skip
        if math.isnan(value) or math.isnan(limit):
            self.unknowns.append(f"{what}: no value with these inputs")
            return
        self.criteria.append(
            Criterion(key=key, what=what, value=value, limit=limit, unit=unit, source=source,
                      assumed=assumed, minimum=minimum)
        )  # fmt: skip

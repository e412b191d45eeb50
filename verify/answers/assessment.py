"""Collection of the criteria of one part."""

import math
from dataclasses import dataclass, field
from typing import Literal

from verify.answers.answer import Answer, Criterion, Quantity
from verify.answers.strengths import (
    BALL_STATIC,
    GIVEN,
    ROLLER_STATIC,
    SOURCES,
    Strength,
    contact_pressure,
)
from verify.core.inputs import Inputs, meta


@dataclass
class Assessment:
    """Criteria for one part, collected from the inputs and values of a case.

    `design` is the design value. If `with_design` is False, a design value that takes long to
    compute may be omitted. `assumed` contains the names of the inputs that the file does not give.
    """

    design: Quantity | None = None
    with_design: bool = True
    assumed: frozenset[str] = frozenset()
    criteria: list[Criterion] = field(default_factory=list)
    failures: list[str] = field(default_factory=list)
    unknowns: list[str] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)

    def answer(self) -> Answer:
        """Answer from the criteria collected so far."""
        return Answer(
            design=self.design, criteria=tuple(self.criteria), failures=tuple(self.failures),
            unknowns=tuple(self.unknowns), remarks=tuple(self.remarks),
        )  # fmt: skip

    def below_input(self, key: str, what: str, value: float, inputs: Inputs, name: str) -> None:
        """Add the criterion that `value` [SI] must not exceed the input `name` of `inputs`."""
        about, is_assumed = meta(type(inputs).model_fields[name]), name in self.assumed
        source = f"{'' if is_assumed else f'{GIVEN} '}{about['symbol'] or name}, {about['what']}"
        limit = getattr(inputs, name)
        self.at_most(key, what, value, limit, about["unit"], source, assumed=is_assumed)

    def at_most(self, key: str, what: str, value: float, limit: float, unit: str, source: str,
                *, assumed: bool = False, doubt: str = "") -> None:  # fmt: skip
        """Add the criterion that `value` [SI] must not exceed `limit` [SI]."""
        self._add(Criterion(key=key, what=what, value=value, limit=limit, unit=unit, source=source,
                            assumed=assumed, doubt=doubt))  # fmt: skip

    def at_least(self, key: str, what: str, value: float, limit: float, unit: str, source: str,
                 *, assumed: bool = False, doubt: str = "") -> None:  # fmt: skip
        """Add the criterion that `value` [SI] must not be below `limit` [SI]."""
        self._add(Criterion(key=key, what=what, value=value, limit=limit, unit=unit, source=source,
                            assumed=assumed, minimum=True, doubt=doubt))  # fmt: skip

    def stress(
        self, key: str, what: str, value: float, strength: Strength, option: str = "give R_p"
    ) -> None:
        """Add the criterion that the magnitude of a stress [Pa] must not exceed the `strength`."""
        if strength.value is None:
            self.unknowns.append(f"{what} {abs(value) / 1e6:.4g} MPa: {strength.source}; {option}")
            return
        self.at_most(key, what, abs(value), strength.value, "MPa", strength.source,
                     assumed=strength.assumed)  # fmt: skip

    def pressure(
        self, key: str, what: str, p: float, *moduli: float,
        given: float | None = None, contact: Literal["line", "point"] = "line",
        option: str = "give p_lim in freewheel-clutch or sprag-clutch",
    ) -> None:  # fmt: skip
        """Add the criterion for a contact pressure `p` [Pa].

        The limit is `given`, or that of the standard (ISO 76) if `given` is None.

        If the pressure is within the given limit but exceeds the limit of the standard, the
        criterion is undecided.
        """
        point = contact == "point"
        limit = contact_pressure(given, *moduli, point=point)
        if limit.value is None:
            self.unknowns.append(f"{what} {p / 1e6:.4g} MPa: {limit.source}; {option}")
            return
        is_assumed = limit.assumed or "p_lim" in self.assumed
        source = SOURCES[ROLLER_STATIC] if "p_lim" in self.assumed else limit.source
        standard = BALL_STATIC if point else ROLLER_STATIC
        doubt = ""
        if standard < p <= limit.value:
            doubt = f"beyond {standard / 1e6:g} MPa, {SOURCES[standard]}"
            self.unknowns.append(f"{what} {p / 1e6:.4g} MPa is within the given limit and {doubt}")
        self.at_most(key, what, p, limit.value, "MPa", source, assumed=is_assumed, doubt=doubt)

    def _add(self, one: Criterion) -> None:
        if math.isnan(one.value) or math.isnan(one.limit):
            self.unknowns.append(f"{one.what}: no value with these inputs")
        else:
            self.criteria.append(one)

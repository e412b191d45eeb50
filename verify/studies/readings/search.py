"""Readings of inputs and result that give a printed number, and the expected chance matches.

If the formula does not give a printed number, the number may have another meaning: a diameter
instead of a radius, one side instead of both, plane strain instead of plane stress. Every
combination of a few readings is tried. It matches if the difference is within half a unit of the
last printed digit plus the effect of rounded inputs.

The more readings are tried, the more of them match by chance. Therefore, the expected number of
matches with a number unrelated to the formula is reported. Results of readings are concentrated
near the result of the first reading, and so are printed numbers that are wrong for another reason.
Chance matches are therefore counted for numbers close to the printed number and for numbers within
a factor of 2. The larger count is used.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import Any

from verify.papers.digits import half_last_digit, number
from verify.studies.readings.misprints import is_misprint, misprints

Inputs = Mapping[str, Any]
Formula = Callable[[Inputs], float]
Progress = Callable[[int, int], None]

EVIDENCE = 0.05  # expected accidental hits; above, a hit is no evidence
SPANS = (2.0, 1.15)  # factors of the printed number within which an unrelated one is anywhere
SAME = 1e-9  # relative: two combinations that are one
DIGIT = "one digit misprinted"
LEAST_DIGITS = 99.5  # units of the last printed place


@dataclass(frozen=True, kw_only=True)
class Reading:
    """One named change of the inputs or of the result.

    Two readings with the same `of` change the same item and exclude each other. `rounding` contains
    the rounding errors of inputs under this reading.
    """

    name: str
    of: str
    inputs: Callable[[Inputs], Inputs] | None = None
    result: Callable[[float, Inputs], float] | None = None
    rounding: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Tried:
    """A combination of readings; rounded inputs can change its result `value` by `off`."""

    readings: tuple[str, ...]
    value: float
    off: float

    @property
    def changes(self) -> int:
        return len(self.readings)


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """Result of a search.

    `as_it_stands` is the result without a change, None if the formula has no value. `met` states
    whether this result gives the printed number. `hits` are the matching combinations, sorted by
    the number of changes, then by the effect of rounding. `chance[k]` is the expected number of
    chance matches among combinations of at most k changes. This count refers to a number anywhere
    within a factor of 2 of the printed number, or within a factor of 1.15 if that count is larger.
    `found` are all combinations with a value.
    """

    printed: str
    value: float
    half_digit: float
    as_it_stands: Tried | None
    met: bool
    tried: int
    without_value: int
    hits: tuple[Tried, ...]
    chance: tuple[float, ...]
    found: tuple[Tried, ...] = ()

    @property
    def best(self) -> Tried | None:
        """The matching combination with the fewest changes; None if there is no match."""
        return self.hits[0] if self.hits else None

    @property
    def accidental(self) -> float:
        """Expected number of chance matches among combinations with no more readings than `best`.

        If there is no matching combination, all combinations are counted.
        """
        return self.chance[self.best.changes if self.best else -1]

    @property
    def is_evidence(self) -> bool:
        return self.best is not None and self.accidental <= EVIDENCE


def search(
    formula: Formula,
    inputs: Inputs,
    printed: str,
    readings: Sequence[Reading],
    *,
    rounding: Mapping[str, float] | None = None,
    most: int = 2,
    digits: bool = True,
    progress: Progress = lambda _done, _total: None,
) -> Outcome:
    """Result of trying all combinations of at most `most` readings against the printed number.

    `formula` returns the number in its printed unit from `inputs`. `rounding` contains the possible
    errors of single inputs: half a unit of their last printed digit. With `digits`, one misprinted
    digit in the result of the unchanged formula is another reading. This requires at least three
    printed digits: with fewer digits, any number would be a misprint. `progress` receives the
    number of finished combinations and their total. Raises ValueError if `printed` is no number or
    zero.
    """
    value, half = number(printed), half_last_digit(printed)
    digits = digits and abs(value) / (2 * half) >= LEAST_DIGITS
    if value == 0:
        raise ValueError("the printed number must not be zero: no reading reproduces zero")
    sums, every = _Evaluated(formula), _combined(readings, most)
    found: list[Tried] = []
    for done, chosen in enumerate(every):
        progress(done, len(every))
        if (combination := sums.tried(inputs, chosen, rounding or {})) is not None:
            found.append(combination)
    lost = len(every) - len(found)
    return _outcome(printed, value, half, found, len(every), lost, most, digits=digits)


def _combined(readings: Sequence[Reading], most: int) -> list[tuple[Reading, ...]]:
    """All combinations of readings that change different things, fewest changes first."""
    return [
        chosen
        for changes in range(most + 1)
        for chosen in combinations(readings, changes)
        if len({one.of for one in chosen}) == changes
    ]


def _outcome(
    printed: str,
    value: float,
    half: float,
    found: Sequence[Tried],
    tried: int,
    lost: int,
    most: int,
    *,
    digits: bool,
) -> Outcome:
    plain = next((t for t in found if not t.readings), None)
    met = plain is not None and _meets(plain, value, half)
    hits = [t for t in found if t.readings and _meets(t, value, half)]
    if digits and plain and is_misprint(plain.value, printed):
        hits.append(Tried(readings=(DIGIT,), value=plain.value, off=plain.off))
    hits = _needed(hits, value)
    return Outcome(
        printed=printed, value=value, half_digit=half, as_it_stands=plain, met=met, tried=tried,
        without_value=lost, hits=tuple(hits),
        chance=_larger(
            [_chances(found, printed, half, most, span, digits=digits) for span in SPANS]
        ),
        found=tuple(found),
    )  # fmt: skip


def _needed(hits: Sequence[Tried], value: float) -> list[Tried]:
    """Matching combinations without those that only add ineffective changes to another one."""
    kept: list[Tried] = []
    for hit in sorted(hits, key=lambda t: (t.changes, t.off, abs(t.value - value))):
        if not any(
            set(other.readings) < set(hit.readings)
            and math.isclose(other.value, hit.value, rel_tol=SAME)
            for other in kept
        ):
            kept.append(hit)
    return kept


def together(outcomes: Sequence[Outcome]) -> Outcome:
    """Result of one search for several numbers: readings that give all numbers together.

    `outcomes` are results for the same readings with different inputs. The numbers in the result
    are those of the first outcome.
    """
    first = outcomes[0]
    by_readings = [{t.readings: t for t in one.found} for one in outcomes]
    shared = [t for t in first.found if all(t.readings in known for known in by_readings)]
    hits = []
    for t in shared:
        each = [known[t.readings] for known in by_readings]
        pairs = list(zip(each, outcomes, strict=True))
        if t.readings and all(_meets(x, one.value, one.half_digit) for x, one in pairs):
            hits.append(t)
    hits = _needed(hits, first.value)
    most = len(first.chance) - 1
    return replace(
        first, met=all(one.met for one in outcomes), hits=tuple(hits),
        chance=_larger([_chances_together(shared, outcomes, most, span) for span in SPANS]),
    )  # fmt: skip


def _chances_together(
    shared: Sequence[Tried], outcomes: Sequence[Outcome], most: int, span: float
) -> list[float]:
    """Expected chance matches of all numbers at once, for combinations of 0, 1, ... changes."""
    by_readings = [{t.readings: t for t in one.found} for one in outcomes]
    sums = [0.0] * (most + 1)
    for t in shared:
        if t.readings:
            each = [known[t.readings] for known in by_readings]
            sums[t.changes] += math.prod(
                window(x.value, one.half_digit + x.off, one.value, span)
                for x, one in zip(each, outcomes, strict=True)
            )
    return sums


def _meets(tried: Tried, value: float, half: float) -> bool:
    """Whether the result matches the printed number within its digits and the input rounding."""
    return abs(tried.value - value) <= (half + tried.off) * (1 + SAME)


def _chances(
    found: Sequence[Tried], printed: str, half: float, most: int, span: float, *, digits: bool
) -> list[float]:
    """Expected chance matches among combinations of 0, 1, ... changes; equal values count once."""
    value, sums, counted = number(printed), [0.0] * (most + 1), dict[float, float]()
    for t in sorted(found, key=lambda t: t.changes):
        wide = window(t.value, half + t.off, value, span)
        same = next((x for x in counted if math.isclose(x, t.value, rel_tol=SAME)), t.value)
        if t.readings:
            sums[t.changes] += max(wide - counted.get(same, 0.0), 0.0)
        elif digits and most:
            sums[1] += sum(window(x, half, value, span) for x in misprints(t.value, printed))
        counted[same] = max(wide, counted.get(same, 0.0))
    return sums


def _larger(by_span: Sequence[Sequence[float]]) -> tuple[float, ...]:
    """Expected chance matches with at most 0, 1, ... changes, for the span with most matches."""
    return tuple(max(sum(sums[: k + 1]) for sums in by_span) for k in range(len(by_span[0])))


def window(value: float, half: float, printed: float, span: float) -> float:
    """Probability that a random number differs from `value` by less than `half`.

    The random number has the sign of `printed` and lies within a factor `span` of `printed`; its
    logarithm is uniformly distributed.

    >>> round(window(100.0, 1.0, 100.0, 2.0), 4)
    0.0144
    >>> round(window(100.0, 1.0, 100.0, 1.15), 4)
    0.0716
    """
    middle, least, largest = abs(printed), abs(printed) / span, abs(printed) * span
    x = value * math.copysign(1.0, printed)
    low, high = max(x - half, least), min(x + half, largest)
    return math.log(high / low) / math.log(largest / least) if high > low and middle else 0.0


class _Evaluated:
    """A formula that is evaluated once for each set of inputs."""

    def __init__(self, formula: Formula) -> None:
        self.formula = formula
        self.known: dict[tuple[tuple[str, Any], ...], float | None] = {}

    def tried(
        self, inputs: Inputs, chosen: Sequence[Reading], rounding: Mapping[str, float]
    ) -> Tried | None:
        """Result of a combination of readings; None if it is not finite."""
        half = dict(rounding)
        for reading in chosen:
            half |= reading.rounding
        middle = self._value(inputs, chosen)
        if middle is None:
            return None
        off = 0.0
        for name, step in half.items():
            ends = [self._value({**inputs, name: inputs[name] + s}, chosen) for s in (-step, step)]
            off += max(abs(end - middle) for end in (middle, *ends) if end is not None)
        return Tried(readings=tuple(r.name for r in chosen), value=middle, off=off)

    def _value(self, inputs: Inputs, chosen: Sequence[Reading]) -> float | None:
        """Value of the formula with all readings applied; None if it is not finite."""
        try:
            value = self._read(inputs, chosen)
        except (ValueError, ArithmeticError, TypeError):  # a root of less than zero, a division
            return None
        return value if value is not None and math.isfinite(value) else None

    def _read(self, inputs: Inputs, chosen: Sequence[Reading]) -> float | None:
        """Value of the formula with the readings of inputs, then of the result, applied."""
        for reading in chosen:
            if reading.inputs:
                inputs = {**inputs, **reading.inputs(inputs)}
        key = tuple(sorted(inputs.items()))
        if key not in self.known:
            self.known[key] = self._once(inputs)
        value = self.known[key]
        for reading in chosen:
            if reading.result and value is not None:
                value = reading.result(value, inputs)
        return value

    def _once(self, inputs: Inputs) -> float | None:
        try:
            return float(self.formula(inputs))
        except (ValueError, ArithmeticError, TypeError):
            return None

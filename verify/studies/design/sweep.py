"""Values of a parameter in a search: one value, a list of values, or a range "a : b : n"."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from verify.core import units
from verify.core.inputs import LARGEST_INTEGER, InputError

MOST = 10_000  # values of one parameter


@dataclass(frozen=True, kw_only=True)
class Sweep:
    """A varied parameter: its unit, its range, and the `default` that the template contains."""

    name: str
    unit: str
    what: str
    default: Any
    low: float
    high: float
    symbol: str = ""
    above: bool = False  # the value must be greater than `low`, not just as large
    whole: bool = False

    @property
    def rule(self) -> str:
        """Rule for a value in words: lower and upper limit."""
        lower = "greater than" if self.above else "at least"
        return f"{lower} {self._shown(self.low)} and at most {self._shown(self.high)}"

    def read(self, raw: Any, where: str) -> tuple[float, ...]:
        """SI values of a raw TOML value, in ascending order without duplicates.

        Raises InputError, which states the fault, if a value is wrong.
        """
        values = self._values(raw, where)
        for value in values:
            self._check(value, where)
        return tuple(sorted(set(values)))

    def _values(self, raw: Any, where: str) -> Sequence[float]:
        if isinstance(raw, list):
            if not raw:
                raise InputError(f"{where}: the list must contain at least one value")
            if len(raw) > MOST:
                raise InputError(f"{where}: {len(raw):,} values given, the maximum is {MOST:,}")
            return [self._one(item, f"{where}[{i}]") for i, item in enumerate(raw)]
        if isinstance(raw, str) and ":" in raw:
            return self._range(raw, where)
        return [self._one(raw, where)]

    def _range(self, raw: str, where: str) -> Sequence[float]:
        parts = [part.strip() for part in raw.split(":")]
        if len(parts) != 3:
            raise InputError(
                f'{where}: a range must be "first : last : number of values", got {raw[:60]!r}'
            )
        first, last = (self._text(part, where) for part in parts[:2])
        if not parts[2].isdecimal() or not 2 <= int(parts[2][:9]) <= MOST:
            raise InputError(
                f"{where}: the last part of a range must be the number of values, 2 to {MOST:,}, "
                f"got {parts[2][:20]!r}"
            )
        if not first < last:
            ends = " to ".join(self._shown(end / units.factor(self.unit)) for end in (first, last))
            raise InputError(f"{where}: first must be less than last, got {ends}")
        values = np.linspace(first, last, int(parts[2]))
        if self.whole and np.any(values != np.round(values)):
            raise InputError(
                f"{where}: {raw[:60]!r} includes fractions, but this input takes whole numbers "
                "only: change the number of values"
            )
        return [float(v) for v in values]

    def _one(self, raw: Any, where: str) -> float:
        if isinstance(raw, str):
            return self._text(raw, where)
        if isinstance(raw, bool) or not isinstance(raw, int | float):
            got = repr(raw)[:60] if not isinstance(raw, dict | list) else "a table or list"
            raise InputError(f"{where}: needs {units.DIMENSIONS[self.unit]}, got {got}")
        if not abs(raw) <= LARGEST_INTEGER:
            raise InputError(f"{where}: the absolute value of the number is too large")
        if self.unit != "1":
            raise InputError(
                f"{where}: {raw} has no unit: needs {units.DIMENSIONS[self.unit]}, "
                f'such as "{raw} {self.unit}"'
            )
        return float(raw)

    def _text(self, text: str, where: str) -> float:
        try:
            return units.parse(text, self.unit)
        except ValueError as error:
            raise InputError(f"{where}: {error}") from error

    def _check(self, value: float, where: str) -> None:
        low, high = (bound * units.factor(self.unit) for bound in (self.low, self.high))
        if self.whole and value != round(value):
            raise InputError(f"{where}: the value must be a whole number, got {value:g}")
        # a bound that is rounded by a unit is satisfied: 90 deg in rad
        slack = 1e-12 * abs(high)
        if not (value > low if self.above else value >= low - slack) or not value <= high + slack:
            raise InputError(
                f"{where} = {self._shown(value / units.factor(self.unit))}: must be {self.rule}"
            )

    def _shown(self, value: float) -> str:
        return f"{value:.6g}" + ("" if self.unit == "1" else f" {self.unit}")

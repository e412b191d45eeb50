"""A range "low : high" that a search may use."""

from dataclasses import dataclass
from typing import Any

from verify.core import units
from verify.core.inputs import InputError


@dataclass(frozen=True, kw_only=True)
class Range:
    """The range of a parameter: its unit, the `default`, and the bounds that a range must meet.

    The lower bound is greater than `above`, the higher at most `most`, both in the unit.
    """

    name: str
    symbol: str
    unit: str
    what: str
    default: str
    above: float
    most: float

    @property
    def rule(self) -> str:
        """Rule for a range, in words."""
        return f"greater than {self.text(self.above)} and at most {self.text(self.most)}"

    def read(self, raw: Any, where: str) -> tuple[float, float]:
        """Both bounds in SI units; InputError states the error in one line."""
        parts = raw.split(":") if isinstance(raw, str) else []
        if len(parts) != 2:
            raise InputError(f'{where}: a range is "low : high", got {repr(raw)[:60]}')
        try:
            low, high = (units.parse(part.strip(), self.unit) for part in parts)
        except ValueError as error:
            raise InputError(f"{where}: {error}") from error
        low_shown, high_shown = (x / units.factor(self.unit) for x in (low, high))
        if not low < high:
            raise InputError(
                f"{where}: the ends of a range must ascend, got {self.text(low_shown)} to "
                f"{self.text(high_shown)}"
            )
        if not (low_shown > self.above and high_shown <= self.most * (1 + 1e-12)):
            raise InputError(
                f"{where} = {self.text(low_shown)} to {self.text(high_shown)}: must be {self.rule}"
            )
        return low, high

    def text(self, value: float) -> str:
        """A value in the unit, as text."""
        return f"{value:.6g}" + ("" if self.unit == "1" else f" {self.unit}")


RANGES = (
    Range(name="K_1_range", symbol="K_1", unit="1", what="depths of the crown to search",
          default="1 : 5", above=0, most=100),
    Range(name="K_2_range", symbol="K_2", unit="1", what="crowned shares of the length to search",
          default="0.4 : 0.7", above=0, most=1),
    Range(name="z_m_range", symbol="z_m", unit="mm", what="drops at the ends to search",
          default="0.005 mm : 0.025 mm", above=0, most=10),
)  # fmt: skip

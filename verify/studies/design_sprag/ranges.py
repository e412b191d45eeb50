"""Input of a range "low : high" in which a search varies a parameter."""

from dataclasses import dataclass
from typing import Any

from verify.core import units
from verify.core.inputs import InputError


@dataclass(frozen=True, kw_only=True)
class Range:
    """A parameter that the search varies: its unit, default range, and allowed ranges.

    In this unit, the lower end must be greater than `above`, and the upper end at most `most`.
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
        """Rule for a range in words: allowed lower and upper ends."""
        return f"greater than {self.text(self.above)} and at most {self.text(self.most)}"

    def read(self, raw: Any, where: str) -> tuple[float, float]:
        """Both ends of a range in SI units.

        Raises InputError, which states the fault in one line, if `raw` is wrong.
        """
        parts = raw.split(":") if isinstance(raw, str) else []
        if len(parts) != 2:
            raise InputError(f'{where}: a range must be "low : high", got {repr(raw)[:60]}')
        try:
            low, high = (units.parse(part.strip(), self.unit) for part in parts)
        except ValueError as error:
            raise InputError(f"{where}: {error}") from error
        low_shown, high_shown = (x / units.factor(self.unit) for x in (low, high))
        if not low < high:
            raise InputError(
                f"{where}: low must be less than high, got {self.text(low_shown)} to "
                f"{self.text(high_shown)}"
            )
        if not (low_shown > self.above and high_shown <= self.most * (1 + 1e-12)):
            raise InputError(
                f"{where} = {self.text(low_shown)} to {self.text(high_shown)}: must be {self.rule}"
            )
        return low, high

    def text(self, value: float) -> str:
        """`value` as text with the unit of the parameter."""
        return f"{value:.6g}" + ("" if self.unit == "1" else f" {self.unit}")


RANGES = (
    Range(name="K_1_range", symbol="K_1", unit="1", what="range of the crown's depth factor",
          default="1 : 5", above=0, most=100),
    Range(name="K_2_range", symbol="K_2", unit="1", what="range of the crowned share of the length",
          default="0.4 : 0.7", above=0, most=1),
    Range(name="z_m_range", symbol="z_m", unit="mm", what="range of the drop at the ends",
          default="0.005 mm : 0.025 mm", above=0, most=10),
)  # fmt: skip

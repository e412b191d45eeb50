"""One assumption that formula and reference share, and its meaning for the part."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from verify.core.differences import significant

Values = Mapping[str, float]


@dataclass(frozen=True, kw_only=True)
class SharedReading:
    """An assumption of both sides about a part; their agreement does not verify it.

    `effect` is the resulting error in the `quantity` of both sides: (value of both sides - value of
    the part)/value of the part; it is added to the difference of a row with its sign. It is None if
    it is unknown for these inputs; `source` is its source.
    """

    assumption: str
    part: str
    quantity: str
    effect: float | None = None
    source: str = "not quantified"

    @property
    def sentence(self) -> str:
        """Assumption, part and effect in one sentence for the terminal and the page."""
        head = f"formula and reference assume that {self.assumption}; in the real part {self.part}"
        if self.effect is None:
            return f"{head}; resulting error in {self.quantity}: {self.source}"
        size = f"{significant(100 * self.effect, 3, signed=True)} %"
        return f"{head}; resulting error in {self.quantity}: {size} ({self.source})"


Function = Callable[[Any, Values], tuple[SharedReading, ...]]


def ratio(values: Values, assumed: str, part: str) -> float | None:
    """A value of the formulas over that of the part, minus one; None if either is missing."""
    if assumed not in values or not values.get(part):
        return None
    return float(values[assumed] / values[part] - 1)


def only_at_paper(inputs: Any, effect: float) -> float | None:
    """An effect that was measured for the paper's inputs, and None for any others."""
    return effect if inputs == type(inputs)() else None


def equal_shares(parts: str, quantity: str) -> SharedReading:
    """All rolling elements of a clutch are identical and carry the same load."""
    return SharedReading(
        assumption=f"all {parts} are identical and carry equal loads",
        part=f"tolerances and wear load some {parts} more than others", quantity=quantity,
    )  # fmt: skip

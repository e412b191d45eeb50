"""Data type for one assumption that formula and reference share, and its effect on the part."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from verify.core.differences import significant

Values = Mapping[str, float]


@dataclass(frozen=True, kw_only=True)
class SharedReading:
    """An assumption of both formula and reference; a comparison of the two cannot verify it.

    `effect` is the resulting error in `quantity`, which formula and reference share: (value of
    formula and reference - value of the part)/value of the part. `effect` is added with its sign to
    the difference of a row; it is None if the error is unknown for these inputs. `source` is the
    source of `effect`. `part` states what applies to the real part instead of the `assumption`.
    """

    assumption: str
    part: str
    quantity: str
    effect: float | None = None
    source: str = "not quantified"

    @property
    def sentence(self) -> str:
        """Sentence: what is assumed, what applies to the real part, and the resulting error."""
        head = f"formula and reference assume that {self.assumption}; in the real part {self.part}"
        if self.effect is None:
            return f"{head}; resulting error in {self.quantity}: {self.source}"
        size = f"{significant(100 * self.effect, 3, signed=True)} %"
        return f"{head}; resulting error in {self.quantity}: {size} ({self.source})"


Function = Callable[[Any, Values], tuple[SharedReading, ...]]


def ratio(values: Values, assumed: str, part: str) -> float | None:
    """Ratio of one value of the formulas to another, minus 1; None if either value is missing.

    `assumed` is the key of the value with the assumption, `part` that of the value of the real
    part.
    """
    if assumed not in values or not values.get(part):
        return None
    return float(values[assumed] / values[part] - 1)


def only_at_paper(inputs: Any, effect: float) -> float | None:
    """`effect`, which is only valid for the paper's inputs; None for other inputs."""
    return effect if inputs == type(inputs)() else None


def equal_shares(parts: str, quantity: str) -> SharedReading:
    """Shared assumption that all rolling elements of a clutch are identical and equally loaded."""
    return SharedReading(
        assumption=f"all {parts} are identical and carry equal loads",
        part=f"tolerances and wear load some {parts} more than others", quantity=quantity,
    )  # fmt: skip

"""Data types for assumed inputs: the assumption, the resulting value, and the given inputs."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any


class NotGivenError(LookupError):
    """Error if a rule needs an input that the file does not give."""


class Given(dict[str, Any]):
    """Inputs in SI units, accessible as attributes. Raises NotGivenError for an omitted input."""

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise NotGivenError(name) from None


Rule = Callable[[Given], Any]


@dataclass(frozen=True, kw_only=True)
class Assumption:
    """Assumption for the input `name` if a file omits it.

    `value` is a TOML value ("206 GPa", 0.3) or a function of the other inputs that returns the SI
    value, or None if nothing can be assumed. `source` names a standard, a handbook or a paper, or
    begins with "typical:", or states the rule. `usual` contains the lowest and the highest usual
    value, each in the form of `value`; without it, the influence is determined for changes of 10 %.
    `dynamic` is True for an input that is used by --dynamic only. `varied` is False for a choice
    without a tolerance, such as a node.
    """

    name: str
    value: str | float | Rule
    source: str
    usual: tuple[str | float | Rule, str | float | Rule] | None = None
    dynamic: bool = False
    varied: bool = True


@dataclass(frozen=True, kw_only=True)
class Assumed:
    """An assumed input: its value in its display unit, and the source of the value."""

    name: str
    symbol: str
    value: float | int | str
    unit: str
    source: str

    @property
    def text(self) -> str:
        """Symbol, value and unit, such as `E = 206 GPa`."""
        value = f"{self.value:.6g}" if isinstance(self.value, float) else str(self.value)
        return f"{self.symbol} = {value}" + ("" if self.unit == "1" else f" {self.unit}")

    def record(self) -> Mapping[str, Any]:
        """The assumed input as a record for other programs."""
        return {
            "name": self.name, "symbol": self.symbol, "value": self.value, "unit": self.unit,
            "source": self.source,
        }  # fmt: skip

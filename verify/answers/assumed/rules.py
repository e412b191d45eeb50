"""Assumption: the value of an input that a file omits, with its source."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any


class NotGivenError(LookupError):
    """A rule needs an input that the file does not give."""


class Given(dict[str, Any]):
    """Inputs by name, in SI units, as attributes; NotGivenError for one that is not known."""

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise NotGivenError(name) from None


Rule = Callable[[Given], Any]


@dataclass(frozen=True, kw_only=True)
class Assumption:
    """The value of the input `name` if a file omits it.

    `value` is a TOML value ("206 GPa", 0.3), or a function of the other inputs that returns the SI
    value, None if nothing can be assumed. `source` is a standard, a handbook or a paper, or begins
    with "typical:", or states the rule. `usual` is the lowest and the highest usual value, each in
    the form of `value`; without it, the influence is determined for changes of 10 %. `dynamic`: the
    input is used by --dynamic only. `varied` is False for a choice without a tolerance, such as a
    node.
    """

    name: str
    value: str | float | Rule
    source: str
    usual: tuple[str | float | Rule, str | float | Rule] | None = None
    dynamic: bool = False
    varied: bool = True


@dataclass(frozen=True, kw_only=True)
class Assumed:
    """One input that was assumed: its value in its display unit, and the source of that value."""

    name: str
    symbol: str
    value: float | int | str
    unit: str
    source: str

    @property
    def text(self) -> str:
        """`E = 206 GPa`."""
        value = f"{self.value:.6g}" if isinstance(self.value, float) else str(self.value)
        return f"{self.symbol} = {value}" + ("" if self.unit == "1" else f" {self.unit}")

    def record(self) -> Mapping[str, Any]:
        """The assumed input as a record for other programs."""
        return {
            "name": self.name, "symbol": self.symbol, "value": self.value, "unit": self.unit,
            "source": self.source,
        }  # fmt: skip

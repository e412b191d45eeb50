"""Comparisons of formulas with a reference, by kind, each judged by `verify.judging`.

A check of `verify.judging` without a function here can be yielded directly, or in a `Comparison`
with the quantity that it judges.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import inf
from typing import Any, NamedTuple, TypedDict, Unpack

from verify.core.case import Check, Context, FemResult
from verify.form.quantity import Quantity, finite
from verify.judging import checks, judge
from verify.judging.convergence import grid_convergence
from verify.judging.published_checks import PrintedTheory
from verify.papers.entries import literal

Points = tuple[list[float], list[float], list[float]]  # parameter, error, standard uncertainty
Required = tuple[float, str]  # smallest relative error that must make the row fail, and why
Number = float | Callable[[], float]
Scale = Quantity | Mapping[str, Number]


class Expected(NamedTuple):
    """Expected signed error formula/reference - 1, and its source.

    One that is too wide to judge by for these inputs is not `sharp`: the error is only displayed.
    """

    low: float
    high: float
    source: str
    sharp: bool = True


class Computed(NamedTuple):
    """An expected error that takes long to compute: `interval` is called when the row is judged.

    It returns low and high, or None if the interval is too wide for judging.
    """

    interval: Callable[[], tuple[float, float] | None]
    source: str


def about(error: float, slack: float, source: str) -> Expected:
    """An expected error within `slack` of a value."""
    return Expected(error - slack, error + slack, source)


def underived(reason: str) -> Expected:
    """No expected error is known, for the stated reason: the error is only displayed."""
    return Expected(-inf, inf, reason, sharp=False)


@dataclass(frozen=True)
class State:
    """The formulas in another state: under another load, or for a long part.

    `case` has the quantities of this state, such as `self.at(T=...)`. Names of its numbers end in
    `key`, like those of the reference; names of its rows end in `words`; `symbol` is a format of
    its symbols. The state of the inputs has no `key`; if the inputs have no such state, there is no
    `case`. Numbers of a state that is not `displayed` are compared in rows, but are no values of
    `check`.
    """

    case: object | None
    key: str
    words: str
    symbol: str = "{}"
    displayed: bool = True


def key_of(q: Quantity, state: State | None) -> str:
    """The name of a quantity's number in a state: "d_i_rigid"."""
    return f"{q.name}_{state.key}" if state and state.key else q.name


class Options(TypedDict, total=False):
    """Options that every comparison of a quantity with a reference may state.

    `order` is the theoretical order of convergence of the reference. `against` distinguishes rows
    of one quantity; `name`, `symbol` and `unit` replace those of the declaration. `state` is
    another state than that of the inputs. `sensitivity` is the smallest error that must make the
    row fail, `own` the same for inputs of a user if it is less strict. `by` is the name of a second
    method that is refined like a mesh, `printed` are values of the papers for the row ("paper:id"),
    and `shares` is common to both sides.
    """

    order: float | None
    against: str
    name: str
    symbol: str
    unit: str
    state: State | None
    sensitivity: Required
    own: Required
    by: str
    printed: tuple[str, ...]
    shares: str


@dataclass(frozen=True, kw_only=True)
class Comparison:
    """A check, the formula that it judges, and further `numbers` [SI] for the check.

    `shares` states what is common to both sides, other than the inputs; `expected` is the stated
    error of an approximation.
    """

    check: Check
    quantity: Quantity | None = None
    state: State | None = None
    numbers: Mapping[str, Number] = field(default_factory=dict)
    shares: str = ""
    expected: Expected | Computed | None = None

    @property
    def name(self) -> str:
        """The name of its row, which no other comparison of the case has."""
        return str(getattr(self.check, "name", ""))

    @property
    def key(self) -> str:
        """The key of the formula's value, empty if none is judged."""
        return key_of(self.quantity, self.state) if self.quantity else ""

    def evaluated(self) -> dict[str, float]:
        """The further numbers, and that of the quantity in another state if not included."""
        found = {key: finite(v() if callable(v) else v) for key, v in self.numbers.items()}
        if self.quantity and self.state and self.state.case and self.key not in found:
            found[self.key] = self.quantity.of(self.state.case)
        return {key: value for key, value in found.items() if value is not None}


def identity(
    q: Quantity, reference: str = "", *, scale: Scale | None = None,
    uncertainty: Number | None = None, **options: Unpack[Options],
) -> Comparison:  # fmt: skip
    """Formula and reference solve the same problem and differ by numerical errors only.

    `reference` is the name of the number of the reference, by default that of the quantity. `scale`
    is the natural magnitude if the quantity may vanish: another quantity, or a number [SI] by its
    name. `uncertainty` is that of a formula with a truncated series, over the scale.
    """
    numbers = dict(scale) if isinstance(scale, Mapping) else {}
    more = {"scale": scale.name if isinstance(scale, Quantity) else next(iter(numbers), "")}
    if uncertainty is not None:  # can be zero for some inputs
        more["residual"] = f"uncertainty of {options.get('name') or q.label}"
        numbers[more["residual"]] = uncertainty
    return _compared(checks.Identity, q, reference, options, more, numbers)


def approximation(
    q: Quantity, reference: str = "", *, expected: Expected | Computed | None,
    **options: Unpack[Options],
) -> Comparison:  # fmt: skip
    """The formula neglects an effect; its signed error must lie in an interval derived beforehand.

    Comparisons are stated before the reference is solved: no interval can be taken from it.
    """
    source = "" if expected is None else expected.source
    if expected is not None and not source:
        raise q.broken("its expected error states no source")
    if isinstance(expected, Expected) and not expected.low <= expected.high:
        ends = f"from {expected.low:g} to {expected.high:g}"
        raise q.broken(f"its error is expected {ends}, and low must not be above high")

    def interval(*_: object) -> tuple[float, float] | None:
        if isinstance(expected, Computed):
            return expected.interval()
        return (expected.low, expected.high) if expected and expected.sharp else None

    more = {"interval": interval, "source": source}
    made = _compared(checks.Approximation, q, reference, options, more)
    return replace(made, expected=expected)


def limit(
    q: Quantity, name: str, symbol: str, *, points: Callable[[Sequence[FemResult]], Points],
    exponent: float | None, sensitivity: Required = (judge.DEMAND, ""),
) -> Comparison:  # fmt: skip
    """The formula is exact for a parameter of 0, and its error is a power of the parameter.

    `points` returns parameter, signed error and its standard uncertainty from all levels.
    """
    check = checks.Limit(name=name, symbol=symbol, unit="1", exponent=exponent,
                         points=lambda context: points(context.fem), demand=sensitivity[0],
                         demand_reason=sensitivity[1])  # fmt: skip
    return Comparison(check=check, quantity=q)


def over_family(
    q: Quantity, reference: str, *, at: Sequence[float], family: Callable[[float], object],
    order: float | None = None,
) -> Callable[[Sequence[FemResult]], Points]:  # fmt: skip
    """Points of a limit: `family` returns the case of a value, `reference` all results `at`."""

    def points(levels: Sequence[FemResult]) -> Points:
        sizes, d, u = [level.h for level in levels], [], []
        for k, parameter in enumerate(at):
            v = [float(level.arrays[reference][k]) for level in levels]
            grid = grid_convergence(sizes, v, formal=order, scale=abs(v[-1]))
            d.append(getattr(family(parameter), q.name) / v[-1] - 1)
            u.append(judge.numerical_uncertainty(grid) / abs(v[-1]))
        return list(at), d, u

    return points


def errors_of(q: Quantity, reference: str = "", state: State | None = None) -> Callable[
    [Context], tuple[list[float], list[float]]
]:  # fmt: skip
    """Mesh sizes and relative errors of the reference against an exact formula, for an `Order`."""
    key = key_of(q, state)

    def errors(context: Context) -> tuple[list[float], list[float]]:
        h, v = context.series(reference or key)
        return h, [abs(value / context.analytic[key] - 1) for value in v]

    return errors


def as_printed(q: Quantity, printed: str, *, place: str = "", name: str = "") -> Comparison:
    """The formula against the number that its source computed from it: the last digit decides.

    `printed` is a value of the suite's papers ("paper:id"), or a number with its unit as any other
    source prints it at `place` ("77.25 MPa").
    """
    found = printed if ":" in printed else literal(printed, q.what, place)
    check = PrintedTheory(name=name or f"{q.label}, as printed", symbol=q.symbol, unit=q.unit,
                          analytic=q.name, reference=found)  # fmt: skip
    return Comparison(check=check, quantity=q)


def balance(
    residual: str, name: str, symbol: str, unit: str, *, of: Mapping[str, float], bound: float,
    because: str,
) -> Comparison:  # fmt: skip
    """A balance that the reference satisfies to round-off: |residual| <= bound x scale `of`."""
    check = checks.Exact(name=name, symbol=symbol, unit=unit, fem=residual, scale=next(iter(of)),
                         bound=bound, bound_reason=because)  # fmt: skip
    return Comparison(check=check, numbers=of)


def fact(
    name: str, symbol: str, margin: Callable[[Context], tuple[float, float]], *, solves: bool = True
) -> Comparison:
    """A statement that holds if its margin exceeds the margin's expanded uncertainty."""
    check = checks.Fact(name=name, symbol=symbol, unit="1", margin=margin, fem_needed=solves)
    return Comparison(check=check)


def _compared(
    kind: Callable[..., Check], q: Quantity, reference: str, options: Options,
    more: Mapping[str, Any], numbers: Mapping[str, Number] | None = None,
) -> Comparison:  # fmt: skip
    if unknown := sorted(options.keys() - Options.__annotations__.keys()):
        known = ", ".join(Options.__annotations__)
        raise q.broken(f"comparisons have no argument {unknown[0]}; those are: {known}")
    state = options.get("state")
    name, symbol, key = q.label, q.symbol, key_of(q, state)
    own = key.replace(q.name, q.form_of, 1) if q.form_of else key
    if against := options.get("against", ""):
        name = f"{name}, against {against}"
    if state:
        name, symbol = f"{name}, {state.words}", state.symbol.format(symbol)
    demand, reason = options.get("sensitivity", (judge.DEMAND, ""))
    stated: dict[str, Any] = dict(more)
    if "own" in options:
        stated["own_demand"], stated["own_reason"] = options["own"]
    check = kind(
        name=options.get("name", name), symbol=options.get("symbol", symbol),
        unit=options.get("unit", q.unit), analytic=key, fem=reference or own,
        formal=options.get("order"), by=options.get("by", ""), demand=demand, demand_reason=reason,
        printed=options.get("printed", ()), **stated,
    )  # fmt: skip
    return Comparison(check=check, quantity=q, state=state, numbers=numbers or {},
                      shares=options.get("shares", ""))  # fmt: skip

"""Comparisons of formulas with a reference, by kind; `verify.judging` judges each of them.

A check of `verify.judging` for which there is no function here can be yielded directly, or in a
`Comparison` with the quantity that it judges.
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

    If the interval is too wide for judging at these inputs, `sharp` is False and the error is only
    displayed.
    """

    low: float
    high: float
    source: str
    sharp: bool = True


class Computed(NamedTuple):
    """An expected error that takes long to compute; `interval` is called when the row is judged.

    `interval` returns the lower and upper limit, or None if the range is too wide for judging.
    """

    interval: Callable[[], tuple[float, float] | None]
    source: str


def about(error: float, slack: float, source: str) -> Expected:
    """Expected error within ± `slack` of `error`."""
    return Expected(error - slack, error + slack, source)


def underived(reason: str) -> Expected:
    """Placeholder for an expected error that cannot be derived; the error is only displayed."""
    return Expected(-inf, inf, reason, sharp=False)


@dataclass(frozen=True)
class State:
    """Another state for which the formulas are evaluated, such as another load or length.

    `case` has the quantities of this state, such as `self.at(T=...)`; it is None if the state does
    not exist at these inputs. Names of the numbers of formulas and reference end in `key`, which is
    empty for the state of the inputs. Names of rows end in `words`. `symbol` is a format string for
    the symbols. Numbers of a state that is not `displayed` are compared in rows, but `check` does
    not print them.
    """

    case: object | None
    key: str
    words: str
    symbol: str = "{}"
    displayed: bool = True


def key_of(q: Quantity, state: State | None) -> str:
    """Name of a quantity's number in a state, such as "d_i_rigid"."""
    return f"{q.name}_{state.key}" if state and state.key else q.name


class Options(TypedDict, total=False):
    """Options of every comparison of a quantity with a reference.

    `order` is the theoretical order of convergence of the reference. `against` distinguishes
    several rows of one quantity. `name`, `symbol` and `unit` replace those of the declared
    quantity. `state` is a state other than that of the inputs. `sensitivity` is the smallest error
    that must make the row fail; for inputs of a user, `own` replaces it if `own` is larger.
    `by` is the method of the reference, if it is not finite elements. `printed` are values of the
    papers for the row ("paper:id"). `shares` states what formula and reference have in common.
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

    `shares` states what formula and reference have in common in addition to the inputs. `expected`
    is the expected error of an approximation.
    """

    check: Check
    quantity: Quantity | None = None
    state: State | None = None
    numbers: Mapping[str, Number] = field(default_factory=dict)
    shares: str = ""
    expected: Expected | Computed | None = None

    @property
    def name(self) -> str:
        """Name of the comparison's row, unique in the case."""
        return str(getattr(self.check, "name", ""))

    @property
    def key(self) -> str:
        """Key of the formula's value; empty if no formula is judged."""
        return key_of(self.quantity, self.state) if self.quantity else ""

    def evaluated(self) -> dict[str, float]:
        """All `numbers` of the comparison [SI], and the value of the quantity in its state."""
        found = {key: finite(v() if callable(v) else v) for key, v in self.numbers.items()}
        if self.quantity and self.state and self.state.case and self.key not in found:
            found[self.key] = self.quantity.of(self.state.case)
        return {key: value for key, value in found.items() if value is not None}


def identity(
    q: Quantity, reference: str = "", *, scale: Scale | None = None,
    uncertainty: Number | None = None, **options: Unpack[Options],
) -> Comparison:  # fmt: skip
    """Comparison of a formula and a reference that solve the same problem.

    They differ by numerical errors only. `reference` is the name of the reference's number, by
    default that of the quantity. `scale` is the natural magnitude if the quantity may vanish:
    another quantity, or a number [SI] by its name. `uncertainty` is the uncertainty of a truncated
    series in the formula, relative to the scale.
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
    """Comparison of a formula that neglects an effect with a reference that includes it.

    The signed error of the formula must be in an interval derived beforehand. Because comparisons
    are stated before the reference is solved, no interval can be derived from the reference.
    """
    source = "" if expected is None else expected.source
    if expected is not None and not source:
        raise q.broken("give the source of the expected error")
    if isinstance(expected, Expected) and not expected.low <= expected.high:
        ends = f"{expected.low:g} to {expected.high:g}"
        raise q.broken(
            f"the lower limit of the expected error must not exceed the upper limit, got {ends}"
        )

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
    """Check that the error of a formula vanishes with a parameter, as a power of the parameter.

    `points` returns parameter, signed error and the standard uncertainty of the error, from all
    levels.
    """
    check = checks.Limit(name=name, symbol=symbol, unit="1", exponent=exponent,
                         points=lambda context: points(context.fem), demand=sensitivity[0],
                         demand_reason=sensitivity[1])  # fmt: skip
    return Comparison(check=check, quantity=q)


def over_family(
    q: Quantity, reference: str, *, at: Sequence[float], family: Callable[[float], object],
    order: float | None = None,
) -> Callable[[Sequence[FemResult]], Points]:  # fmt: skip
    """Function of the solved levels that returns the points (parameter, error, u) for `limit`.

    `family` returns the case for a value of the parameter; the array `reference` contains the
    results for all values `at`.
    """

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
    """Function that returns mesh sizes and the errors of the reference relative to a formula.

    The returned function is an argument of `Order`.
    """
    key = key_of(q, state)

    def errors(context: Context) -> tuple[list[float], list[float]]:
        h, v = context.series(reference or key)
        return h, [abs(value / context.analytic[key] - 1) for value in v]

    return errors


def as_printed(q: Quantity, printed: str, *, place: str = "", name: str = "") -> Comparison:
    """Comparison of a formula with the number that its source computed from it.

    U is 2/sqrt(3) times half a unit of the last printed digit. `printed` is a value of the suite's
    papers ("paper:id"), or a number with its unit as another source prints it at `place` ("77.25
    MPa").
    """
    found = printed if ":" in printed else literal(printed, q.what, place)
    check = PrintedTheory(name=name or f"{q.label}, as printed", symbol=q.symbol, unit=q.unit,
                          analytic=q.name, reference=found)  # fmt: skip
    return Comparison(check=check, quantity=q)


def balance(
    residual: str, name: str, symbol: str, unit: str, *, of: Mapping[str, float], bound: float,
    because: str,
) -> Comparison:  # fmt: skip
    """Check of a balance that the reference satisfies to round-off: |residual| <= bound x scale.

    `of` contains the name and value of the scale.
    """
    check = checks.Exact(name=name, symbol=symbol, unit=unit, fem=residual, scale=next(iter(of)),
                         bound=bound, bound_reason=because)  # fmt: skip
    return Comparison(check=check, numbers=of)


def fact(
    name: str, symbol: str, margin: Callable[[Context], tuple[float, float]], *, solves: bool = True
) -> Comparison:
    """Check of a statement that holds if its margin exceeds the margin's expanded uncertainty."""
    check = checks.Fact(name=name, symbol=symbol, unit="1", margin=margin, fem_needed=solves)
    return Comparison(check=check)


def _compared(
    kind: Callable[..., Check], q: Quantity, reference: str, options: Options,
    more: Mapping[str, Any], numbers: Mapping[str, Number] | None = None,
) -> Comparison:  # fmt: skip
    if unknown := sorted(options.keys() - Options.__annotations__.keys()):
        known = ", ".join(Options.__annotations__)
        raise q.broken(f"comparisons have no argument {unknown[0]}; possible arguments: {known}")
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

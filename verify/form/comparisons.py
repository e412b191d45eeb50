"""What formulas are compared with: kinds of comparisons, each judged by `verify.judging`."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

from verify.core.case import Check, Context, FemResult
from verify.form.quantity import Quantity
from verify.judging import checks, judge
from verify.judging.convergence import grid_convergence

Points = tuple[list[float], list[float], list[float]]  # parameter, error, standard uncertainty
Required = tuple[float, str]  # smallest relative error that must make the row fail, and why
DEFAULT: Required = (judge.DEMAND, "")


class Expected(NamedTuple):
    """Signed error formula/reference - 1 that is expected, and where that comes from.

    One that is too wide to judge by for these inputs is not `sharp`: the error is only displayed.
    """

    low: float
    high: float
    source: str
    sharp: bool = True


def about(error: float, slack: float, source: str) -> Expected:
    """An expected error within `slack` of a value."""
    return Expected(error - slack, error + slack, source)


@dataclass(frozen=True, kw_only=True)
class Comparison:
    """A check, the formula that it judges, and further `numbers` [SI] that the check needs."""

    check: Check
    quantity: Quantity | None = None
    numbers: Mapping[str, float] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """The name of its row, which no other comparison of the case has."""
        return str(getattr(self.check, "name", ""))

    def named(self, name: str = "", symbol: str = "") -> "Comparison":
        """With another name or symbol of its row than those that follow from the declaration."""
        given = {k: v for k, v in (("name", name), ("symbol", symbol)) if v}
        check: Any = self.check
        return replace(self, check=replace(check, **given))


def identity(
    q: Quantity, reference: str = "", *, order: float | None = None, against: str = "",
    sensitivity: Required = DEFAULT, scale: Quantity | None = None,
) -> Comparison:  # fmt: skip
    """Formula and reference solve one problem and differ by numerical error only.

    `reference` names the reference's number, by default as the quantity; `order` is its order of
    convergence in theory; `against` distinguishes rows of one quantity; `scale` is the natural
    magnitude where the quantity may vanish.
    """
    return _compared(checks.Identity, q, reference, order, against, sensitivity,
                     scale=scale.name if scale else "")  # fmt: skip


def approximation(
    q: Quantity, reference: str = "", *, expected: Expected | None, order: float | None = None,
    against: str = "", sensitivity: Required = DEFAULT,
) -> Comparison:  # fmt: skip
    """The formula neglects something; the signed error lies where it was expected beforehand.

    Comparisons are stated before the reference is solved: no interval can be read off it.
    """
    interval = (expected.low, expected.high) if expected and expected.sharp else None
    source = "" if expected is None else expected.source
    return _compared(checks.Approximation, q, reference, order, against, sensitivity,
                     interval=lambda *_: interval, source=source)  # fmt: skip


def limit(
    q: Quantity, name: str, symbol: str, *, points: Callable[[Sequence[FemResult]], Points],
    exponent: float | None, sensitivity: Required = DEFAULT,
) -> Comparison:  # fmt: skip
    """The formula becomes exact as a parameter goes to 0 and errs with a power of it.

    `points` reads parameter, signed error and its standard uncertainty off all levels.
    """
    check = checks.Limit(name=name, symbol=symbol, unit="1", exponent=exponent,
                         points=lambda context: points(context.fem), demand=sensitivity[0],
                         demand_reason=sensitivity[1])  # fmt: skip
    return Comparison(check=check, quantity=q)


def over_family(
    q: Quantity, reference: str, *, at: Sequence[float], family: Callable[[float], object],
    order: float | None = None,
) -> Callable[[Sequence[FemResult]], Points]:  # fmt: skip
    """Points of a limit: `family` is the case of one value, `reference` the results `at` all."""

    def points(levels: Sequence[FemResult]) -> Points:
        sizes, d, u = [level.h for level in levels], [], []
        for k, parameter in enumerate(at):
            v = [float(level.arrays[reference][k]) for level in levels]
            grid = grid_convergence(sizes, v, formal=order, scale=abs(v[-1]))
            d.append(getattr(family(parameter), q.name) / v[-1] - 1)
            u.append(judge.numerical_uncertainty(grid) / abs(v[-1]))
        return list(at), d, u

    return points


def balance(
    residual: str, name: str, symbol: str, unit: str, *, of: Mapping[str, float], bound: float,
    because: str,
) -> Comparison:  # fmt: skip
    """A balance that the reference meets to round-off: |residual| <= bound x scale, named `of`."""
    check = checks.Exact(name=name, symbol=symbol, unit=unit, fem=residual, scale=next(iter(of)),
                         bound=bound, bound_reason=because)  # fmt: skip
    return Comparison(check=check, numbers=of)


def fact(
    name: str, symbol: str, margin: Callable[[Context], tuple[float, float]], *, solves: bool = True
) -> Comparison:
    """A statement that holds where its margin exceeds the margin's expanded uncertainty."""
    check = checks.Fact(name=name, symbol=symbol, unit="1", margin=margin, fem_needed=solves)
    return Comparison(check=check)


def _compared(
    kind: Callable[..., Check], q: Quantity, reference: str, order: float | None, against: str,
    sensitivity: Required, **more: Any,
) -> Comparison:  # fmt: skip
    name = f"{q.label}, against {against}" if against else q.label
    check = kind(name=name, symbol=q.symbol, unit=q.unit, analytic=q.name, formal=order,
                 fem=reference or q.form_of or q.name, demand=sensitivity[0],
                 demand_reason=sensitivity[1], **more)  # fmt: skip
    return Comparison(check=check, quantity=q)

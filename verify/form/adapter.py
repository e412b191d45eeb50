"""Conversion of a declared case into the record that jobs, studies and reports use."""

import inspect
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import fields, replace
from functools import cache
from math import isfinite
from pathlib import Path
from typing import Any, ClassVar

from pydantic import ValidationError

from verify.core import case as core
from verify.core.case import Check, Context, FemResult, Output, Values
from verify.core.figures import Figure
from verify.form import dimensions, equations, independence
from verify.form.case import MESHES, Case
from verify.form.comparisons import Comparison, State
from verify.form.execution import executed
from verify.form.later import Later
from verify.form.members import check_names, reached
from verify.form.quantity import CaseError, Quantity, solving


def adapted(form: type[Case], *, time_limit: float | None = None) -> core.Case:
    """Record of the case declared by the class `form`.

    The comparisons have the names that they have at the default inputs; the compared numbers can be
    computed for any inputs. `time_limit` [s] applies to the formulas and to each level of the
    reference. Comparisons are made when they are first read: a process makes only those of the
    cases that it uses.
    """

    def default() -> Case:
        return _default(form, time_limit)

    own = time_limit is not None

    return core.Case(
        id=form.id, title=form.title, paper=form.source, place=form.place,
        lead=" ".join((inspect.getdoc(form) or "").split()),
        inputs=form, analytic=Formulas(form, time_limit),
        reference=Reference(form, time_limit), method=form.method,
        levels=getattr(form, "levels", MESHES),
        checks=Later(lambda: tuple(_check(one, own) for one in default().stated())),
        outputs=Later(lambda: tuple(_outputs(default()))), readings=form.readings,
        assumptions=form.assumptions, scans=form.scans,
        portions=form.portions, dynamic=form.dynamic,
        findings=lambda q, _values: tuple(q.advice()),
        summary=lambda q, _values: q.summary(),
        warnings=lambda q, _values: tuple(q.warnings()),
        equations=lambda q, _values: (*q.laws(), *equations.stated(q)),
        tables=lambda context: tuple(context.inputs.tables(context)),
        too_large=lambda q: q.refusal(), sketch=lambda q: q.sketch(), figures=_figures,
        pictures=lambda q: tuple(q.pictures()),
    )  # fmt: skip


@cache
def _default(form: type[Case], time_limit: float | None) -> Case:
    """Instance of the case with the default inputs and its comparisons.

    Raises CaseError if the case breaks a rule for cases. Here, dimensions of equations are
    checked for cases outside the suite only; for cases of the suite, tests check them.
    """
    check_names(form)
    case = _valid(form)
    with executed(inspect.getfile(form), time_limit):
        names = Counter(one.name for one in case.stated())
        if twice := next((one for one in case.stated() if names[one.name] > 1), None):
            raise _twice(form, twice)
        if time_limit is not None:  # outside the suite
            dimensions.check(case)
    return case


def _valid(form: type[Case]) -> Case:
    """Instance with the default inputs, validated against their bounds."""
    try:
        return form().at()
    except ValidationError as error:
        first = error.errors()[0]
        name = ".".join(map(str, first["loc"]))
        rule = f"the default of {name}: {first['msg']}" if name else first["msg"]
        raise CaseError(f"{Path(inspect.getfile(form)).name}: {form.__name__}: {rule}") from error


def _twice(form: type[Case], one: Comparison) -> CaseError:
    rule = f"two comparisons have the name {one.name}; give `against` or `name` to distinguish them"
    file = Path(inspect.getfile(form)).name
    return one.quantity.broken(rule) if one.quantity else CaseError(f"{file}: {rule}")


class _Side:
    """Base class of the two functions of a case: its formulas and its reference."""

    name: ClassVar[str]

    def __init__(self, form: type[Case], time_limit: float | None) -> None:
        self.form, self.file, self.time_limit = form, inspect.getfile(form), time_limit
        self.__module__ = form.__module__
        self.__name__ = f"{form.__name__}.{self.name}"


class Formulas(_Side):
    """Function that returns all quantities and comparisons of a case (name: value [SI])."""

    name = "quantities"

    def code(self, read: Collection[str] = ()) -> tuple[tuple[str, str, tuple[str, ...]], ...]:
        """Members whose code is part of the hash of the formulas: module, class and names.

        They include the members `read`.
        """
        names = [*(q.name for q in self.form.quantities()), "comparisons"]  # both have numbers
        return reached(self.form, [*names, *read], formulas=True)

    def __call__(self, case: Case) -> Values:
        with executed(self.file, self.time_limit):
            values = {q.name: float(getattr(case, q.name)) for q in case.present()}
            for one in case.stated():
                values |= one.evaluated()
        return values


class Reference(_Side):
    """Function that solves one level of a case's reference; it must not read any formula."""

    name = "reference"

    def code(self, read: Collection[str] = ()) -> tuple[tuple[str, str, tuple[str, ...]], ...]:
        """Members whose code is part of the hash of the reference: module, class and names.

        They include the members `read`.
        """
        return reached(self.form, ["reference", *read], formulas=False)

    def __call__(self, case: Case, level: int) -> FemResult:
        before = solving.set(True)
        try:
            with executed(self.file, self.time_limit):
                found = case.reference(level)
        finally:
            solving.reset(before)
        if self.time_limit is not None:  # outside the suite
            _check_numbers(found, f"{Path(self.file).name}: {self.__name__}: level {level}")
        return found


def _check_numbers(found: object, place: str) -> None:
    """Raise CaseError unless `found` is a result of `solved` with finite values."""
    if not isinstance(found, FemResult):
        raise CaseError(f"{place} must return solved(...), got {type(found).__name__}")
    for key, value in found.values.items():
        if not isfinite(value):
            raise CaseError(f"{place}: the value {key} must be finite, got {value:g}")


def _outputs(default: Case) -> Iterator[Output]:
    """Outputs of a case: its quantities, also in the other states at which they are compared."""
    stated = [one for one in default.stated() if one.quantity]
    hidden = {one.quantity for one in stated if one.state and not one.state.displayed}
    compared = {
        one.key: (one.quantity, one.state) for one in stated
        if not one.state or one.state.displayed
    }  # fmt: skip
    for q in default.quantities():
        _, state = compared.get(q.name, (q, None))
        yield _output(q, q.name, state, judged=q.name in compared or q in hidden)
    for key, (quantity, state) in compared.items():
        if quantity and state and state.key:
            yield _output(quantity, key, state, judged=True)


def _output(q: Quantity, key: str, state: State | None, *, judged: bool) -> Output:
    symbol, what = q.symbol, q.label
    if state:
        symbol, what = state.symbol.format(symbol), f"{what}, {state.words}"
    return Output(
        key=key, symbol=symbol, unit=q.unit, what=what, judged=judged, equation=q.equation,
        source=q.source, form=q.form, safe=q.safe,
    )  # fmt: skip


def _check(one: Comparison, own: bool) -> Check:
    """Check of a comparison for any inputs of the case.

    The functions of `one.check` may contain the default inputs, at which `one` was declared. Each
    function of the returned check therefore declares the comparison again for the inputs in its
    first argument (inputs or context), and calls the function of the new check.
    """
    check: Any = one.check
    functions = [
        f.name for f in fields(check)
        if callable(value := getattr(check, f.name)) and not isinstance(value, type)
    ]  # fmt: skip
    found = {name: _of_inputs(one.name, name, own) for name in functions}
    made: Check = replace(check, **found, **_stated(one), shares=one.shares or check.shares)
    return made


def _stated(one: Comparison) -> dict[str, str]:
    """Fields of a check that describe the formula of its comparison."""
    q = one.quantity
    if q is None:
        return {}
    return {"formula": one.key, "equation": q.equation or q.source, "form": q.form, "safe": q.safe}


def _of_inputs(name: str, function: str, own: bool) -> Callable[..., Any]:
    """Function that calls `function` of the check `name`, declared for the inputs in its argument.

    For a case outside the suite (`own`), it also checks that an expected error is independent of
    the formula that it judges; for the cases of the suite, tests check this.
    """

    def call(first: Any, *rest: Any) -> Any:
        case: Case = first.inputs if isinstance(first, Context) else first
        one = next((one for one in case.stated() if one.name == name), None)
        if one is None:
            raise CaseError(f"with these inputs, the case has no comparison with the name {name}")
        if own and function == "interval" and case.is_default:
            independence.check(case, one)
        return getattr(one.check, function)(first, *rest)

    return call


def _figures(context: Context) -> Sequence[Figure]:
    case: Case = context.inputs
    return tuple(one for figure in case.figures() for one in figure.drawn(context))

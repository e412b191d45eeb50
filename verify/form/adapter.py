"""A declared case as the record that the jobs, studies and reports of the suite work with."""

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
    """The case of a class: comparisons named for the default inputs, numbers for any inputs.

    `time_limit` [s] applies to its formulas and to each level. Comparisons are made when they are
    first read: a process makes only those of the cases that it uses.
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
    """The default inputs with their comparisons; CaseError for a rule that they break.

    Tests check the dimensions of the equations of the suite.
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
    """The default inputs, within their bounds, which pydantic does not check."""
    try:
        return form().at()
    except ValidationError as error:
        first = error.errors()[0]
        name = ".".join(map(str, first["loc"]))
        rule = f"the default of {name}: {first['msg']}" if name else first["msg"]
        raise CaseError(f"{Path(inspect.getfile(form)).name}: {form.__name__}: {rule}") from error


def _twice(form: type[Case], one: Comparison) -> CaseError:
    rule = f"two comparisons are called {one.name}; `against` or `name` distinguishes them"
    file = Path(inspect.getfile(form)).name
    return one.quantity.broken(rule) if one.quantity else CaseError(f"{file}: {rule}")


class _Side:
    """A side of a case as a function, with the module and the name that errors and lists show."""

    name: ClassVar[str]

    def __init__(self, form: type[Case], time_limit: float | None) -> None:
        self.form, self.file, self.time_limit = form, inspect.getfile(form), time_limit
        self.__module__ = form.__module__
        self.__name__ = f"{form.__name__}.{self.name}"


class Formulas(_Side):
    """Numbers of the quantities of a case, and further numbers of its comparisons, by name [SI]."""

    name = "quantities"

    def code(self, read: Collection[str] = ()) -> tuple[tuple[str, str, tuple[str, ...]], ...]:
        """Code at the beginning of the hash: module, class and members, also those `read`."""
        names = [*(q.name for q in self.form.quantities()), "comparisons"]  # both have numbers
        return reached(self.form, [*names, *read], formulas=True)

    def __call__(self, case: Case) -> Values:
        with executed(self.file, self.time_limit):
            values = {q.name: float(getattr(case, q.name)) for q in case.present()}
            for one in case.stated():
                values |= one.evaluated()
        return values


class Reference(_Side):
    """A case's reference; formulas are out of its reach while it solves."""

    name = "reference"

    def code(self, read: Collection[str] = ()) -> tuple[tuple[str, str, tuple[str, ...]], ...]:
        """Code at the beginning of the hash: module, class and members, also those `read`."""
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
    """CaseError if a level is not of the type of `solved`, or has a number that is not finite."""
    if not isinstance(found, FemResult):
        raise CaseError(f"{place} returns {type(found).__name__}, not solved(...)")
    for key, value in found.values.items():
        if not isfinite(value):
            raise CaseError(f"{place}: {key} is {value:g}")


def _outputs(default: Case) -> Iterator[Output]:
    """The quantities, and those of other states that are compared and displayed."""
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
    """The check of a comparison, with functions for the present inputs.

    A function of a check has the inputs or the context as its first argument, and may belong to the
    instance that made it: here, that of the default inputs.
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
    """Statement of a comparison about its formula."""
    q = one.quantity
    if q is None:
        return {}
    return {"formula": one.key, "equation": q.equation or q.source, "form": q.form, "safe": q.safe}


def _of_inputs(name: str, function: str, own: bool) -> Callable[..., Any]:
    """The function with this name for a check.

    In the case of a user (`own`), an expected error must be independent of the reference; for the
    cases of the suite, tests verify this.
    """

    def call(first: Any, *rest: Any) -> Any:
        case: Case = first.inputs if isinstance(first, Context) else first
        one = next((one for one in case.stated() if one.name == name), None)
        if one is None:
            raise CaseError(f"these inputs have no comparison called {name}")
        if own and function == "interval" and case.is_default:
            independence.check(case, one)
        return getattr(one.check, function)(first, *rest)

    return call


def _figures(context: Context) -> Sequence[Figure]:
    case: Case = context.inputs
    return tuple(one for figure in case.figures() for one in figure.drawn(context))

"""A declared case as the record that the jobs, studies and reports of the suite work with."""

import inspect
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, ClassVar

from verify.core import case as core
from verify.core.case import Check, Context, FemResult, Output, Values
from verify.core.figures import Figure
from verify.form import equations
from verify.form.case import Case
from verify.form.comparisons import Comparison
from verify.form.members import reached
from verify.form.quantity import CaseError, faults_located, solving
from verify.judging.checks import Approximation, Limit


def adapted(form: type[Case]) -> core.Case:
    """The case of a class: comparisons by name as of the default inputs, numbers of any inputs."""
    default = form()
    named = [one.name for one in default.stated()]
    if double := next((name for name in named if named.count(name) > 1), ""):
        raise CaseError(f"{form.__module__}: {form.__name__}: two comparisons are called {double}")
    judged = {one.quantity.name for one in default.stated() if one.quantity}
    return core.Case(
        id=form.id, title=form.title, paper=form.source, place=form.place,
        lead=" ".join((inspect.getdoc(form) or "").split()),
        inputs=form, analytic=Formulas(form), reference=Reference(form), method=form.method,
        levels=form.levels, checks=tuple(_check(one) for one in default.stated()),
        outputs=tuple(
            Output(key=q.name, symbol=q.symbol, unit=q.unit, what=q.label, judged=q.name in judged)
            for q in form.quantities()
        ),
        readings=form.readings, assumptions=form.assumptions, scans=form.scans,
        findings=lambda q, _values: tuple(q.advice()),
        warnings=lambda q, _values: tuple(q.warnings()),
        equations=lambda q, _values: equations.stated(q),
        too_large=lambda q: q.refusal(), sketch=lambda q: q.sketch(), figures=_figures,
        pictures=lambda q: tuple(q.pictures()),
    )  # fmt: skip


class _Side:
    """A side of a case as a function, with the module and the name that errors and lists show."""

    name: ClassVar[str]

    def __init__(self, form: type[Case]) -> None:
        self.form, self.file = form, inspect.getfile(form)
        self.__module__ = form.__module__
        self.__name__ = f"{form.__name__}.{self.name}"


class Formulas(_Side):
    """Numbers of a case's quantities and further ones of its comparisons, by name [SI]."""

    name = "quantities"

    def code(self) -> tuple[tuple[str, str, tuple[str, ...]], ...]:
        """What a hash of its code begins with: module, class and members."""
        return reached(self.form, [q.name for q in self.form.quantities()], formulas=True)

    def __call__(self, case: Case) -> Values:
        more: dict[str, float] = {}
        with faults_located(self.file):
            values = {q.name: float(getattr(case, q.name)) for q in case.quantities()}
            for one in case.stated():
                more |= one.numbers
        return values | more


class Reference(_Side):
    """A case's reference; formulas are out of its reach while it solves."""

    name = "reference"

    def code(self) -> tuple[tuple[str, str, tuple[str, ...]], ...]:
        """What a hash of its code begins with: module, class and members."""
        return reached(self.form, ["reference"], formulas=False)

    def __call__(self, case: Case, level: int) -> FemResult:
        before = solving.set(True)
        try:
            with faults_located(self.file):
                return case.reference(level)
        finally:
            solving.reset(before)


def _check(one: Comparison) -> Check:
    """The check of a comparison, whose parts that depend on the inputs are those of any inputs."""
    if isinstance(one.check, Approximation):
        return replace(one.check, interval=lambda q, v: _of(q, one.name).interval(q, v))
    if isinstance(one.check, Limit):
        return replace(one.check, points=lambda c: _of(c.inputs, one.name).points(c))
    return one.check


def _of(case: Case, name: str) -> Any:
    return next(one.check for one in case.stated() if one.name == name)


def _figures(context: Context) -> Sequence[Figure]:
    case: Case = context.inputs
    drawn = (figure.drawn(case, context) for figure in case.figures())
    return tuple(one for one in drawn if one is not None)

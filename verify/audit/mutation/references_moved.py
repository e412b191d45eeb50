"""Deliberate change of each row's reference; the row is then judged again and should fail.

All comparisons are judged in `verify.judging.judge`. The function `moved` changes only the
reference there, neither tolerance nor scale nor expected values. Stored finite elements are judged
again; none are solved.

The reference r is multiplied by 1 + p; if r is zero, p times the scale of the row is added. If the
scale differs from |r|, p times the scale is tried as well. The requirement uses the change by p
times r, which is stricter if |r| is less than the scale. For an approximation, the formula is
multiplied, because the row bounds the error of the formula. For an asymptotic limit, the formula is
multiplied at all points, so that its relative error d becomes (1 + d)(1 + p) - 1. The reference of
a balance is zero.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from verify.core.case import Case, Check, Context
from verify.core.inputs import InputError
from verify.core.results import Kind, Row, Status
from verify.jobs import cache
from verify.judging import judge

PERTURBATIONS = (0.005, -0.005, 0.01, -0.01, 0.05, -0.05, -0.09)
COMPARED = (Kind.IDENTITY, Kind.APPROXIMATION, Kind.TREND, Kind.ASYMPTOTIC, Kind.EXACT)
ALIKE = 0.01  # relative difference up to which scale and reference are the same magnitude
CONVERGENCE = ": convergence"  # end of the name of the convergence row of a comparison

Red = frozenset[float]  # the perturbations that turn a row red


@dataclass(frozen=True)
class Tried:
    """A row, and the changes of its reference at which the row fails.

    Changes are fractions: of the reference (`red`), or of the scale of the row (`red_of_scale`).
    """

    row: Row
    red: Red = frozenset()
    red_of_scale: Red = frozenset()

    @property
    def compared(self) -> bool:
        """Whether the row has a reference that can be changed."""
        return self.row.kind in COMPARED


def of_paper(case: Case, folder: Path | None = None) -> Context:
    """Context of a case: default inputs, formula values, and all levels from the cache.

    Raises InputError if a level is missing.
    """
    inputs = case.inputs()
    found = []
    for level in case.levels:
        stored = cache.load(folder or cache.default_folder(), case, inputs, level)
        if stored is None:
            raise InputError(f"{case.id} level {level} is not solved: run `freewheel verify`")
        found.append(replace(stored, fields=()))  # pictures, which no row looks at
    return Context(case.id, inputs, case.analytic(inputs), found, is_paper=True)


def is_convergence(row: Row) -> bool:
    """Whether the row judges the convergence of a comparison and has no reference."""
    return row.kind is Kind.FACT and row.quantity.endswith(CONVERGENCE)


def tried(check: Check, context: Context) -> list[Tried]:
    """Rows of a check, each with the changes of its reference and scale at which it fails."""
    rows = check.rows(context)
    if not any(row.kind in COMPARED for row in rows):
        return [Tried(row) for row in rows]
    red = {p: reddened(check, context, p) for p in PERTURBATIONS}
    red_of_scale = red
    if any(_scale_is_another(row) for row in rows):
        red_of_scale = {p: reddened(check, context, p, of_scale=True) for p in PERTURBATIONS}

    def of(row: Row, found: dict[float, set[str]]) -> Red:
        return frozenset(p for p, names in found.items() if row.quantity in names)

    return [
        Tried(row, of(row, red), of(row, red_of_scale)) if row.kind in COMPARED else Tried(row)
        for row in rows
    ]


def _scale_is_another(row: Row) -> bool:
    """Whether the scale of the row differs from its reference by more than 1 %."""
    r, scale = row.analytic, row.scale
    return bool(r and scale and row.kind in COMPARED and abs(abs(r) / scale - 1) > ALIKE)


def reddened(check: Check, context: Context, p: float, *, of_scale: bool = False) -> set[str]:
    """Names of a check's rows that fail if all references are changed by the fraction `p`."""
    with moved(p, of_scale=of_scale):
        return red_names(check, context)


def red_names(check: Check, context: Context) -> set[str]:
    """Names of a check's rows that fail; all rows if the check raises an error."""
    try:
        rows = check.rows(context)
    except (ValueError, ArithmeticError):  # errors of formulas for impossible values
        return {row.quantity for row in check.skipped(context.case, "")}
    return {row.quantity for row in rows if row.status is Status.FAIL}


@contextmanager
def moved(p: float, *, of_scale: bool = False) -> Iterator[None]:
    """Context in which references change by `p` times the reference, or by `p` times the scale."""
    changed = _Moved(p, of_scale)
    kept = {name: getattr(judge, name) for name in SEAMS}
    try:
        for name in SEAMS:
            setattr(judge, name, getattr(changed, name))
        yield
    finally:
        for name, function in kept.items():
            setattr(judge, name, function)


SEAMS = ("difference", "approximation", "exact", "fit_limit")  # of `verify.judging.judge`


class _Moved:
    """Variants of functions of `judge` that change the reference by `p` before they compare."""

    def __init__(self, p: float, of_scale: bool) -> None:
        self.p, self.of_scale = p, of_scale
        self._difference, self._approximation = judge.difference, judge.approximation
        self._exact, self._fit_limit = judge.exact, judge.fit_limit

    def _from(self, r: float, scale: float) -> float:
        return r + self.p * scale if self.of_scale or r == 0 else r * (1 + self.p)

    def difference(
        self, value: float, reference: float, *, scale: float, **more: Any
    ) -> judge.Verdict:
        return self._difference(value, self._from(reference, scale), scale=scale, **more)

    def approximation(self, formula: float, reference: float, **more: Any) -> judge.Verdict:
        return self._approximation(self._from(formula, abs(reference)), reference, **more)

    def exact(self, residual: float, *, scale: float, **more: Any) -> judge.Verdict:
        return self._exact(residual + self.p * scale, scale=scale, **more)

    def fit_limit(
        self, eps: Sequence[float], d: Sequence[float], u: Sequence[float]
    ) -> judge.LimitFit:
        p = self.p
        return self._fit_limit(
            eps, [x + p if self.of_scale else (1 + x) * (1 + p) - 1 for x in d], u
        )

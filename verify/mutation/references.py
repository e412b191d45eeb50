"""Every row's reference changed on purpose, and the row judged again: does it turn red?

The seam is `verify.judge`, through which every comparison goes: `moved` changes the reference there
and nothing else, neither tolerance nor scale nor what is expected. Stored finite elements are
judged anew; none are solved.

The reference r is multiplied by 1 + p; where it is zero, p times the row's scale is added. Where the
scale is another magnitude than |r|, p times the scale is judged as well: rows against a scale may
be blind to a share of a small r by right, but the gate asks for the strict one, p of r itself. Of an
approximation the formula is multiplied, whose error the row bounds; of a limit the formula at
all its points, so that d becomes (1 + d)(1 + p) - 1. A balance has the reference zero.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest import mock

from verify import cache, judge
from verify.case import Case, Check, Context
from verify.inputs import InputError
from verify.results import Kind, Row, Status

PERTURBATIONS = (0.005, -0.005, 0.01, -0.01, 0.05, -0.05, -0.09)
COMPARED = (Kind.IDENTITY, Kind.APPROXIMATION, Kind.TREND, Kind.ASYMPTOTIC, Kind.EXACT)
CONVERGENCE = ": convergence"  # ends the name of the row that stands beside a comparison

Red = frozenset[float]  # the perturbations that turn a row red


@dataclass(frozen=True)
class Tried:
    """A row as it is, and the perturbations of its reference, of the scale, that turn it red."""

    row: Row
    red: Red = frozenset()
    red_of_scale: Red = frozenset()


def of_paper(case: Case, folder: Path | None = None) -> Context:
    """The case's own inputs with levels from the cache; InputError where one is not there."""
    inputs = case.inputs()
    found = []
    for level in case.levels:
        stored = cache.load(folder or cache.default_folder(), case, inputs, level)
        if stored is None:
            raise InputError(f"{case.id}: level {level} is not in the cache: verify the case first")
        found.append(stored)
    return Context(case.id, inputs, case.analytic(inputs), found, is_paper=True)


def is_convergence(row: Row) -> bool:
    """Whether the row stands beside a comparison and has no reference of its own."""
    return row.kind is Kind.FACT and row.quantity.endswith(CONVERGENCE)


def tried(check: Check, context: Context) -> list[Tried]:
    """The rows of a check, each with the perturbations that turn it red."""
    rows = check.rows(context)
    if not any(row.kind in COMPARED for row in rows):
        return [Tried(row) for row in rows]
    red, red_of_scale = (
        [reddened(check, context, p, of_scale=of_scale) for p in PERTURBATIONS]
        for of_scale in (False, True)
    )
    return [
        Tried(row, _of(row, red), _of(row, red_of_scale)) if row.kind in COMPARED else Tried(row)
        for row in rows
    ]


def _of(row: Row, red: Sequence[set[str]]) -> Red:
    return frozenset(p for p, names in zip(PERTURBATIONS, red, strict=True) if row.quantity in names)


def reddened(check: Check, context: Context, p: float, *, of_scale: bool = False) -> set[str]:
    """Names of a check's rows that are red where its references are moved by `p`."""
    with moved(p, of_scale=of_scale):
        return red_names(check, context)


def red_names(check: Check, context: Context) -> set[str]:
    """Names of a check's rows that are red; those of all where judging is refused."""
    try:
        rows = check.rows(context)
    except (ValueError, ArithmeticError):  # what a case raises on values that make no sense
        rows = check.skipped(context.case, "")
        return {row.quantity for row in rows}
    return {row.quantity for row in rows if row.status is Status.FAIL}


@contextmanager
def moved(p: float, *, of_scale: bool = False) -> Iterator[None]:
    """Judging with every reference moved by `p` of itself, or of the scale."""
    functions: dict[str, Callable[..., Any]] = {
        "difference": _difference, "approximation": _approximation, "exact": _exact,
        "fit_limit": _fit_limit,
    }  # fmt: skip

    def bound(name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        original = getattr(judge, name)
        return lambda *given, **more: function(original, p, of_scale, *given, **more)

    with mock.patch.multiple(judge, **{n: bound(n, f) for n, f in functions.items()}):
        yield


def _shifted(r: float, scale: float, p: float, of_scale: bool) -> float:
    return r + p * scale if of_scale or r == 0 else r * (1 + p)


def _difference(
    judged: Callable[..., judge.Verdict], p: float, of_scale: bool, value: float, reference: float,
    *, scale: float, **more: Any,
) -> judge.Verdict:  # fmt: skip
    return judged(value, _shifted(reference, scale, p, of_scale), scale=scale, **more)


def _approximation(
    judged: Callable[..., judge.Verdict], p: float, of_scale: bool, formula: float,
    reference: float, **more: Any,
) -> judge.Verdict:  # fmt: skip
    return judged(_shifted(formula, abs(reference), p, of_scale), reference, **more)


def _exact(
    judged: Callable[..., judge.Verdict], p: float, _of_scale: bool, residual: float, *,
    scale: float, **more: Any,
) -> judge.Verdict:  # fmt: skip
    return judged(residual + p * scale, scale=scale, **more)


def _fit_limit(
    fitted: Callable[..., judge.LimitFit], p: float, of_scale: bool, eps: Sequence[float],
    d: Sequence[float], u: Sequence[float],
) -> judge.LimitFit:  # fmt: skip
    return fitted(eps, [x + p if of_scale else (1 + x) * (1 + p) - 1 for x in d], u)

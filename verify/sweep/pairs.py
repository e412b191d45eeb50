"""What a sweep compares: the rows of a case that set a formula beside finite elements."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from verify import judge
from verify.case import Case, Portion
from verify.checks import Approximation, Identity
from verify.convergence import grid_convergence
from verify.inputs import InputError
from verify.results import Kind

LEVELS = 3  # that an error bar needs
DOUBTFUL = 0.01  # of a value: what a series that doesn't converge may scatter and still count


@dataclass(frozen=True)
class Pair:
    """A formula's value `analytic` and the finite-element value `fem`, by their keys.

    `scale` is the key of the natural magnitude that a difference is related to; the finite-element
    value itself where empty. `by` names what stands in the place of finite elements, if anything.
    """

    name: str
    symbol: str
    unit: str
    kind: Kind
    analytic: str
    fem: str
    scale: str
    formal: float | None
    by: str


@dataclass(frozen=True)
class Compared:
    """One pair at one point, in SI units: formula, finite elements, and their expanded uncertainty.

    `error` is (formula - FE)/scale with the expanded uncertainty `U_error`; `problem` says why
    there is none.
    """

    formula: float
    fe: float
    U: float
    error: float
    U_error: float
    problem: str = ""


def pairs(case: Case) -> tuple[Pair, ...]:
    """All pairs of a case, in the order of its rows."""
    return tuple(
        Pair(
            name=check.name, symbol=check.symbol, unit=check.unit, kind=check.kind,
            analytic=check.analytic, fem=check.fem, scale=check.scale, formal=check.formal,
            by=check.by,
        )
        for check in case.checks
        if isinstance(check, Identity | Approximation)
    )  # fmt: skip


def selected(case: Case, only: Sequence[str]) -> tuple[Pair, ...]:
    """The pairs whose name contains one of the texts `only`, all without; InputError for none.

    A text that is a whole name means that row alone.
    """
    every = pairs(case)
    if not every:
        raise InputError(f"{case.id} has no row that sets a formula beside finite elements")
    names = [pair.name for pair in every]
    for text in only:
        if not any(text.lower() in name.lower() for name in names):
            raise InputError(f"--only {text}: no row of {case.id} is called so: {'; '.join(names)}")
    wanted = [
        name for name in names
        if not only or any(
            name == text if text in names else text.lower() in name.lower() for text in only
        )
    ]  # fmt: skip
    return tuple(pair for pair in every if pair.name in wanted)


def whole(case: Case) -> Portion:
    """A case's own finite elements, on its coarsest levels, as the portion without a name."""
    keys = tuple(dict.fromkeys(pair.fem for pair in pairs(case)))
    return Portion(name="", fem=case.fem, levels=case.levels[:LEVELS], keys=keys)


def portion(case: Case, chosen: Sequence[Pair]) -> Portion:
    """The least of the case's finite elements that gives the values of the pairs."""
    keys = {pair.fem for pair in chosen}
    return next((p for p in case.portions if keys <= set(p.keys)), whole(case))


def compared(
    pair: Pair,
    formulas: Mapping[str, float],
    h: Sequence[float],
    values: Mapping[str, Sequence[float]],
    u_it: Mapping[str, float],
) -> Compared:
    """The pair at a point from the formulas' values and those of the levels, coarse to fine [SI].

    A series whose differences grow counts with three times its scatter while that is small.
    """
    r, v = formulas.get(pair.analytic, math.nan), values.get(pair.fem, ())
    if not v or not all(map(math.isfinite, (*v, r))):
        what = "the formula" if v and all(map(math.isfinite, v)) else "finite elements"
        return Compared(r, v[-1] if v else math.nan, math.nan, math.nan, math.nan,
                        f"{what}: no finite value")  # fmt: skip
    scale = abs(formulas[pair.scale]) if pair.scale else abs(v[-1])
    if not (scale > 0 and math.isfinite(scale)):
        return Compared(r, v[-1], math.nan, math.nan, math.nan, "nothing to relate it to")
    of_it = u_it.get(pair.fem, 0.0)
    grid = grid_convergence(h, v, formal=pair.formal, scale=scale, u_it=of_it)
    gci = grid.gci
    if not grid.converges:
        gci = 3 * (max(v[-LEVELS:]) - min(v[-LEVELS:]))
        if not (len(v) >= LEVELS and gci <= DOUBTFUL * scale):
            return Compared(r, v[-1], math.nan, math.nan, math.nan, "does not converge")
    U = judge.expanded(math.hypot(gci / 2, of_it))
    error = (r - v[-1]) / scale
    # where the value itself is the scale, formula/FE - 1 carries the quotient's own size
    U_error = U / scale * (1.0 if pair.scale else abs(r / v[-1]))
    return Compared(r, v[-1], U, error, U_error)

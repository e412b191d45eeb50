"""Compared pairs of a sweep: rows of a case that compare a formula with finite elements."""

import difflib
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from verify.core import source_code, units
from verify.core.case import Case, Context, FemResult, Portion
from verify.core.inputs import InputError
from verify.core.results import Kind, Row
from verify.judging import judge
from verify.judging.checks import Approximation, Identity
from verify.judging.claims import FemClaim
from verify.judging.convergence import GridConvergence, grid_convergence

LEVELS = 3  # that an error bar needs
MOST_NAMES = 5  # names that are suggested if nothing matches
LIKE = 0.75  # share of equal letters from which on a word is taken as mistyped
NO_FORMULA = "the formula has no finite value"  # a state that it does not have
NO_REFERENCE = "finite elements have no finite value"
DOUBTFUL = 0.01  # of a value: allowed scatter of a series that does not converge


@dataclass(frozen=True)
class Pair:
    """A row that compares a value of the formula with a value of finite elements.

    `analytic` and `fem` are the keys of the two values. `scale` is the key of the magnitude that
    differences are relative to; if it is empty, this is the finite-element value. `by` is the name
    of the method used instead of finite elements, if any.
    """

    name: str
    symbol: str
    unit: str
    kind: Kind
    analytic: str
    fem: str
    scale: str
    by: str
    claim: FemClaim

    @property
    def plain(self) -> bool:
        """Whether the row compares the two values themselves, not values derived from them."""
        return type(self.claim).rows in (Identity.rows, Approximation.rows)


@dataclass(frozen=True)
class Compared:
    """One pair at one point [SI]: formula, finite elements, and their expanded uncertainty.

    `error` is (formula - FE)/scale, and `U_error` its expanded uncertainty. If no error was
    computed, `problem` states the reason.
    """

    formula: float
    fe: float
    U: float
    error: float
    U_error: float
    problem: str = ""


def pairs(case: Case) -> tuple[Pair, ...]:
    """All pairs of a case in the order of its rows, except those for the paper's inputs only."""
    return tuple(
        Pair(
            name=claim.name, symbol=claim.symbol, unit=claim.unit, kind=claim.kind,
            analytic=claim.analytic, fem=claim.fem, scale=claim.scale, by=claim.by, claim=claim,
        )
        for claim in case.checks
        if isinstance(claim, FemClaim) and hasattr(claim, "analytic")
        and claim.swept and not claim.paper_only
    )  # fmt: skip


def signature(pair: Pair) -> list[Any]:
    """Data on which the numbers of a pair depend, in addition to the solutions.

    This includes the code of the row if the row derives the compared values.
    """
    derived = [] if pair.plain else [source_code.source_of(type(pair.claim))]
    return [pair.name, pair.analytic, pair.fem, pair.scale, pair.claim.formal, *derived]


def selected(case: Case, only: Sequence[str]) -> tuple[Pair, ...]:
    """Pairs whose name contains one of the texts `only`; all pairs if `only` is empty.

    A text that is a complete name selects only this row. Raises InputError if a text selects no row
    or the case has no pairs.
    """
    every = pairs(case)
    if not every:
        raise InputError(f"{case.id} has no row that compares a formula with finite elements")
    names = [pair.name for pair in every]
    for text in only:
        if not any(text.lower() in name.lower() for name in names):
            raise InputError(
                f"--only {text}: no row of {case.id} contains this text: {_offered(text, names)}"
            )
    wanted = [
        name for name in names
        if not only or any(
            name == text if text in names else text.lower() in name.lower() for text in only
        )
    ]  # fmt: skip
    return tuple(pair for pair in every if pair.name in wanted)


def _offered(text: str, names: Sequence[str]) -> str:
    """Text with the names most similar to `text`, or with the first names and their number."""
    scores = [
        sum(bool(difflib.get_close_matches(word, name.lower().split(), 1, LIKE))
            for word in text.lower().split()) for name in names
    ]  # fmt: skip
    if best := max(scores):
        near = [name for name, score in zip(names, scores, strict=True) if score == best]
        return f"near it are {'; '.join(near[:MOST_NAMES])}"
    more = len(names) - MOST_NAMES
    return "; ".join(names[:MOST_NAMES]) + (f" and {more} more" if more > 0 else "")


def whole(case: Case) -> Portion:
    """Portion with all finite-element values of the case, solved on its coarsest levels."""
    keys = tuple(dict.fromkeys(pair.fem for pair in pairs(case)))
    return Portion(name="", fem=case.reference, levels=case.levels[:LEVELS], keys=keys)


def portion(case: Case, chosen: Sequence[Pair]) -> Portion:
    """Smallest portion of the case whose finite-element values include those of the pairs."""
    keys = {pair.fem for pair in chosen}
    return next((p for p in case.portions if keys <= set(p.keys)), whole(case))


@dataclass(frozen=True)
class Known:
    """Values [SI] at one point: formulas by key, and finite elements of all levels by key.

    A value that a level does not have is NaN. `h` are the mesh sizes, from coarse to fine. `u_it`
    is the largest iteration uncertainty of all levels.
    """

    case: str
    inputs: Any
    formulas: Mapping[str, float]
    h: Sequence[float]
    fe: Mapping[str, Sequence[float]]
    u_it: Mapping[str, float]


def compared(pair: Pair, point: Known) -> Compared:
    """Result of the pair at a point.

    If the results do not converge with finer meshes, they are accepted if their scatter is small.
    """
    return _plainly(pair, point) if pair.plain else _by_its_row(pair, point)


def _plainly(pair: Pair, point: Known) -> Compared:
    r, v = point.formulas.get(pair.analytic, math.nan), point.fe.get(pair.fem, ())
    scale = abs(point.formulas[pair.scale]) if pair.scale else abs(v[-1]) if v else math.nan
    residual = getattr(pair.claim, "residual", "")
    of_reference = abs(r) if not pair.scale else scale
    u_ref = point.formulas[residual] * of_reference if residual else 0.0
    u_it = point.u_it.get(pair.fem, 0.0)
    return _judged(pair, r, point.h, v, scale, u_it, u_ref)


def _by_its_row(pair: Pair, point: Known) -> Compared:
    """Result of the pair from the row of its claim, which may derive the compared values."""
    levels = [
        FemResult(
            h=h,
            values={key: v[k] for key, v in point.fe.items() if not math.isnan(v[k])},
            u_it=point.u_it,
        )
        for k, h in enumerate(point.h)
    ]
    context = Context(point.case, point.inputs, point.formulas, levels, is_paper=False)
    claim = pair.claim
    if isinstance(claim, Approximation):
        claim = replace(claim, interval=None)  # may cost more than the point
    rows: list[Row] = claim.rows(context)
    row = next((row for row in rows if row.levels and row.analytic is not None), None)
    if row is None or row.grid is None or row.analytic is None:
        return _none(math.nan, math.nan, "no such row with these inputs")
    f = units.factor(pair.unit)
    v = [value * f for _, value in row.levels]
    scale = (row.scale or math.nan) * f if pair.scale else abs(v[-1])
    return _judged(
        pair, row.analytic * f, point.h, v, scale, row.grid.u_it * f, (row.u_ref or 0.0) * f
    )


def _judged(
    pair: Pair, r: float, h: Sequence[float], v: Sequence[float], scale: float, u_it: float,
    u_ref: float,
) -> Compared:  # fmt: skip
    if not v or not all(map(math.isfinite, (*v, r))):
        problem = NO_FORMULA if v and all(map(math.isfinite, v)) else NO_REFERENCE
        return _none(r, v[-1] if v else math.nan, problem)
    if not (scale > 0 and math.isfinite(scale)):
        return _none(r, v[-1], "nothing to relate a difference to")
    natural = scale if pair.scale else abs(r)  # as in rows
    gci = _index(grid_convergence(h, v, formal=pair.claim.formal, scale=natural, u_it=u_it), v)
    if not math.isfinite(gci):
        return _none(r, v[-1], "does not converge")
    U = judge.expanded(math.hypot(gci / 2, u_it), u_ref)
    # where the value itself is the scale, the error of formula/FE - 1 scales with the quotient
    wide = 1.0 if pair.scale else abs(r / v[-1])
    return Compared(r, v[-1], U, (r - v[-1]) / scale, U / scale * wide)


def _index(grid: GridConvergence, v: Sequence[float]) -> float:
    """Grid convergence index; without convergence, three times the scatter (inf if it is large)."""
    if grid.converges:
        return grid.gci
    scatter = 3 * (max(v[-LEVELS:]) - min(v[-LEVELS:]))
    small = len(v) >= LEVELS and scatter <= DOUBTFUL * abs(v[-1])
    return scatter if small else math.inf


def _none(r: float, v: float, problem: str) -> Compared:
    return Compared(r, v, math.nan, math.nan, math.nan, problem)

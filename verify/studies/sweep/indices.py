"""Causes of the scatter of a formula's error: variance-based sensitivity indices of a sample.

I. M. Sobol', Math. Comput. Simul. 55 (2001) 271-280, doi:10.1016/S0378-4754(00)00270-6. The design
and the estimators are those of A. Saltelli et al., Comput. Phys. Commun. 181 (2010) 259-270,
doi:10.1016/j.cpc.2009.09.018, Table 2 (b) and (f).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from verify.core.figures import Array
from verify.studies.sweep.axes import Tolerance
from verify.studies.sweep.boxes import Flags
from verify.studies.sweep.outcome import Course
from verify.studies.sweep.pairs import Pair
from verify.studies.sweep.plan import Plan
from verify.studies.sweep.region import (
    INSIDE,
    LIMITS,
    OUTSIDE,
    UNDECIDED,
    UNSOLVED,
    Points,
    verdicts,
)

LEAST_ROWS = 8  # of the base sample, for indices
RESAMPLES = 999
CONFIDENCE = 0.95
STEADY = 1e-12  # standard deviation, of the largest value, below which it is round-off
LOOSE = 0.2  # width of an index's interval, from which on the sample is called small
NOISY = 0.1  # share of numerical noise in a variance, from which on it is reported
AT_ONCE = 2**22  # numbers drawn at a time


@dataclass(frozen=True)
class Estimate:
    """A value with its 95 % confidence interval by bootstrap."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Index:
    """First-order and total sensitivity index of one input."""

    tolerance: Tolerance
    first: Estimate
    total: Estimate


@dataclass(frozen=True)
class Scatter:
    """Scatter of one quantity over the sample, and the inputs that cause it.

    `mean`, `sd` and the quantiles at 2.5, 50 and 97.5 % [SI] are those of `n` points, NaN if n is
    0. `noise` is the share of the variance that is due to the standard uncertainty of the finite
    elements (mean square). `indices` are in the order of the tolerances of the plan. If `indices`
    is empty, `why` states the reason.
    """

    n: int
    mean: float
    sd: float
    low: float
    median: float
    high: float
    noise: float
    indices: tuple[Index, ...]
    why: str

    @property
    def ranked(self) -> tuple[Index, ...]:
        """The indices in descending order of the total index."""
        return tuple(sorted(self.indices, key=lambda one: -one.total.value))

    @property
    def widest(self) -> float:
        """Width of the widest confidence interval of all indices; 0 if there are no indices."""
        every = (e for one in self.indices for e in (one.first, one.total))
        return max((e.high - e.low for e in every), default=0.0)


@dataclass(frozen=True)
class Within:
    """Numbers of sample points inside `limit`, outside it, undecided, and unsolved."""

    limit: float
    inside: int
    outside: int
    undecided: int
    unsolved: int


@dataclass(frozen=True)
class Indices:
    """Sensitivity of one compared pair: scatter of formula, finite elements and error.

    The indices are computed from `rows` complete rows of the base sample. `dropped` rows are
    incomplete because a point is unsolved.
    """

    pair: Pair
    rows: int
    dropped: int
    formula: Scatter
    fe: Scatter
    error: Scatter
    within: tuple[Within, ...]


def indices(plan: Plan, course: Course, limits: Sequence[float] = LIMITS) -> Indices:
    """Scatter and sensitivity indices of the compared pair `course`.

    Raises ValueError if the plan is a grid.
    """
    if not plan.base:
        raise ValueError("sensitivity indices require a sample, got a grid")
    solved = np.isfinite(course.error + course.U_error)
    rows: Flags = np.all(solved.reshape(-1, plan.base), axis=0)
    of = np.flatnonzero(solved[: 2 * plan.base])  # of A and B, which are independent
    exact = np.zeros_like(course.U)
    return Indices(
        course.pair, int(rows.sum()), int((~rows).sum()),
        formula=_scatter(plan, course.formula, exact, of, rows),
        fe=_scatter(plan, course.fe, course.U, of, rows),
        error=_scatter(plan, course.error, course.U_error, of, rows),
        within=tuple(_within(course, 2 * plan.base, limit) for limit in limits),
    )  # fmt: skip


def _within(course: Course, first: int, limit: float) -> Within:
    found = verdicts(course.error[:first], course.U_error[:first], limit)
    counts = (int((found == one).sum()) for one in (INSIDE, OUTSIDE, UNDECIDED, UNSOLVED))
    return Within(limit, *counts)


def _scatter(plan: Plan, values: Array, U: Array, of: Points, rows: Flags) -> Scatter:
    """Scatter of `values` over the points `of`, with indices from the complete `rows`."""
    y = values[of]
    if not len(y):
        return Scatter(0, *(np.nan,) * 6, (), "no point is solved")
    sd = float(y.std(ddof=1)) if len(y) > 1 else 0.0
    noise = _share(float(np.mean((U[of] / 2) ** 2)), sd**2)
    found: tuple[Index, ...] = ()
    if not (why := _why_not(int(rows.sum()), y, sd, noise)):
        a, b, *mixed = values.reshape(-1, plan.base)[:, rows]
        found = _indices(plan, terms(a, b, np.array(mixed)))
    low, median, high = (float(q) for q in np.quantile(y, (0.025, 0.5, 0.975)))
    return Scatter(len(y), float(y.mean()), sd, low, median, high, noise, found, why)


def _share(part: float, whole: float) -> float:
    return part / whole if whole else np.inf if part else 0.0


def _why_not(rows: int, y: Array, sd: float, noise: float) -> str:
    """Reason why indices cannot be computed; empty if they can."""
    if rows < LEAST_ROWS:
        return f"only {rows} rows of the sample are complete, at least {LEAST_ROWS} are required"
    if sd <= STEADY * float(np.abs(y).max()):
        return "the quantity does not vary"
    if noise >= 1:
        return "the variation is within the uncertainty of finite elements"
    return ""


def terms(a: Array, b: Array, mixed: Array) -> Array:
    """Terms (n, 2 + 2 d) whose means over the sample give the sensitivity indices.

    `a` and `b` (n,) are the results of the matrices A and B, and `mixed` (d, n) those of A with one
    column taken from B. The mean is subtracted from all results. This does not change the indices,
    but reduces the scatter of their estimates.
    """
    mean = (a.mean() + b.mean()) / 2
    a, b, mixed = a - mean, b - mean, mixed - mean
    variance = ((a**2 + b**2) / 2, (a + b) / 2)
    return np.column_stack([*variance, *(b * (mixed - a)), *((a - mixed) ** 2 / 2)])


def estimates(means: Array) -> Array:
    """First-order and total indices (..., 2, d) from the means (..., 2 + 2 d) of `terms`."""
    variance = means[..., 0] - means[..., 1] ** 2
    with np.errstate(invalid="ignore", divide="ignore"):
        found = means[..., 2:] / variance[..., None]
    return found.reshape(*means.shape[:-1], 2, -1)


def _indices(plan: Plan, of: Array) -> tuple[Index, ...]:
    value = estimates(of.mean(axis=0))
    again = estimates(_resampled(of))
    tail = (1 - CONFIDENCE) / 2
    low, high = np.nanquantile(again, (tail, 1 - tail), axis=0)
    return tuple(
        Index(one, *(Estimate(*map(float, (value[k, j], low[k, j], high[k, j]))) for k in (0, 1)))
        for j, one in enumerate(plan.tolerances)
    )


def _resampled(of: Array) -> Array:
    """Bootstrap means (RESAMPLES, columns) of the rows; all calls use the same random draws."""
    n = len(of)
    draws = np.random.default_rng(0)
    some = max(1, AT_ONCE // n)
    parts = []
    for start in range(0, RESAMPLES, some):
        k = min(some, RESAMPLES - start)
        drawn = draws.integers(n, size=(k, n)) + n * np.arange(k)[:, None]
        times = np.bincount(drawn.ravel(), minlength=k * n).reshape(k, n)
        parts.append(times @ of / n)
    return np.vstack(parts)

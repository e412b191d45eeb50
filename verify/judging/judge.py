"""Judging: verdict from a value, a reference and their uncertainties.

U = k sqrt(u_num^2 + u_ref^2 + u_input^2) with k = 2; detects = (U + |d|)/scale is the smallest
relative change that is certain to make the row fail. A row passes if |d| <= U and detects <=
demand.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from verify.core.results import Status
from verify.judging.convergence import GridConvergence

COVERAGE = 2.0
DEMAND = 0.01


@dataclass(frozen=True)
class Verdict:
    """Result of judging a row; `tolerance` and `difference` have the unit of the row."""

    status: Status
    reason: str = ""
    difference: float | None = None
    tolerance: float | None = None
    detects: float | None = None


def expanded(u_num: float, u_ref: float = 0.0, u_input: float = 0.0) -> float:
    """Expanded uncertainty U = 2 sqrt(u_num^2 + u_ref^2 + u_input^2)."""
    return COVERAGE * math.sqrt(u_num**2 + u_ref**2 + u_input**2)


def numerical_uncertainty(convergence: GridConvergence, u_it: float = 0.0) -> float:
    """Standard uncertainty u_num = sqrt((GCI/2)^2 + u_it^2)."""
    return math.hypot(convergence.gci / 2, u_it)


def difference(
    value: float, reference: float, *, U: float, scale: float, demand: float = DEMAND
) -> Verdict:
    """Verdict on a difference: PASS if |value - reference| <= U and detection limit <= demand.

    This test is used for identities, orders and printed numbers.
    """
    _positive(scale)
    if not all(map(math.isfinite, (value, reference, U))):
        return Verdict(Status.FAIL, "not converged")
    d = value - reference
    detects = (U + abs(d)) / scale
    if abs(d) > U:
        reason = f"differs by {100 * abs(d) / scale:.2g} %, allowed {100 * U / scale:.2g} %"
        return Verdict(Status.FAIL, reason, d, U, detects)
    return _sharp(Verdict(Status.PASS, "", d, U, detects), demand)


def approximation(
    formula: float,
    reference: float,
    *,
    U: float,
    interval: tuple[float, float] | None,
    demand: float = DEMAND,
) -> Verdict:
    """Verdict on the signed model error m = formula/reference - 1.

    It passes if m is in the expected interval narrowed by the uncertainty U_m. Without an interval,
    the row is SHOWN. `difference` is formula - reference. `detects` is the smallest relative change
    of the formula that moves m out of the narrowed interval.
    """
    if not all(map(math.isfinite, (formula, reference, U))) or reference == 0:
        return Verdict(Status.FAIL, "not converged")
    ratio, u = formula / reference, U / abs(reference)
    m, U_m = ratio - 1, abs(ratio) * u  # the error of a quotient scales with it
    if interval is None:
        return Verdict(
            Status.SHOWN,
            f"measured model error: {100 * m:+.2f} ± {100 * U_m:.1g} %",
            formula - reference,
            U,
        )
    low, high = interval
    if not u < 1:
        return Verdict(
            Status.FAIL, "the uncertainty of the reference is as large as its value", None, U
        )
    if ratio == 0:
        return Verdict(
            Status.FAIL, "the formula gives zero: its relative change cannot be judged", None, U
        )
    if not low + U_m <= m <= high - U_m:
        error, u, ends = 100 * m, 100 * U_m, f"[{100 * low:+.3f} %, {100 * high:+.3f} %]"
        reason = f"model error {error:+.3f} % ± {u:.1g} % is not inside {ends}"
        return Verdict(Status.FAIL, reason, formula - reference, U)
    # the formula times 1 + c leaves the interval where (1 + m)(1 + c)(1 ± u) meets its ends
    smaller, larger = (low, high) if ratio > 0 else (high, low)  # in size
    up = (1 + larger) / (ratio * (1 + u)) - 1
    down = 1 - (1 + smaller) / (ratio * (1 - u))
    verdict = Verdict(Status.PASS, "", formula - reference, U, max(up, down))
    return _sharp(verdict, demand)


def fact(margin: float, U: float) -> Verdict:
    """Verdict on a statement: it holds if `margin` > U, and does not hold if `margin` < -U.

    In between, the statement is undecided, and the row fails.
    """
    if not (math.isfinite(margin) and math.isfinite(U)):
        return Verdict(Status.FAIL, "not converged")
    if margin > U:
        return Verdict(Status.PASS, "confirmed", margin, U)
    reason = "not confirmed" if margin < -U else f"undecided: margin {margin:.2g} within ± {U:.2g}"
    return Verdict(Status.FAIL, reason, margin, U)


def exact(residual: float, *, bound: float, scale: float, demand: float = DEMAND) -> Verdict:
    """Verdict on a balance or symmetry: it passes if |residual| <= bound x scale.

    The bound follows from the condition number or from the solver.
    """
    _positive(scale)
    if not (math.isfinite(residual) and math.isfinite(bound)):
        return Verdict(Status.FAIL, "not converged")
    U = bound * scale
    detects = (U + abs(residual)) / scale
    if abs(residual) > U:
        reason = f"residual {abs(residual) / scale:.1e} of the scale, allowed {bound:.1e}"
        return Verdict(Status.FAIL, reason, residual, U, detects)
    return _sharp(Verdict(Status.PASS, "", residual, U, detects), demand)


@dataclass(frozen=True)
class LimitFit:
    """Fit d = d0 + c eps^q, with the expanded uncertainties of d0 and q."""

    d0: float
    U0: float
    c: float
    q: float
    U_q: float


def fit_limit(eps: Sequence[float], d: Sequence[float], u: Sequence[float]) -> LimitFit:
    """Fit of d = d0 + c eps^q by weighted least squares.

    At least four points are required, over at least a decade of eps. For a given q, d is linear in
    d0 and c; the optimal q is searched for in (0, 10]. The errors with the standard uncertainties
    `u` may have the same sign at all points, as for similar meshes; therefore, their effects on a
    constant are added. If the scatter about the fit, taken as independent errors, has a larger
    effect, this effect is used instead.
    """
    x, y, sigma = (np.asarray(a, dtype=np.float64) for a in (eps, d, u))
    decade = np.all(np.isfinite(x)) and np.all(x > 0) and x.size >= 4
    if not decade or x.max() < 10 * x.min() * (1 - 1e-12):
        raise ValueError(
            f"a limit requires at least four points that span a decade, got eps = {x.tolist()}"
        )
    if not (np.all(np.isfinite(y)) and np.all(np.isfinite(sigma)) and np.all(sigma >= 0)):
        raise ValueError(f"all points must be finite to compute a limit, got d = {y.tolist()}")
    size = np.abs(y).max()
    if size == 0:
        raise ValueError("no order of convergence can be computed: all differences are zero")
    sigma = np.maximum(sigma / size, 1e-14)
    s, t = x / x.max(), y / size

    def linear(q: float) -> tuple[np.ndarray[tuple[int], np.dtype[np.float64]], float]:
        A = np.column_stack([np.ones_like(s), s**q]) / sigma[:, None]
        constants = np.linalg.lstsq(A, t / sigma, rcond=None)[0]
        return constants, float(np.sum((A @ constants - t / sigma) ** 2))

    q = _least(lambda q: linear(q)[1])
    (d0, c), chi2 = linear(q)
    J = np.column_stack([np.ones_like(s), s**q, c * s**q * np.log(s)]) / sigma[:, None]
    inflate = max(1.0, chi2 / (s.size - 3)) ** 0.5
    inverse = np.linalg.pinv(J)
    spread = np.maximum(np.abs(inverse).sum(axis=1), np.linalg.norm(inverse, axis=1) * inflate)
    return LimitFit(
        float(d0 * size), float(COVERAGE * spread[0] * size), float(c * size / x.max() ** q),
        float(q), float(COVERAGE * spread[2]),
    )  # fmt: skip


def _least(chi2: Callable[[float], float]) -> float:
    """The q in (0, 10] with the smallest chi2, by a grid and then golden-section search."""
    grid = np.linspace(0.05, 10.0, 200)
    best = int(np.argmin([chi2(q) for q in grid]))
    low, high = grid[max(best - 1, 0)], grid[min(best + 1, grid.size - 1)]
    golden = (math.sqrt(5) - 1) / 2
    for _ in range(80):
        a, b = high - golden * (high - low), low + golden * (high - low)
        if chi2(a) <= chi2(b):
            high = b
        else:
            low = a
    return float((low + high) / 2)


def quadratic_coefficient(
    eps: Sequence[float], d: Sequence[float], u: Sequence[float]
) -> tuple[float, float]:
    """Coefficient c of d = c eps^2 + e eps^4 by weighted least squares, and its U.

    U is the expanded uncertainty. The errors with the standard uncertainties `u` may have the same
    sign at all points, as for similar meshes; therefore, their effects on c are added.
    """
    x, y, sigma = (np.asarray(a, dtype=np.float64) for a in (eps, d, u))
    if x.size < 3 or not (np.all(np.isfinite(y)) and np.all(np.isfinite(sigma) & (sigma > 0))):
        raise ValueError(
            f"the coefficient requires at least three finite points, got d = {y.tolist()}"
        )
    inverse = np.linalg.pinv(np.column_stack([x**2, x**4]) / sigma[:, None])
    return float(inverse[0] @ (y / sigma)), float(COVERAGE * np.abs(inverse[0]).sum())


def asymptotic(fit: LimitFit, *, q: float | None, scale: float, demand: float = DEMAND) -> Verdict:
    """Verdict on a limit: |d0| <= U0 and, if theory gives the exponent, |q - q_theory| <= U_q."""
    _positive(scale)
    if not all(map(math.isfinite, (fit.d0, fit.U0, fit.q, fit.U_q))):
        return Verdict(Status.FAIL, "not converged")
    detects = (fit.U0 + abs(fit.d0)) / scale
    if abs(fit.d0) > fit.U0:
        reason = (
            f"the limit, {fit.d0 / scale:.2g} of the scale, differs from zero by more than "
            f"{fit.U0 / scale:.2g}"
        )
        return Verdict(Status.FAIL, reason, fit.d0, fit.U0, detects)
    if q is not None and abs(fit.q - q) > fit.U_q:
        reason = f"exponent {fit.q:.3f} ± {fit.U_q:.2g}, theory {q:g}"
        return Verdict(Status.FAIL, reason, fit.d0, fit.U0, detects)
    return _sharp(Verdict(Status.PASS, "", fit.d0, fit.U0, detects), demand)


def _positive(scale: float) -> None:
    if not (math.isfinite(scale) and scale > 0):
        raise ValueError(f"the scale of a row must be positive and finite, got {scale:g}")


def _sharp(verdict: Verdict, demand: float) -> Verdict:
    if verdict.detects is not None and verdict.detects > demand:
        least, must = f"{100 * verdict.detects:.2g} %", f"{100 * demand:.2g} %"
        reason = f"insufficient sensitivity: detects errors from {least}, required {must}"
        return Verdict(Status.FAIL, reason, verdict.difference, verdict.tolerance, verdict.detects)
    return verdict

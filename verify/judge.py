"""Judging: from a value, a reference and their uncertainties to a verdict.

U = k sqrt(u_num^2 + u_ref^2 + u_input^2) with k = 2; detects = (U + |d|)/scale is the smallest
relative change that surely turns the row red. A row passes when |d| <= U and detects <= demand.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from verify.convergence import GridConvergence
from verify.results import Status

COVERAGE = 2.0
DEMAND = 0.01


@dataclass(frozen=True)
class Verdict:
    """What judging adds to a row. `tolerance` and `difference` carry the row's unit."""

    status: Status
    reason: str = ""
    difference: float | None = None
    tolerance: float | None = None
    detects: float | None = None


def expanded(u_num: float, u_ref: float = 0.0, u_input: float = 0.0) -> float:
    """U = 2 sqrt(u_num^2 + u_ref^2 + u_input^2) from standard uncertainties."""
    return COVERAGE * math.sqrt(u_num**2 + u_ref**2 + u_input**2)


def numerical_uncertainty(convergence: GridConvergence, u_it: float = 0.0) -> float:
    """u_num = sqrt((GCI/2)^2 + u_it^2)."""
    return math.hypot(convergence.gci / 2, u_it)


def difference(
    value: float, reference: float, *, U: float, scale: float, demand: float = DEMAND
) -> Verdict:
    """Identity, trend and printed numbers: |value - reference| <= U, and sharp."""
    if not scale > 0:
        raise ValueError(f"a row needs a positive scale, got {scale:g}")
    if not all(map(math.isfinite, (value, reference, U))):
        return Verdict(Status.FAIL, "not converged")
    d = value - reference
    detects = (U + abs(d)) / scale
    if abs(d) > U:
        reason = f"differs by {abs(d) / scale:.2g} of the scale, allowed {U / scale:.2g}"
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
    """Signed model error m = formula/reference - 1 with U_m inside the expected interval.

    Without an interval the row is SHOWN. `difference` is formula - reference; detects is the
    smallest relative change of the formula that takes m out of the narrowed interval.
    """
    if not all(map(math.isfinite, (formula, reference, U))) or reference == 0:
        return Verdict(Status.FAIL, "not converged")
    m, U_m = formula / reference - 1, U / abs(reference)
    if interval is None:
        return Verdict(Status.SHOWN, f"measured: {m:+.2%} ± {U_m:.1g}", formula - reference, U)
    low, high = interval
    detects = max(high - U_m - m, m - low - U_m)
    if not low + U_m <= m <= high - U_m:
        reason = f"model error {m:+.3%} ± {U_m:.1g} is not inside [{low:+.3%}, {high:+.3%}]"
        return Verdict(Status.FAIL, reason, formula - reference, U, abs(detects))
    return _sharp(Verdict(Status.PASS, "", formula - reference, U, detects), demand)


def fact(margin: float, U: float) -> Verdict:
    """Held where the margin exceeds its uncertainty, not held where it is below the negative."""
    if not (math.isfinite(margin) and math.isfinite(U)):
        return Verdict(Status.FAIL, "not converged")
    if margin > U:
        return Verdict(Status.PASS, "held", margin, U)
    reason = "not held" if margin < -U else f"undecided: margin {margin:.2g} within ± {U:.2g}"
    return Verdict(Status.FAIL, reason, margin, U)


def exact(residual: float, *, bound: float, scale: float) -> Verdict:
    """A balance or symmetry: |residual| <= bound x scale, bound from condition or solver."""
    if not math.isfinite(residual):
        return Verdict(Status.FAIL, "not converged")
    U = bound * scale
    detects = (U + abs(residual)) / scale
    if abs(residual) > U:
        reason = f"residual {abs(residual) / scale:.1e} of the scale, allowed {bound:.1e}"
        return Verdict(Status.FAIL, reason, residual, U, detects)
    return Verdict(Status.PASS, "", residual, U, detects)


@dataclass(frozen=True)
class LimitFit:
    """d = d0 + c eps^q with expanded uncertainties of d0 and q."""

    d0: float
    U0: float
    c: float
    q: float
    U_q: float


def fit_limit(eps: Sequence[float], d: Sequence[float], u: Sequence[float]) -> LimitFit:
    """Weighted least squares of d = d0 + c eps^q over at least four points and a decade.

    The covariance takes the larger of the stated uncertainties `u` and the scatter about the fit.
    """
    from scipy.optimize import curve_fit  # 80 ms that only this kind of row needs

    x, y, sigma = (np.asarray(a, dtype=np.float64) for a in (eps, d, u))
    if x.size < 4 or x.max() < 10 * x.min() * (1 - 1e-12):
        raise ValueError(f"a limit needs four points over a decade, got eps = {x.tolist()}")
    sigma = np.maximum(sigma, 1e-15 * np.abs(y).max())
    big = y[np.argmax(x)]
    s = x / x.max()
    start = (0.0, big, 1.0)
    fit, covariance = curve_fit(
        lambda t, d0, c, q: d0 + c * t**q, s, y, p0=start, sigma=sigma, absolute_sigma=True,
        maxfev=20_000,
    )  # fmt: skip
    left = (fit[0] + fit[1] * s ** fit[2] - y) / sigma
    inflate = max(1.0, float(np.sum(left**2)) / (x.size - 3)) ** 0.5
    u0, _, u_q = np.sqrt(np.diag(covariance)) * inflate
    return LimitFit(
        float(fit[0]), float(COVERAGE * u0), float(fit[1] / x.max() ** fit[2]), float(fit[2]),
        float(COVERAGE * u_q),
    )  # fmt: skip


def asymptotic(fit: LimitFit, *, q: float | None, scale: float, demand: float = DEMAND) -> Verdict:
    """|d0| <= U0 and, where theory gives the exponent, |q - q_theory| <= U_q."""
    detects = (fit.U0 + abs(fit.d0)) / scale
    if abs(fit.d0) > fit.U0:
        reason = f"limit {fit.d0 / scale:.2g} of the scale is not zero within {fit.U0 / scale:.2g}"
        return Verdict(Status.FAIL, reason, fit.d0, fit.U0, detects)
    if q is not None and abs(fit.q - q) > fit.U_q:
        reason = f"exponent {fit.q:.3f} ± {fit.U_q:.2g}, theory {q:g}"
        return Verdict(Status.FAIL, reason, fit.d0, fit.U0, detects)
    return _sharp(Verdict(Status.PASS, "", fit.d0, fit.U0, detects), demand)


def _sharp(verdict: Verdict, demand: float) -> Verdict:
    if verdict.detects is not None and verdict.detects > demand:
        reason = f"not sharp: detects {verdict.detects:.2g}, demanded {demand:.2g}"
        return Verdict(Status.FAIL, reason, verdict.difference, verdict.tolerance, verdict.detects)
    return verdict

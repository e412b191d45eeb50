r"""Observed order and grid convergence index of values on meshes from coarse to fine.

.. math:: GCI = F\,\frac{|v_3 - v_2|}{r^p - 1}

The index uses the three finest values, with mesh sizes in any ratio. The order p solves the
equation for unequal ratios, :func:`observed_order`.

References
----------
.. [1] I. B. Celik et al., Procedure for estimation and reporting of uncertainty due to
   discretization in CFD applications, J. Fluids Eng. 130 (2008) 078001.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np

ROUND_OFF = 1e-10  # of the scale: effect of round-off on a difference of two values
# Of the scale: an order needs a last difference above this. Round-off then changes the logarithm of
# the ratio of differences by a third at most, on any processor.
RESOLVED = 5 * ROUND_OFF
FLOOR = 1e-12  # of the scale: no value is trusted beyond
NEAR_FORMAL, FAR_FROM_FORMAL = 0.5, 0.55  # |observed - formal| where F leaves 1.25 and reaches 3
FACTOR, LARGE_FACTOR = 1.25, 3.0
LEAST_ORDER = 0.5
ORDER_LIMITS = (-20.0, 60.0)

Behaviour = Literal["monotone", "oscillating", "slow", "noisy", "round-off", "diverging", "short"]


@dataclass(frozen=True)
class GridConvergence:
    """Convergence of a series of values on refined meshes.

    `gci` has the unit of the values. `order` is the observed order, None if there is none. `used`
    and `factor` are the order p and the factor F in the index, if it was computed with an order.
    """

    behaviour: Behaviour
    gci: float
    order: float | None = None
    extrapolated: float | None = None
    used: float | None = None
    factor: float | None = None

    @property
    def converges(self) -> bool:
        """Whether the series converges.

        False if differences grow or if there are too few values.
        """
        return self.behaviour not in ("diverging", "short")


def grid_convergence(
    h: Sequence[float],
    values: Sequence[float],
    *,
    formal: float | None,
    scale: float,
    u_it: float = 0.0,
    residual: float = 0.0,
) -> GridConvergence:
    """Convergence of `values` on meshes of size `h`.

    The series diverges if |v1 - v2| ln(h3/h2)/ln(h2/h1) exceeds |v2 - v3| by more than the
    iteration error, 4 u_it, and round-off; v1 is the value on the finest mesh. Both sides are equal
    if the values are linear in log h.
    If the last difference may be round-off, growth, sign and order are not evaluated: the index is
    a multiple of the spread, :func:`unresolved_multiple`.

    Parameters
    ----------
    h, values
        Mesh sizes, strictly decreasing, and the values computed on them; the last three are used.
    formal
        Theoretical order; None if theory gives no order (no order is then used).
    scale
        Natural magnitude of the values, for round-off.
    u_it
        Iteration uncertainty of one value; `residual` is the error bound stated by the solver.

    Raises
    ------
    ValueError
        If the sizes do not decrease, the lengths differ, or a value is not finite.
    """
    _check(h, values)
    floor = max(FLOOR * scale, residual)
    if len(values) < 3:
        return GridConvergence("short", math.inf)
    (h3, h2, h1), (v3, v2, v1) = h[-3:], values[-3:]
    spread = max(v1, v2, v3) - min(v1, v2, v3)
    fine, coarse = v1 - v2, v2 - v3
    no_order = max(3 * spread, floor)
    noisy = u_it > 0.01 * abs(fine)
    if abs(fine) <= RESOLVED * scale:
        gci = max(unresolved_multiple(fine, coarse, scale) * spread, floor)
        resolved = max(abs(fine), abs(coarse)) >= ROUND_OFF * scale
        return GridConvergence("noisy" if noisy and resolved else "round-off", gci)
    r21, r32 = h2 / h1, h3 / h2
    flat = math.log(r32) / math.log(r21)  # |coarse/fine| of a series that neither grows nor shrinks
    growth = flat * abs(fine) - abs(coarse)
    if growth > 4 * u_it + (flat + 1) * ROUND_OFF * scale:
        return GridConvergence("diverging", math.inf)
    if noisy:
        return GridConvergence("noisy", no_order)
    if fine * coarse <= 0:
        return GridConvergence("oscillating", no_order)
    observed = observed_order(coarse / fine, r21, r32)
    if observed < LEAST_ORDER:
        return GridConvergence("slow", no_order)
    if formal is None:
        return GridConvergence("monotone", no_order, observed)
    p, F = min(observed, formal), safety_factor(observed, formal)
    gci = F * abs(fine) / (r21**p - 1)
    limit = v1 + fine / (r21**observed - 1)
    return GridConvergence("monotone", max(gci, floor), observed, limit, used=p, factor=F)


def unresolved_multiple(fine: float, coarse: float, scale: float) -> float:
    """Ratio of the grid convergence index to the spread of three values that differ by round-off.

    `fine` and `coarse` are the differences of successive values. The ratio is 1 if both differences
    are below half of `ROUND_OFF` times the scale. The ratio is 3 if one difference exceeds
    `ROUND_OFF` times the scale, as for every series without an order. In between, the ratio is
    linear, so that the index is continuous.
    """
    limit = ROUND_OFF * scale
    return 1 + 2 * _ramp(max(abs(fine), abs(coarse)), limit / 2, limit)


def safety_factor(observed: float, formal: float) -> float:
    """Factor F of the grid convergence index, from the observed and the theoretical order.

    F is 1.25 if the orders differ by at most 0.5, 3 if they differ by more than 0.55, and linear in
    between. A difference of half an order is common (at a singularity). Without the linear
    transition, the last digits of the order would decide between two indices that differ by a
    factor of 2.4.
    """
    share = _ramp(abs(observed - formal), NEAR_FORMAL, FAR_FROM_FORMAL)
    return FACTOR + (LARGE_FACTOR - FACTOR) * share


def _ramp(x: float, low: float, high: float) -> float:
    """Ramp in `x`: 0 up to `low`, 1 from `high` on, linear in between."""
    if x <= low:
        return 0.0
    return 1.0 if x >= high else (x - low) / (high - low)


def observed_order(ratio: float, r21: float, r32: float) -> float:
    r"""Observed order p of three values whose differences have the positive ratio coarse/fine.

    .. math:: r_{21}^p \frac{r_{32}^p - 1}{r_{21}^p - 1} = \frac{v_2 - v_3}{v_1 - v_2}

    v_1 is the value on the finest mesh, and r_21 = h_2/h_1. The left side increases with p;
    therefore, the root is unique.
    """

    def excess(p: float) -> float:
        if abs(p) < 1e-9:
            return math.log(math.log(r32) / math.log(r21)) - math.log(ratio)
        a, b = p * math.log(r21), p * math.log(r32)
        return a + math.log(math.expm1(b) / math.expm1(a)) - math.log(ratio)

    low, high = ORDER_LIMITS
    if excess(high) <= 0:
        return high
    if excess(low) >= 0:
        return low
    from scipy.optimize import brentq  # slow to import, and not needed for formulas only

    return float(brentq(excess, low, high, xtol=1e-12))


def order_from_iteration(h: Sequence[float], values: Sequence[float], u_it: float) -> float:
    r"""Largest amount by which iteration errors can make the observed order too high.

    Each of the last three values may have the error ± u; v_1 is the value on the finest mesh. For
    any ratios of the meshes, the order without these errors is lowest if the error of the middle
    value is opposite to the errors of the other two. The logarithm of the ratio of differences is
    then smaller by

    .. math:: \ln\left(1 + \frac{2u}{|v_1 - v_2|}\right)
        - \ln\left(1 - \frac{2u}{|v_2 - v_3|}\right)

    This is divided by the derivative of the logarithm with respect to p, :func:`slope_of_ratio`.
    The derivative is monotonic in p. Therefore, the smaller of its values at the lowest order and
    at the observed order gives the bound.
    """
    (h3, h2, h1), (v3, v2, v1) = h[-3:], values[-3:]
    fine, coarse, r21, r32 = abs(v1 - v2), abs(v2 - v3), h2 / h1, h3 / h2
    observed = observed_order(coarse / fine, r21, r32)
    if coarse <= 2 * u_it:
        return observed - ORDER_LIMITS[0]
    least = observed_order((coarse - 2 * u_it) / (fine + 2 * u_it), r21, r32)
    fall = math.log1p(2 * u_it / fine) - math.log1p(-2 * u_it / coarse)
    return fall / min(slope_of_ratio(p, r21, r32) for p in (least, observed))


def slope_of_ratio(p: float, r21: float, r32: float) -> float:
    r"""Derivative of the logarithm of the difference ratio with respect to the order p.

    .. math:: \ln r_{21} + \frac{\ln r_{32}}{1 - r_{32}^{-p}} - \frac{\ln r_{21}}{1 - r_{21}^{-p}}
    """
    a, b = math.log(r21), math.log(r32)
    if abs(p) < 1e-6:
        return (a + b) / 2
    return a - b / math.expm1(-b * p) + a / math.expm1(-a * p)


@dataclass(frozen=True)
class OrderFit:
    """Order of convergence of errors as h goes to 0, and its standard uncertainty `u`.

    `slopes` are the slopes of log error over log h between neighbouring levels. `parts` are the
    contributions to `u`: scatter, half of the difference between `order` and the slope fitted at
    the finest mesh, and round-off.
    """

    order: float
    u: float
    slopes: tuple[float, ...]
    parts: tuple[float, float, float]


def fit_order(h: Sequence[float], errors: Sequence[float]) -> OrderFit:
    r"""Asymptotic order of convergence of positive errors relative to an exact value.

    The slopes p_k between neighbouring levels approach the order linearly in h (next term of the
    error series): p = p_0 + c h is fitted to the last three slopes. The standard uncertainty
    contains the scatter of the fit, and half of the last correction c h, because the correction may
    also be of second order in h.
    """
    _check(h, errors)
    if len(errors) < 4 or min(errors) <= 0:
        raise ValueError(
            f"the order of convergence requires at least four positive errors, got {list(errors)}"
        )
    x, y = np.log(h), np.log(errors)
    slope = np.diff(y) / np.diff(x)
    middle = np.exp((x[1:] + x[:-1]) / 2)
    A = np.column_stack([np.ones(3), middle[-3:]])
    (p0, c), *_ = np.linalg.lstsq(A, slope[-3:], rcond=None)
    scatter = float(np.linalg.norm(slope[-3:] - A @ (p0, c)))
    covariance = scatter**2 * np.linalg.inv(A.T @ A)
    # logarithms and their differences carry some round-off
    round_off = 5e-15 * float(np.abs(y).max() / np.abs(np.diff(x)).min())
    parts = (math.sqrt(covariance[0, 0]), abs(float(c * middle[-1])) / 2, round_off)
    u = float(np.linalg.norm(parts))
    return OrderFit(float(p0), u, tuple(slope.tolist()), parts)


def _check(h: Sequence[float], values: Sequence[float]) -> None:
    if len(h) != len(values):
        raise ValueError(
            f"numbers of mesh sizes and values must be equal, got {len(h)} sizes "
            f"and {len(values)} values"
        )
    if any(not (math.isfinite(a) and a > 0) for a in h) or any(b >= a for a, b in pairwise(h)):
        raise ValueError(f"mesh sizes must be positive and decreasing, got {list(h)}")
    if not all(math.isfinite(v) for v in values):
        raise ValueError(f"values must be finite, got {list(values)}")

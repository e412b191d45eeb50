r"""Unilateral contact of equal strips in dimensionless form, for many cases at once.

With the dimensionless line load :math:`s = b^2/D^2 = 4qR/(\pi E^*D^2)` and heights in units of
:math:`D^2/(2\pi R)`, the problem does not contain radius, modulus and width of the strips, and all
cases have the same influence coefficients. The solution is s >= 0 with

.. math::
    g_j = \sum_k H_{|j-k|}(s_k) + h_j - \Delta \ge 0, \qquad s_j g_j = 0, \qquad
    H_m(s) = s\left[F\Big(\frac{m + 1/2}{\sqrt s}\Big) - F\Big(\frac{m - 1/2}{\sqrt s}\Big)\right]

(F: `strip_influence`) for a given Delta or a given sum of s. The influence of distant strips is a
logarithm and a few powers of s, with matrices common to all cases; the influence of the M nearest
strips is read from the table. Newton's method is applied to the loaded strips: a strip with tension
is unloaded, a strip that penetrates the surface is loaded again.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from analytic.contact.checks import Array
from analytic.contact.strip_influence import excess, far_coefficients
from analytic.contact.strip_linear import System, conjugate_gradients, direct, product

ITERATIONS = 60
UNDAMPED = 12  # iterations after which a step reduces a strip's load by at most nine tenths
FAR = 3.0  # half-widths from which on the series of F serves: 9^-8 c_8 = 1e-11
TERMS = 7

Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Solved:
    """Loads s (N, n), approaches Delta (N,), relative residuals (N,) and number of iterations."""

    s: Array
    Delta: Array
    residual: Array
    iterations: int


@dataclass(frozen=True)
class Response:
    """Displacements u (N, n) under the loads s, and the matrices u/s and du/ds.

    `ratios` and `slopes` (M, N, n) are the bands of both matrices near the diagonal; for m > 0,
    they are differences from the logarithm of far[0]. `far` are the matrices of distant strips.
    """

    u: Array
    ratios: Array
    slopes: Array
    far: tuple[Array, ...]


def respond(s: Array) -> Response:
    """`Response` of all strips to the loads s (N, n)."""
    n = s.shape[-1]
    near = min(n, int(np.ceil(FAR * np.sqrt(s.max(initial=0.0)) + 0.5)))
    far = _far(n, near)
    u = product(s, far[0])
    power = s
    for matrix in far[1:] if near < n else ():
        power = power * s
        u += product(power, matrix)
    log_root = 0.5 * np.log(np.maximum(s, 1e-300))
    ratios, slopes = np.empty((2, near, *s.shape))
    value, tangent = np.zeros((2, *s.shape))
    for m in range(near):  # one band at a time stays in the cache
        before, before_tangent = value, tangent
        value, tangent = excess(np.log(m + 0.5) - log_root)
        tangent *= -0.5
        tangent += value
        np.subtract(value, before, out=ratios[m])
        np.subtract(tangent, before_tangent, out=slopes[m])
    own = np.pi / 2 * (np.log(2.0) - log_root)
    ratios[0] = 2 * (ratios[0] + own + np.pi / 4)
    slopes[0] = 2 * (slopes[0] + own)
    u += ratios[0] * s
    for m in range(1, near):
        part = ratios[m] * s
        u[:, m:] += part[:, :-m]
        u[:, :-m] += part[:, m:]
    return Response(u, ratios, slopes, far)


def solve(
    h: Array, *, tolerance: float, total: Array | None = None, Delta: Array | None = None
) -> Solved:
    """Loads s of cases with gaps h (N, n), for given sums `total` or approaches `Delta`, both (N,).

    Converged cases are removed from the iteration. Cases that do not converge are solved again
    separately. Raises ArithmeticError if a case does not converge in this second attempt.
    """
    cases = len(h)
    s, level = _uncoupled(h, total, Delta)
    solved = Solved(np.empty_like(h), np.empty(cases), np.empty(cases), 0)
    left = np.arange(cases)
    for iteration in range(1, ITERATIONS + 1):
        response = respond(s)
        gap = response.u + h - level[:, None]
        carries = (s > 0) | (gap < 0)
        residual = _residual(s, gap, h, level, total)
        done = residual <= tolerance
        if done.any():
            at = left[done]
            solved.s[at], solved.Delta[at], solved.residual[at] = (
                s[done],
                level[done],
                residual[done],
            )
            if done.all():
                return Solved(solved.s, solved.Delta, solved.residual, iteration)
            go = ~done
            left, level = left[go], level[go]
            s, gap, h, carries = s[go], gap[go], h[go], carries[go]
            total = None if total is None else total[go]
            response = Response(
                response.u[go], response.ratios[:, go], response.slopes[:, go], response.far
            )
        step, rise = (conjugate_gradients if iteration <= UNDAMPED else direct)(
            _system(s, gap, carries, response, total)
        )
        moved = np.maximum(s + step, 0.1 * s if iteration > UNDAMPED else 0.0)
        lifted = ~(moved > 0).any(axis=-1, keepdims=True)  # too far: nothing would carry
        s = np.where(lifted, 0.1 * s, moved)
        s[s < 1e-14 * s.max(axis=-1, keepdims=True)] = 0.0
        level = level + rise
    if cases > 1:  # first steps are common to all cases and may not suit each
        for i, case in enumerate(left):
            one = slice(i, i + 1)
            alone = solve(
                h[one], tolerance=tolerance, total=None if total is None else total[one],
                Delta=None if Delta is None else level[one],
            )  # fmt: skip
            solved.s[case], solved.Delta[case] = alone.s[0], alone.Delta[0]
            solved.residual[case] = alone.residual[0]
        return Solved(solved.s, solved.Delta, solved.residual, ITERATIONS)
    raise ArithmeticError(
        f"{len(left)} of {cases} cases of strips did not converge in {ITERATIONS} iterations: "
        f"relative residual {residual.max():.1e}, first case {left[0]}"
    )


def _system(s: Array, gap: Array, carries: Mask, response: Response, total: Array | None) -> System:
    """Linear system of the Newton step.

    For a strip that is about to carry load, the slope at s = 0 is infinite (logarithm). Therefore,
    the slope at the load that corresponds to its penetration is used, approximated from below.
    """
    seed = np.clip(-gap / 30, 1e-300, 0.5)
    response.slopes[0] = np.where(
        s > 0, response.slopes[0], np.pi * (np.log(2.0) - 0.5 * np.log(seed))
    )
    missing = None if total is None else total - s.sum(axis=-1)
    push = np.where(carries, -gap, 0.0)
    return System(response.far, response.slopes, s, push, carries, missing)


def _residual(s: Array, gap: Array, h: Array, level: Array, total: Array | None) -> Array:
    """Relative violation (N,) of the contact conditions and of the load, the larger one of both."""
    wrong = np.where(s > 0, np.abs(gap), np.maximum(-gap, 0.0)).max(axis=-1)
    reach = level - h.min(axis=-1)
    residual = np.where(wrong > 0, wrong / np.maximum(reach, 1e-200), 0.0)
    if total is None:
        return np.asarray(residual)
    return np.asarray(np.maximum(residual, np.abs(s.sum(axis=-1) / total - 1)))


def _uncoupled(h: Array, total: Array | None, Delta: Array | None) -> tuple[Array, Array]:
    """Initial loads and approach: each strip is a spring of the same mean stiffness."""
    n = h.shape[-1]
    softness = np.pi * (np.log(2 * n) + 0.5)
    if Delta is None:
        assert total is not None
        ordered = np.sort(h, axis=-1)
        count = np.arange(1, n + 1)
        levels = (softness * total[:, None] + np.cumsum(ordered, axis=-1)) / count
        carrying = (levels > ordered).sum(axis=-1, keepdims=True)
        Delta = np.take_along_axis(levels, carrying - 1, axis=-1)[:, 0]
    return np.maximum(Delta[:, None] - h, 0.0) / softness, Delta


@lru_cache(maxsize=64)
def _far(n: int, near: int) -> tuple[Array, ...]:
    """Matrices (n, n) that multiply s, s², ... in u: logarithm, then series of distant strips."""
    m = np.abs(np.subtract.outer(np.arange(n), np.arange(n)))
    beyond, before = m + 0.5, np.where(m > 0, m - 0.5, 1.0)
    log = np.where(m > 0, np.pi / 2 * np.log(beyond / before), 0.0)
    if near >= n:
        return (log,)
    c = far_coefficients(TERMS)
    return log, *(
        np.where(m >= near, c[i - 1] * (beyond ** (-2.0 * i) - before ** (-2.0 * i)), 0.0)
        for i in range(1, TERMS + 1)
    )

r"""Error of the model `strips` for a line contact whose load q(y) varies along the contact.

The pressure of a strip is assumed to be Hertz's ellipse for the curvature 1/R of the roller. The
kernel 1/r is expanded for slow variation along y. Its first term is the logarithm that gives this
ellipse. The next term is quadratic in the distance rho across. For the wave number k along y and
small k rho, with the modified Bessel function K_0,

.. math::
    u = \frac{1}{\pi E^*}\int p(\xi, y)\; 2K_0(k\rho)\, d\xi, \qquad
    2K_0(k\rho) = 2\lambda + \frac{k^2\rho^2}{2}\,(\lambda + 1), \qquad
    \lambda = -\gamma - \ln\frac{k\rho}2, \quad k^2 = -\partial_y^2 .

On the middle line x = 0, the strips include this term. For the ellipse, :math:`\int p\,d\xi = q`
and :math:`\int p\ln|x - \xi|\,d\xi = q\,(\ln\frac b2 - \frac12 + x^2/b^2)`, so that the curvature
of this term across is

.. math::
    u_2'' = -\frac{1}{\pi E^*}\,\partial_y^2\Big[\Big(-\gamma - \ln\frac k2\Big)q
            - q\ln\frac b2 - q\frac{x^2}{b^2}\Big] .

The last part vanishes, because q/b² is constant along y. The other parts are
:math:`\frac12(\pi E^* u_0 - q)` with the displacement of the middle line, :math:`u_0 = \delta - z`.
Thus, the pressure is still an ellipse, but for the curvature 1/R' instead of 1/R,

.. math::
    \frac1{R'} = \frac1R\,(1 + \varepsilon), \qquad
    \varepsilon = \frac R2\Big(z'' + \frac{q''}{\pi E^*}\Big) .

The result contains no undetermined logarithm. At a given q, b decreases and p increases by the
fraction epsilon/2. The narrower ellipse causes a larger displacement beneath itself. This shifts
load to strips with smaller epsilon. The shift is computed with the matrix of the strips at constant
load W: p changes by :math:`\varepsilon/2 + \delta q/2q`. For Hertz's ellipse with semi-axes b << a
this is the first term of his exact solution,
:math:`\varepsilon = \frac{b^2}{2a^2}(\ln\frac{4a}b - \frac32)`.

References
----------
.. [1] J. J. Kalker, On elastic line contact, J. Appl. Mech. 39 (1972) 1125-1132 (the expansion;
   this term is derived here).
"""

from dataclasses import dataclass

import numpy as np

from analytic.contact.checks import Array
from analytic.contact.strip_linear import System, direct
from analytic.contact.strip_newton import Response, respond
from analytic.contact.strips import Strips

END = 3.0  # half-widths from a loaded end within which no slow variation can be meant


@dataclass(frozen=True)
class Neglected:
    """First-order estimate of the fraction by which the true pressure exceeds that of the strips.

    `pressure` (..., n) is NaN if a strip or its neighbour carries no load, and within three
    half-widths of a loaded end; peak and mid are (...). The true deviation should lie between half
    and twice the estimate if the estimate is a few per cent and q varies over several b. If the
    peak is at a loaded end, `peak` is NaN, because no expansion is valid there. For `mid`, the true
    deviation may then be half or twice the estimate, because a loaded end changes the load at
    mid-length.
    """

    pressure: Array
    peak: Array
    mid: Array
    approach: Array


def neglected(solution: Strips) -> Neglected:
    """Deviation of the solved strips from a half-space contact, estimated to first order.

    All cases are solved at once with matrices of (cases, n, n).
    """
    n = solution.q.shape[-1]
    D, R, E_star = (a[..., None] for a in (solution.length / n, solution.R, solution.E_star))
    u_0 = solution.gap + solution.q / (np.pi * E_star)
    epsilon = np.full(solution.q.shape, np.nan)
    epsilon[..., 1:-1] = R / 2 * (u_0[..., 2:] - 2 * u_0[..., 1:-1] + u_0[..., :-2])
    epsilon /= D**2
    carries = solution.carries
    inner = np.zeros_like(carries)
    inner[..., 1:-1] = carries[..., 2:] & carries[..., 1:-1] & carries[..., :-2]
    epsilon[~inner] = np.nan

    s = (solution.half_width / D) ** 2
    shift, rise = _shift(s.reshape(-1, n), np.nan_to_num(epsilon).reshape(-1, n))
    shift, rise = shift.reshape(s.shape), rise.reshape(s.shape[:-1])
    with np.errstate(divide="ignore", invalid="ignore"):
        pressure = epsilon / 2 + shift / (2 * s)
    edge = END * solution.half_width / D
    strips = np.arange(n) + 0.5
    pressure[carries[..., :1] & (strips < edge)] = np.nan
    pressure[carries[..., -1:] & (strips[::-1] < edge)] = np.nan
    highest = solution.pressure.argmax(axis=-1)[..., None]
    return Neglected(
        pressure=pressure,
        peak=np.take_along_axis(pressure, highest, axis=-1)[..., 0],
        mid=(pressure[..., (n - 1) // 2] + pressure[..., n // 2]) / 2,
        approach=rise * (D**2 / (2 * np.pi * R))[..., 0] / solution.approach,
    )


def discretisation(coarse: Strips, fine: Strips) -> tuple[Array, Array]:
    """Estimated relative discretisation errors of `fine.peak` and `fine.mid`.

    `coarse` has the same cases with about half as many strips. The error is assumed to be of first
    order: for smooth loads it decreases faster, but the position of the contact edge within a strip
    is random.
    """
    n, twice = coarse.q.shape[-1], fine.q.shape[-1]
    if not twice > n:
        raise ValueError(f"fine must have more strips than coarse, got {twice} and {n}")
    ratio = twice / n - 1
    peak, mid = (
        np.abs(after / before - 1) / ratio
        for after, before in ((fine.peak, coarse.peak), (fine.mid, coarse.mid))
    )
    return np.asarray(peak), np.asarray(mid)


def _shift(s: Array, epsilon: Array) -> tuple[Array, Array]:
    """Changes of s (N, n) at constant sum, and of Delta (N,), for narrower strips.

    s is the dimensionless load, Delta the approach. The half-widths decrease by the fraction
    epsilon/2.

    With u = s Phi(s), a narrower ellipse with the same load changes u by
    -epsilon s² dPhi/ds = -epsilon s (du/ds - u/s).
    """
    response = respond(s)
    carries = s > 0
    push = np.where(carries, _narrowing(response, epsilon * s), 0.0)
    step, rise = direct(
        System(response.far, response.slopes, s, push, carries, missing=np.zeros(len(s)))
    )
    return np.where(carries, step, 0.0), rise


def _narrowing(response: Response, x: Array) -> Array:
    """Product (du/ds - u/s) x of the near bands; the effect of b on distant strips is neglected."""
    bands = response.slopes - response.ratios
    out = np.asarray(bands[0] * x)
    for m in range(1, len(bands)):
        out[:, m:] += bands[m, :, :-m] * x[:, :-m]
        out[:, :-m] += bands[m, :, m:] * x[:, m:]
    return out

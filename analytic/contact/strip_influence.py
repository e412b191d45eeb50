r"""Displacement of a half-space along the middle line of a strip of elliptic pressure.

A strip of width D carries the line load q with Hertz's ellipse of half-width b across,
:math:`p = \frac{2q}{\pi b}\sqrt{1 - x^2/b^2}`, constant along y over D. A point load P displaces
the surfaces of both bodies together by :math:`P/(\pi E^* r)`. Therefore, the displacement on the
middle line x = 0, at the distance d from the centre of the strip, is

.. math::
    u = \frac{2q}{\pi^2E^*}\left[F\Big(\frac{d + D/2}{b}\Big) - F\Big(\frac{d - D/2}{b}\Big)\right],
    \qquad F(v) = \int_{-1}^1\sqrt{1 - x^2}\,\operatorname{arsinh}\frac v{|x|}\,dx .

F is odd, :math:`F' = 2\sqrt{1 + v^2}\,(K - E)` with complete elliptic integrals of the parameter
:math:`m = 1/(1 + v^2)`; :math:`F \to 2v\ln(4/v)` for small v and, for large v,

.. math::
    F = \frac\pi2\Big(\ln4v + \frac12\Big) + \sum_{i\ge1} c_i v^{-2i}, \qquad
    c_1 = \frac\pi{32}, \quad c_i = \frac{(-1)^{i+1}}{2i}\frac{(2i-1)!!}{(2i)!!}
    \,\mathrm B\big(i + \tfrac12, \tfrac32\big) .

The difference of F and the logarithm (`excess`, negative for small v) is tabulated over ln v and
interpolated by cubic Hermite polynomials with an error below 2e-11. As b² is proportional to q, the
derivative of the displacement by the load contains G = F - v F'/2 in place of F.

References
----------
.. [1] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, secs. 3.2 and 4.2
   (point load, ellipse across; the rest is derived here).
"""

from functools import cache

import numpy as np
from scipy.special import beta, ellipe, ellipkm1

from analytic.contact.checks import Array

# ln v of the table: F = 2v ln(4/v) to 1e-11 below it, logarithm to 1e-11 above it
FROM, TO, PER_UNIT = -13.0, 12.0, 128


def log_part(v: Array) -> Array:
    """Asymptote pi/2 (ln 4v + 1/2) of F for large v."""
    return np.asarray(np.pi / 2 * (np.log(4 * v) + 0.5))


def excess(log_v: Array) -> tuple[Array, Array]:
    """F minus its asymptote `log_part`, and the derivative of this difference by ln v.

    Both have the shape of `log_v`. `log_v` must not be a scalar.

    >>> value, _ = excess(np.log([1e-2, 1.0, 1e4]))
    >>> F = value + log_part(np.array([1e-2, 1.0, 1e4]))
    >>> F[0] / (2e-2 * np.log(4 / 1e-2)), F[2] / log_part(1e4)  # both limits
    (np.float64(1.00...), np.float64(1.000000000...))
    """
    t = (log_v - FROM) * PER_UNIT
    np.maximum(t, 0.0, out=t)
    np.minimum(t, (TO - FROM) * PER_UNIT - 1e-6, out=t)
    interval = t.astype(np.intp)
    t -= interval
    c_0, c_1, c_2, c_3 = (c.take(interval) for c in _cubics())
    square, cube = c_2 * t, c_3 * t
    cube *= t
    value = cube + square
    value += c_1
    value *= t
    value += c_0
    square *= 2
    cube *= 3
    slope = c_1
    slope += square
    slope += cube
    slope *= PER_UNIT
    return value, slope


def far_coefficients(terms: int) -> Array:
    """Coefficients c_1, c_2, ... of the series of F in v^(-2).

    >>> round(float(far_coefficients(1)[0] / np.pi), 12)  # 1/32
    0.03125
    """
    i = np.arange(1, terms + 1)
    odd_over_even = np.cumprod((2 * i - 1) / (2 * i))
    return np.asarray((-1.0) ** (i + 1) / (2 * i) * odd_over_even * beta(i + 0.5, 1.5))


@cache
def _cubics() -> tuple[Array, ...]:
    """Coefficients of the cubic polynomials on all intervals of the table."""
    edges = np.linspace(FROM, TO, round((TO - FROM) * PER_UNIT) + 1)
    points, weights = np.polynomial.legendre.leggauss(8)
    width = 1 / PER_UNIT
    inside = edges[:-1, None] + width * (points + 1) / 2
    steps = width / 2 * _slope(inside) @ weights
    low = np.exp(edges[0])
    F = 2 * low * np.log(4 / low) + np.concatenate([[0.0], np.cumsum(steps)])
    value = F - log_part(np.exp(edges))
    slope = (_slope(edges) - np.pi / 2) * width
    rise = np.diff(value)
    return (
        value[:-1],
        slope[:-1],
        3 * rise - 2 * slope[:-1] - slope[1:],
        slope[:-1] + slope[1:] - 2 * rise,
    )


def _slope(log_v: Array) -> Array:
    """Derivative dF/d(ln v); for large v, where K - E loses digits, from the series."""
    v = np.exp(np.minimum(log_v, 2.0))
    complement = v**2 / (1 + v**2)  # 1 - m, exact for small v
    near = 2 * v * np.sqrt(1 + v**2) * (ellipkm1(complement) - ellipe(1 - complement))
    c = far_coefficients(12)
    i = np.arange(1, 13)
    far = np.pi / 2 - (2 * i * c * np.exp(-2 * i * np.maximum(log_v, 2.0)[..., None])).sum(-1)
    return np.asarray(np.where(log_v < 2.0, near, far))

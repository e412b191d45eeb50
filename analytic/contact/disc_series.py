r"""First correction to Hertz for a disc between two rigid flats, by asymptotic expansion.

Three effects that Hertz neglects enter at the order (a/R)²; with R = E' = 1:

- the circle is steeper than the parabola, 1 - y = x²/2 + x⁴/8;
- in the kernel of `disc`, the forces at the opposite contact add +(x² + x'²)/4;
- the uniform tension that removes the stresses of these forces from the rim adds -(x² + x'²)/2.

The sum of both kernel terms, -(x² + x'²)/4, times 2/pi and integrated over the load P = pi a²/4,
changes the effective profile for the half plane to (1 + a²/4) x²/2 + x⁴/8. The pressure sqrt(a² -
x²) (1/2 + a²/4 + x²/4) is the exact solution for this profile, hence

.. math::
    p_0 = \frac{E' a}{2R}\left[1 + \frac{1}{2}\frac{a^2}{R^2}\right], \qquad
    P = \frac{\pi E' a^2}{4R}\left[1 + \frac{5}{8}\frac{a^2}{R^2}\right].

p_0 exceeds Hertz's value by 3/16 (a/R)²: the kernel causes 2/16, the circle 1/16. The neglected
terms of each bracket are of the order (a/R)⁴.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, positive


def pressure_excess(*, a: ArrayLike, R: ArrayLike) -> Array:
    """Relative excess of p_0 over Hertz's value under the same load: 3/16 (a/R)².

    >>> float(pressure_excess(a=0.25, R=1.0))  # 3/256
    0.01171875
    """
    return np.asarray(3 / 16 * _ratio(a, R) ** 2)


def width_excess(*, a: ArrayLike, R: ArrayLike) -> Array:
    """Relative excess of the half-width over Hertz's value under the same load: -5/16 (a/R)²."""
    return np.asarray(-5 / 16 * _ratio(a, R) ** 2)


def moment_width_excess(*, a: ArrayLike, R: ArrayLike) -> Array:
    """Relative excess of the half-width 2 sqrt(int q x² / int q) over Hertz's: -1/4 (a/R)².

    The relative displacement of the edge of the contact is -5/16 (a/R)²; the flatter pressure
    distribution adds 1/16 (a/R)².
    """
    return np.asarray(-1 / 4 * _ratio(a, R) ** 2)


def approach(*, P: ArrayLike, a: ArrayLike, R: ArrayLike, E_plane: ArrayLike) -> Array:
    r"""Approach [length] of one flat and the centre of the disc; a is the true half-width.

    .. math:: \delta = \frac{P}{\pi E'}\left[2\ln\frac{4R}{a} - 1 - \frac{a^2}{16 R^2}\right]

    With Hertz's half-width in the logarithm, the last term is +9/16 (a/R)².
    """
    P, E_plane = positive(P, "load per length", "N/m"), positive(E_plane, "modulus", "Pa")
    ratio = _ratio(a, R)
    bracket = -2 * np.log(ratio / 4) - 1 - ratio**2 / 16
    return np.asarray(P / (np.pi * E_plane) * bracket)


def _ratio(a: ArrayLike, R: ArrayLike) -> Array:
    a, R = positive(a, "half-width", "m"), positive(R, "radius", "m")
    if not np.all(a < R):
        raise ValueError(f"the half-width must be below the radius, got a={a} m, R={R} m")
    return np.asarray(a / R)

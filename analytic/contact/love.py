r"""Displacement of the surface of a half-space by a uniformly loaded rectangle (Love).

.. math::
    u(x, y) = \frac{1}{\pi E^*} \sum_{s, t = \pm 1} s\,t\,f(x + s a, y + t b), \qquad
    f(\xi, \eta) = \xi \sinh^{-1}\frac{\eta}{|\xi|} + \eta \sinh^{-1}\frac{\xi}{|\eta|}

is the normal displacement under unit pressure on :math:`|x| < a, |y| < b`; with the contact modulus
E* it is the sum of both bodies' displacements. Any consistent units.

References
----------
.. [1] A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377-420.
.. [2] K. L. Johnson, Contact Mechanics, Cambridge University Press 1985, Eq. 3.25.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.checks import Array, finite, positive

FAR = 24.0  # cells from which on quadrature is closer than corners that cancel
GAUSS = ((-np.sqrt(0.6), 5 / 18), (0.0, 8 / 18), (np.sqrt(0.6), 5 / 18))


def displacement(
    x: ArrayLike, y: ArrayLike, *, a: ArrayLike, b: ArrayLike, E_star: ArrayLike
) -> Array:
    """Displacement [length] at (x, y) under unit pressure on a rectangle 2a by 2b at the origin.

    >>> u = displacement(0.0, 0.0, a=1.0, b=1.0, E_star=8 / np.pi)  # 8 a asinh(1) / (pi E*)
    >>> bool(np.isclose(u, np.log(1 + np.sqrt(2))))
    True
    """
    x, y = finite(x, "position", "m"), finite(y, "position", "m")
    a, b = positive(a, "half-side", "m"), positive(b, "half-side", "m")
    E_star = positive(E_star, "contact modulus", "Pa")
    corners = (s * t * _corner(x + s * a, y + t * b) for s in (-1, 1) for t in (-1, 1))
    return np.asarray(sum(corners) / (np.pi * E_star))


def table(shape: tuple[int, int], *, cell: tuple[float, float], E_star: float) -> Array:
    """Displacements at distances of (i, j) cells from a cell under unit pressure, shape `shape`.

    Neighbouring cells share the values at their corners. At large distances, the difference of the
    corner values has a rounding error of `eps (distance / cell)²`. Beyond FAR cells, Gauss'
    quadrature of 1/r with 3 by 3 points is used, whose error decreases with the distance.
    """
    hx, hy = cell
    x, y = (np.arange(n) * h for n, h in zip(shape, cell, strict=True))
    edges = ((np.arange(n + 1) - 0.5) * h for n, h in zip(shape, cell, strict=True))
    corners = _corner(*np.meshgrid(*edges, indexing="ij", sparse=True))
    near = np.diff(np.diff(corners, axis=0), axis=1)
    far = np.zeros(shape)
    points = [(u * hx / 2, v * hy / 2, w * t) for u, w in GAUSS for v, t in GAUSS]
    rows, columns = (min(n, int(FAR * max(cell) / h) + 1) for n, h in zip(shape, cell, strict=True))
    for part in (np.s_[rows:, :], np.s_[:rows, columns:]):
        for dx, dy, w in points:
            far[part] += w * hx * hy / np.hypot(x[part[0], None] + dx, y[part[1]] + dy)
    far[:rows, :columns] = near[:rows, :columns]
    return far / (np.pi * E_star)


def _corner(x: Array, y: Array) -> Array:
    with np.errstate(divide="ignore", invalid="ignore"):  # x asinh(y / x) is zero at x = 0
        along = np.where(x == 0, 0.0, x * np.arcsinh(y / np.abs(x)))
        across = np.where(y == 0, 0.0, y * np.arcsinh(x / np.abs(y)))
    return np.asarray(along + across)

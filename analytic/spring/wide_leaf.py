r"""Stiffening of a leaf by its width: plate clamped along two edges, by Ritz's method.

A leaf of length l and width h is clamped at x = 0. At x = l, it is displaced by w = 1 without
rotation. The other edges are free. A narrow leaf bends as a beam of stiffness E I with anticlastic
curvature. In a wide leaf, this transverse curvature is prevented, and the stiffness is E I/(1 -
nu^2). With :math:`\xi = 2x/l - 1`, :math:`\eta = 2y/h`, :math:`s = l/h` the energy

.. math:: \Pi = \tfrac12\int\int w_{\xi\xi}^2 + s^4 w_{\eta\eta}^2
   + 2\nu s^2 w_{\xi\xi} w_{\eta\eta} + 2(1-\nu) s^2 w_{\xi\eta}^2 \, d\xi\,d\eta

of Kirchhoff's plate is minimised by the deflection

.. math:: w = \tfrac12 + \tfrac34\xi - \tfrac14\xi^3
   + \sum_{i\ \text{odd}} \sum_{j\ \text{even}} c_{ij}\, X_i(\xi)\, Y_j(\eta),

where X_i'' and Y_j'' are Legendre polynomials, so that X_i and X_i' are zero at both ends (i >= 3).
With a finite number of terms, the stiffness is too large. The energy of the beam is 3/2, with E I
in place of the stiffness of the plate. Hence the factor :math:`f = \Pi/(3/2)/(1-\nu^2)`, which
depends only on h/l and nu.

References
----------
.. [1] S. P. Timoshenko, S. Woinowsky-Krieger, Theory of Plates and Shells, 2nd ed., McGraw-Hill
   1959, art. 80 (strain energy).
.. [2] D. G. Ashwell, The anticlastic curvature of rectangular beams and plates, J. R. Aeronaut.
   Soc. 54 (1950) 708-715.
"""

from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

TERMS = 24
SHAPE = (0.5, 0.75, 0.0, -0.25)  # of a beam, powers of xi


def width_factor(h: ArrayLike, length: ArrayLike, *, nu: float = 0.3, terms: int = TERMS) -> Any:
    """Ratio [1] of the stiffness of a leaf to that of a narrow one, from 1 to 1/(1 - nu^2).

    Parameters
    ----------
    h, length
        Width and length of the leaf, in the same unit; arrays broadcast.
    nu
        Poisson's ratio, 0 to 0.5.
    terms
        Number of polynomials per direction. With 24, the error is below 1e-5 for h/length from 1/20
        to 30, and below 2e-4 outside this range.

    Raises
    ------
    ValueError
        If a length is not positive, or nu is outside [0, 0.5].

    >>> [round(float(width_factor(h, 1.0)), 4) for h in (0.1, 1.0, 10.0)]  # 1/(1 - nu^2) = 1.0989
    [1.0204, 1.0834, 1.0974]
    >>> round(float(width_factor(1.0, 1.0, nu=0.0)), 12)
    1.0
    """
    h, length = np.asarray(h, float), np.asarray(length, float)
    if not (np.all(h > 0) and np.all(length > 0)):
        raise ValueError(f"width and length must be positive, got h={h} m, length={length} m")
    if not 0 <= nu <= 0.5:
        raise ValueError(f"Poisson's ratio must lie in [0, 0.5], got nu={nu:g}")
    if terms < 1:
        raise ValueError(f"terms must be at least 1, got {terms}")
    squared = (length / h) ** 2
    factors = [_energy(float(s), nu, terms) / 1.5 / (1 - nu**2) for s in squared.ravel()]
    return np.array(factors).reshape(squared.shape)[()]


def _energy(s: float, nu: float, terms: int) -> float:
    """Minimum of the energy; `s` is (l/h)^2, the square of s in the equation of the module."""
    along, across, poisson, twist = _parts(terms)
    K = along + s**2 * across + s * (nu * poisson + 2 * (1 - nu) * twist)
    free = slice(terms + 1, None)  # the shape of a beam, uniform across, is prescribed
    c = np.linalg.solve(K[free, free], -K[free, 0])
    return float(K[0, 0] + c @ K[free, 0]) / 2


@cache
def _parts(terms: int) -> tuple[Array, Array, Array, Array]:
    """Matrices of the four products in the energy; the index of Y changes faster than that of X."""
    beam = legendre.poly2leg(SHAPE)
    X = [beam, *(legendre.legint(_unit(k), 2, lbnd=-1) for k in range(3, 2 * terms + 3, 2))]
    Y = [_unit(0), *(legendre.legint(_unit(k), 2) for k in range(0, 2 * terms, 2))]
    x, y = _products(X), _products(Y)
    poisson = np.kron(x[2, 0], y[0, 2]) + np.kron(x[0, 2], y[2, 0])
    return np.kron(x[2, 2], y[0, 0]), np.kron(x[0, 0], y[2, 2]), poisson, np.kron(x[1, 1], y[1, 1])


def _unit(k: int) -> Array:
    """Coefficients of the Legendre polynomial of degree k."""
    return np.asarray(np.eye(k + 1)[k], dtype=np.float64)


def _products(functions: Sequence[NDArray[Any]]) -> Array:
    """Integrals (3, 3, m, m) of products of the derivatives of `functions`, of orders 0 to 2."""
    degree = max(map(len, functions))
    t, w = legendre.leggauss(degree)
    values = np.array([
        [legendre.legval(t, legendre.legder(f, order)) for f in functions] for order in range(3)
    ])  # fmt: skip
    return np.asarray(np.einsum("aiq,bjq,q->abij", values, values, w))

"""Nine-node quadrilateral on the unit square: shape functions, Gauss points, tying points.

The nodes are corners, middles of the edges and centre, in the order of scikit-fem and gmsh. Strains
that contain derivatives along one direction only are evaluated at two Gauss points along this
direction, where the strains of thin shells can be zero, and at three along the other direction.
Strains with derivatives along both directions are evaluated at two along each (MITC9).

References
----------
.. [1] M. L. Bucalem, K.-J. Bathe, Higher-order MITC general shell elements, Int. J. Numer.
   Methods Eng. 36 (1993) 3729-3754.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from skfem import ElementQuad2

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

NODES = 9


class Shapes(NamedTuple):
    """Values `N` (points, 9) and derivatives `slopes` (points, 2, 9) of shape functions."""

    N: Array
    slopes: Array


def gauss(count: int) -> tuple[Array, Array]:
    """Gauss points and weights on [0, 1]."""
    x, w = np.polynomial.legendre.leggauss(count)
    return (x + 1) / 2, w / 2


def grid(first: Array, second: Array) -> Array:
    """Points (2, k) of a tensor grid; the second coordinate runs fastest."""
    return np.array([a.ravel() for a in np.meshgrid(first, second, indexing="ij")])


def shapes(X: Array) -> Shapes:
    """Shape functions of all nodes at the points X (2, k) of the unit square."""
    element = ElementQuad2()
    each: list[Any] = [element.lbasis(X, i) for i in range(NODES)]
    slopes = np.array([slope for _, slope in each]).transpose(2, 1, 0)
    return Shapes(np.array([N for N, _ in each]).T, slopes)


def _lagrange(nodes: Array, x: Array) -> Array:
    """Polynomials (len(x), len(nodes)) that are 1 at one node and 0 at the others."""
    factors = (x[:, None, None] - nodes) / (nodes[:, None] - nodes + np.eye(len(nodes)))
    factors[:, np.eye(len(nodes), dtype=bool)] = 1
    return np.asarray(factors.prod(axis=-1), dtype=np.float64)


TWO, THREE = gauss(2)[0], gauss(3)[0]
POINTS = grid(THREE, THREE)
WEIGHTS = np.outer(gauss(3)[1], gauss(3)[1]).ravel()

# tying points of strains along the first direction, along the second, and along both
TYING = (grid(TWO, THREE), grid(THREE, TWO), grid(TWO, TWO))
_FROM_TWO, _FROM_THREE = _lagrange(TWO, THREE), np.eye(3)
TO_POINTS = tuple(
    np.asarray(np.kron(a, b), dtype=np.float64)
    for a, b in ((_FROM_TWO, _FROM_THREE), (_FROM_THREE, _FROM_TWO), (_FROM_TWO, _FROM_TWO))
)

"""Positions along line elements at which contact of the surface is tested."""

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.polynomial.legendre import leggauss

from fem.beam.large_elements import Extended
from fem.beam.section import Array, Indices

A = TypeVar("A", Array, Extended)  # of one precision or the other

GAUSS = tuple((float(at + 1) / 2, float(w) / 2) for at, w in zip(*leggauss(5), strict=True))  # 0..1
EASE = 1e-4  # relative to the thickness: additional gap at the end of a cell


def shapes(xi: A, nodes: int) -> tuple[A, A, A]:
    """Shape functions (k, nodes) at xi in 0..1, and their first and second derivatives.

    The order of nodes is: both ends, then the middle (if any).
    """
    N, N1, N2 = np.zeros((3, *xi.shape, nodes), xi.dtype)
    if nodes == 2:
        N[..., 0], N[..., 1] = 1 - xi, xi
        N1[:] = -1, 1
    else:
        N[..., 0], N[..., 1] = (1 - xi) * (1 - 2 * xi), xi * (2 * xi - 1)
        N[..., 2] = 4 * xi * (1 - xi)
        N1[..., 0], N1[..., 1], N1[..., 2] = 4 * xi - 3, 4 * xi - 1, 4 - 8 * xi
        N2[:] = 4, 4, -8
    return N, N1, N2


def powers(corners: Array) -> Array:
    """Coefficients (..., d, 3) of 1, xi and xi^2, from nodal values (..., nodes, d) of elements."""
    first, last = corners[..., 0, :], corners[..., 1, :]
    if corners.shape[-2] == 2:
        return np.stack([first, last - first, 0 * first], axis=-1)
    middle = corners[..., 2, :]
    return np.stack(
        [first, 4 * middle - 3 * first - last, 2 * (first + last) - 4 * middle], axis=-1
    )


def on(curve: Array, xi: Array) -> tuple[Array, Array]:
    """Points (k, 2) of k curves at the parameters xi (k,), and their derivatives d/dxi (k, 2).

    The curves are given by their coefficients from `powers`, (k, 2, 3).
    """
    x0, x1, x2 = curve[..., 0], curve[..., 1], curve[..., 2]
    place = xi[:, None]
    return x0 + place * (x1 + place * x2), x1 + 2 * place * x2


def lengths(points: Array, elements: Indices, upto: Array) -> Array:
    """Arc length (m,) of each element from its first end to the parameter `upto` (m,) in 0..1."""
    total = np.zeros(len(elements))
    for place, share in GAUSS:
        _, slope, _ = shapes(upto * place, elements.shape[1])
        total += share * upto * np.hypot(*np.einsum("kp,kpd->dk", slope, points[elements]))
    return total


@dataclass(frozen=True)
class Probes:
    """Probes, each of which searches for the smallest gap in its part (cell) of an element.

    The cell is `lower` to `upper` (k,) of `element` (k,). `length` (k,) is the length of line that
    a probe represents; for a probe at a free end, it is the thickness. `ease` x (eta - middle)^2/2
    is added to the gap, so that a probe between parallel lines remains in the middle of its cell.
    """

    element: Indices
    nodes: Indices
    lower: Array
    upper: Array
    length: Array
    ease: Array

    @property
    def middle(self) -> Array:
        """Middle of the cells (k,)."""
        return (self.lower + self.upper) / 2


def probes(points: Array, elements: Indices, thickness: float, per_element: int) -> Probes:
    """Probes: `per_element` in equal parts of each element, and one at each free end."""
    size = lengths(points, elements, np.ones(len(elements)))
    element = np.repeat(np.arange(len(elements)), per_element)
    lower = np.tile(np.arange(per_element) / per_element, len(elements))
    uses = np.bincount(elements[:, :2].ravel(), minlength=len(points))
    loose, end = np.nonzero(uses[elements[:, :2]] == 1)
    upper = np.append(lower + 1 / per_element, end.astype(float))
    length = np.append(size[element] / per_element, np.full(loose.size, thickness))
    element, lower = np.append(element, loose), np.append(lower, end.astype(float))
    half = np.maximum(upper - lower, 0.1 / per_element) / 2
    return Probes(element, elements[element], lower, upper, length, 2 * EASE * thickness / half**2)


@dataclass(frozen=True)
class Places:
    """Points on elements: nodes, shape functions `N` (k, p) and their derivatives `N1` = dN/dxi.

    `position`, `slope` and `second` (k, 2) are the position and its first and second derivatives
    with respect to xi.
    """

    nodes: Indices
    N: Array
    N1: Array
    position: Array
    slope: Array
    second: Array


def positions(at: Extended, nodes: Indices, xi: Array) -> Extended:
    """Positions (k, 2) at the parameters xi (k,) on elements (k, p), in extended precision."""
    N, _, _ = shapes(xi.astype(np.longdouble), nodes.shape[1])
    found: Extended = np.einsum("kp,kpd->kd", N, at[nodes, :2])
    return found


def places(at: Array, nodes: Indices, xi: Array) -> Places:
    """Points at the parameters xi (k,) on elements with the given nodes (k, p)."""
    N, N1, N2 = shapes(xi, nodes.shape[1])
    corner = at[nodes, :2]
    x, x1, x2 = (np.einsum("kp,kpd->kd", weights, corner) for weights in (N, N1, N2))
    return Places(nodes, N, N1, x, x1, x2)

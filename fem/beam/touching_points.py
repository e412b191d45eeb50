"""Places along line elements where their surface is probed for contact."""

from dataclasses import dataclass

import numpy as np

from fem.beam.section import Array, Indices

FEWEST = 4  # probes of an element
FACET = 1e-3  # of the thickness: what an arc between two probes may stand proud of them


def shapes(xi: Array, nodes: int) -> tuple[Array, Array, Array]:
    """Shape functions (k, nodes) at xi in 0..1 of ends (and middle), first and second slopes."""
    one, zero = np.ones_like(xi), np.zeros_like(xi)
    if nodes == 2:
        return np.stack([1 - xi, xi], -1), np.stack([-one, one], -1), np.stack([zero, zero], -1)
    return (
        np.stack([(1 - xi) * (1 - 2 * xi), xi * (2 * xi - 1), 4 * xi * (1 - xi)], axis=-1),
        np.stack([4 * xi - 3, 4 * xi - 1, 4 - 8 * xi], axis=-1),
        np.stack([4 * one, 4 * one, -8 * one], axis=-1),
    )


def lengths(points: Array, elements: Indices, upto: Array) -> Array:
    """Arc length (m,) of each element from its first end to the place `upto` (m,) in 0..1."""
    at, weight = np.polynomial.legendre.leggauss(5)
    total = np.zeros(len(elements))
    for place, share in zip((at + 1) / 2, weight / 2, strict=True):
        _, slope, _ = shapes(upto * place, elements.shape[1])
        total += share * upto * np.hypot(*np.einsum("kp,kpd->dk", slope, points[elements]))
    return total


@dataclass(frozen=True)
class Probes:
    """Probes: `element` (k,), place `xi` in 0..1, shares of its nodes `shape`, `slope` (k, p).

    `length` (k,) is what each of them stands for, the thickness at the free end of a line.
    """

    element: Indices
    xi: Array
    nodes: Indices
    shape: Array
    slope: Array
    length: Array


def probes(points: Array, elements: Indices, thickness: float, per_element: int | None) -> Probes:
    """`per_element` probes in equal parts of each element, and one at each free end of a line.

    By default as many as it takes for the facets of an arc to be flat to a thousandth of the
    thickness, four at least.
    """
    size = lengths(points, elements, np.ones(len(elements)))
    facet = np.sqrt(8 * FACET * thickness / np.maximum(curvatures(points, elements), 1e-300))
    enough = np.maximum(FEWEST, np.ceil(size / facet - 1e-9)).astype(int)
    count = enough if per_element is None else np.full_like(enough, per_element)
    element = np.repeat(np.arange(len(elements)), count)
    xi = np.concatenate([(np.arange(m) + 0.5) / m for m in count])
    length = (size / count)[element]
    uses = np.bincount(elements[:, :2].ravel(), minlength=len(points))
    loose, end = np.nonzero(uses[elements[:, :2]] == 1)
    element, xi = np.append(element, loose), np.append(xi, end.astype(float))
    length = np.append(length, np.full(loose.size, thickness))
    shape, slope, _ = shapes(xi, elements.shape[1])
    return Probes(element, xi, elements[element], shape, slope, length)


def curvatures(points: Array, elements: Indices) -> Array:
    """Curvature (m,) in the middle of each element."""
    _, slope, second = shapes(np.full(len(elements), 0.5), elements.shape[1])
    x1, y1 = np.einsum("kp,kpd->dk", slope, points[elements])
    x2, y2 = np.einsum("kp,kpd->dk", second, points[elements])
    return np.abs(x1 * y2 - y1 * x2) / np.hypot(x1, y1) ** 3

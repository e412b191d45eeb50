"""Nested dissection: order of elimination that gives small factors of a plane problem."""

import numpy as np
from skfem import Basis

from fem.plane.discretisation import Indices

MANY, FEW = 16, 4  # directions tried for parts of more than LARGE cells, and for smaller ones
LARGE = 256


def nested_dissection(basis: Basis) -> Indices:
    """Position (unknowns,) of every unknown in the order of elimination.

    Cells are divided into halves by a straight line. Of several directions, the direction that cuts
    the fewest edges is chosen. The halves are divided again, down to single cells. Unknowns common
    to both halves follow all unknowns that belong to one half only.
    """
    path, levels = _halves(basis)
    dofs = np.asarray(basis.element_dofs)
    low, high = np.full(basis.N, 1 << levels), np.full(basis.N, -1)
    for row in dofs:
        np.minimum.at(low, row, path)
        np.maximum.at(high, row, path)
    # the cells of an unknown part where their paths first differ: its height in the tree
    height = np.frexp((low ^ high).astype(float))[1]
    last = ((low >> height) + 1) << height  # after every cell below
    place = np.empty(basis.N, int)
    place[np.lexsort((height, last))] = np.arange(basis.N)
    return place


def _halves(basis: Basis) -> tuple[Indices, int]:
    """Halves that contain each cell, as bits of an integer (cells,), and number of halvings."""
    mesh = basis.mesh
    cells = mesh.nelements
    x, y = mesh.p[:, mesh.t].mean(axis=1)
    left, right = mesh.f2t[:, mesh.f2t[1] >= 0]
    sorted_along = [
        np.argsort(np.cos(angle) * x + np.sin(angle) * y, kind="stable")
        for angle in np.linspace(0, np.pi, MANY, endpoint=False)
    ]
    path, levels = np.zeros(cells, int), 0
    while cells > 1 << levels:
        size = np.bincount(path, minlength=1 << levels)
        start = np.cumsum(size) - size
        inner = path[left] == path[right]
        a, b = left[inner], right[inner]
        shortest, half = np.full(size.size, a.size + 1), np.zeros(cells, bool)
        part = path.astype(np.min_scalar_type(size.size))  # short numbers are sorted faster
        for along in sorted_along[:: 1 if size[0] > LARGE else MANY // FEW]:
            order = along[np.argsort(part[along], kind="stable")]
            rank = np.empty(cells, int)
            rank[order] = np.arange(cells) - start[path[order]]
            upper = rank >= (size[path] + 1) // 2
            cut = np.bincount(path[a[upper[a] != upper[b]]], minlength=size.size)
            half = np.where((cut < shortest)[path], upper, half)
            shortest = np.minimum(cut, shortest)
        path, levels = 2 * path + half, levels + 1
    return path, levels

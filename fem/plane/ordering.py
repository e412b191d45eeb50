"""Nested dissection: the order of elimination that keeps a plane problem's factors small."""

import numpy as np
from skfem import Basis

from fem.plane.discretisation import Indices


def nested_dissection(basis: Basis) -> Indices:
    """Place (unknowns,) of every unknown in the order of elimination.

    Cells are halved across their longer extent, and the halves again, down to single cells.
    Unknowns that both halves share follow all that lie in one of them alone.
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
    """Path (cells,) of every cell through the halvings, a bit each, and their number."""
    mesh = basis.mesh
    centre = mesh.p[:, mesh.t].mean(axis=1)
    cells = mesh.nelements
    path, levels = np.zeros(cells, int), 0
    while cells > 1 << levels:
        parts = 1 << levels
        extent = np.zeros((2, parts))
        for i in (0, 1):
            high, low = np.full(parts, -np.inf), np.full(parts, np.inf)
            np.maximum.at(high, path, centre[i])
            np.minimum.at(low, path, centre[i])
            extent[i] = high - low
        along = np.where((extent[0] >= extent[1])[path], *centre)
        order = np.lexsort((along, path))
        size = np.bincount(path, minlength=parts)
        rank = np.empty(cells, int)
        rank[order] = np.arange(cells) - (np.cumsum(size) - size)[path[order]]
        path, levels = 2 * path + (rank >= (size[path] + 1) // 2), levels + 1
    return path, levels

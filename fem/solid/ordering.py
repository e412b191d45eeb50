"""Nested dissection of a mesh in space: order of elimination that gives sparse factors."""

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra
from skfem.mesh import Mesh3D

from fem.solid.geometry import Array, Indices


def nested_dissection(mesh: Mesh3D) -> Indices:
    """Position (nodes,) of every node in the order of elimination.

    Cells are sorted by x, by y, by z, or by their distance, counted in cells along the body, from a
    cell at one end, and are divided into two halves. Of these four divisions, the one with the
    fewest faces between the halves is used. The halves are divided again, down to single cells.
    Nodes common to both halves follow all nodes that belong to one half only.
    """
    path, levels = _halves(mesh)
    nodes = np.asarray(mesh.dofs.element_dofs)
    count = mesh.doflocs.shape[1]
    low, high = np.full(count, 1 << levels), np.full(count, -1)
    for row in nodes:
        np.minimum.at(low, row, path)
        np.maximum.at(high, row, path)
    # the cells of a node part where their paths first differ: its height in the tree
    height = np.frexp((low ^ high).astype(float))[1]
    last = ((low >> height) + 1) << height  # after every cell below
    place = np.empty(count, int)
    place[np.lexsort((height, last))] = np.arange(count)
    return place


def _halves(mesh: Mesh3D) -> tuple[Indices, int]:
    """Halves (cells,) to which each cell belongs, one bit per division, and number of divisions."""
    cells = mesh.nelements
    left, right = mesh.f2t[:, mesh.f2t[1] >= 0]
    along = [*mesh.p[:, mesh.t].mean(axis=1), _distance(cells, left, right)]
    orders = [np.argsort(a, kind="stable") for a in along]
    path, levels = np.zeros(cells, int), 0
    while cells > 1 << levels:
        size = np.bincount(path, minlength=1 << levels)
        start = np.cumsum(size) - size
        inner = path[left] == path[right]
        a, b = left[inner], right[inner]
        fewest, half = np.full(size.size, a.size + 1), np.zeros(cells, bool)
        for one in orders:
            order = one[np.argsort(path[one], kind="stable")]
            rank = np.empty(cells, int)
            rank[order] = np.arange(cells) - start[path[order]]
            upper = rank >= (size[path] + 1) // 2
            cut = np.bincount(path[a[upper[a] != upper[b]]], minlength=size.size)
            half = np.where((cut < fewest)[path], upper, half)
            fewest = np.minimum(cut, fewest)
        path, levels = 2 * path + half, levels + 1
    return path, levels


def _distance(cells: int, left: Indices, right: Indices) -> Array:
    """Numbers (cells,) of faces on the shortest path from each cell to a cell at the far end.

    The far end is the end of the body that is most distant from cell 0. Cells of other bodies come
    last.
    """
    links = csr_array((np.ones(left.size), (left, right)), (cells, cells))

    def from_cell(k: int) -> Array:
        steps = dijkstra(links, directed=False, indices=k, unweighted=True)
        return np.where(np.isfinite(steps), steps, float(cells))

    first = from_cell(0)
    return from_cell(int(np.argmax(np.where(first < cells, first, -1.0))))

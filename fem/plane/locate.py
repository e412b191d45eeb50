"""The cell of a plane mesh that a point lies in, and the point's coordinates in that cell.

Cells may have curved edges. Coordinates count from a corner of their own cell, so that round-off
stays small against a cell however far it lies from the origin.
"""

import numpy as np
from scipy.spatial import cKDTree
from skfem import MeshTri1
from skfem.mesh import Mesh2D

from fem.plane.discretisation import Array, Indices, is_curved
from fem.plane.geometry import shapes

INSIDE = 1e-4  # of a cell: a wall's parabola misses its circle by less, and so does round-off
BULGE = 1 / 3  # of a cell's extent, the most by which a quadratic edge leaves the box of its nodes
TRIALS = ((4, 0.0), (32, 0.0), (32, INSIDE))  # nearest cells, and gap; after these, all cells
ROUND_OFF_DIGITS = 9  # of a depth: cells that hold a point as deeply count by their number
NEWTON_STEPS = 25
NEWTON_REACH = 0.25  # how far outside its cell an iterate may go, so that it does come back
NEWTON_DONE = 1e-12
PAIRS = 4_000_000  # points times cells compared at once: some ten megabytes


def locate(mesh: Mesh2D, points: Array) -> tuple[Indices, Array]:
    """Cell (m,) and reference coordinates (2, m) of each of `points` (2, m).

    A point between cells gets one of them, always the same. ValueError names the first point that
    lies in no cell.
    """
    nodes = mesh.doflocs[:, np.asarray(mesh.dofs.element_dofs)]
    low, high = nodes.min(axis=1), nodes.max(axis=1)
    margin = (INSIDE + (BULGE if is_curved(mesh) else 0.0)) * (high - low).max(axis=0)
    low, high = low - margin, high + margin
    tree = cKDTree(((low + high) / 2).T)
    cell, X = np.full(points.shape[1], -1), np.zeros(points.shape)

    def settle(point: Indices, tried: Indices, gap: float) -> None:
        """Give each `point` its deepest cell of those `tried` with it, to within `gap` outside."""
        found, depth = _invert(mesh, nodes[:, :, tried], points[:, point])
        order = np.lexsort((tried, -np.round(depth, ROUND_OFF_DIGITS), point))
        first = order[np.unique(point[order], return_index=True)[1]]
        best = first[depth[first] >= -gap]
        cell[point[best]], X[:, point[best]] = tried[best], found[:, best]

    for count, gap in TRIALS:
        count = min(count, mesh.nelements)
        left = np.flatnonzero(cell < 0)
        near = tree.query(points[:, left].T, count)[1].reshape(left.size, count)
        row, column = np.nonzero(_within(points[:, left, None], low[:, near], high[:, near]))
        settle(left[row], near[row, column], gap)
    left = np.flatnonzero(cell < 0)
    for part in np.array_split(left, 1 + left.size * mesh.nelements // PAIRS):
        row, tried = np.nonzero(_within(points[:, part, None], low[:, None], high[:, None]))
        settle(part[row], tried, INSIDE)
        if np.any(cell[part] < 0):
            x, y = points[:, part[cell[part] < 0][0]]
            raise ValueError(f"the point ({x:g}, {y:g}) lies outside the mesh")
    return cell, X


def _within(x: Array, low: Array, high: Array) -> Array:
    return np.all((low <= x) & (x <= high), axis=0)


def _invert(mesh: Mesh2D, nodes: Array, x: Array) -> tuple[Array, Array]:
    """Reference coordinates (2, m) of `x` (2, m) in cells with `nodes` (2, n, m), and depth (m,).

    Newton's method. The depth is the distance to the nearest edge, as a share of the cell, and
    minus infinity where no point of the neighbourhood of the cell maps to x.
    """
    corner = nodes[:, 0]
    nodes, x = nodes - corner[:, None], x - corner
    triangle = isinstance(mesh, MeshTri1)
    X = np.full(x.shape, 1 / 3 if triangle else 1 / 2)
    step = np.full(x.shape[1], np.inf)
    for _ in range(NEWTON_STEPS):
        phi, slope = shapes(mesh.elem(), X)
        miss = x - np.einsum("inm,nm->im", nodes, phi)
        (a, b), (c, d) = np.einsum("inm,jnm->ijm", nodes, slope)
        change = np.array([d * miss[0] - b * miss[1], a * miss[1] - c * miss[0]])
        before = X
        with np.errstate(divide="ignore", invalid="ignore"):  # far outside, cells may fold over
            X = np.nan_to_num(X + change / (a * d - b * c), nan=0.5)
        X = np.clip(X, -NEWTON_REACH, 1 + NEWTON_REACH)
        step = np.abs(X - before).max(axis=0)
        if np.all(step < NEWTON_DONE):
            break
    phi, _ = shapes(mesh.elem(), X)
    miss = np.abs(x - np.einsum("inm,nm->im", nodes, phi)).max(axis=0)
    sides = np.array([*X, 1 - X[0] - X[1]]) if triangle else np.array([*X, *(1 - X)])
    reached = miss < NEWTON_REACH * INSIDE * np.ptp(nodes, axis=1).max(axis=0)
    return X, np.where(reached, sides.min(axis=0), -np.inf)

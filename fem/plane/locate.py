"""Cell of a plane mesh that contains a point, and coordinates of the point in the cell.

Cells may have curved edges. Coordinates are relative to a corner of the cell. The round-off is
therefore small relative to the cell at any distance from the origin.
"""

import numpy as np
from scipy.spatial import cKDTree
from skfem import Element, MeshTri1
from skfem.mesh import Mesh2D

from fem.plane.discretisation import Array, Indices, is_curved
from fem.plane.geometry import shapes

INSIDE = 1e-4  # relative to a cell: a circle's parabolas miss it by less, and so does round-off
BULGE = 1 / 3  # of a cell's extent, the most by which a quadratic edge leaves the box of its nodes
TRIALS = ((4, 0.0), (32, 0.0), (32, INSIDE))  # nearest cells, and gap; after these, all cells
ROUND_OFF_DIGITS = 9  # of a depth: cells that hold a point as deeply count by their number
NEWTON_STEPS = 25
NEWTON_REACH = 0.25  # largest distance of an iterate from its cell, so that it returns
NEWTON_DONE = 1e-12
PAIRS = 4_000_000  # points times cells compared at once: some ten megabytes


def locate(mesh: Mesh2D, points: Array) -> tuple[Indices, Array]:
    """Cell (m,) and reference coordinates (2, m) of each of the `points` (2, m).

    A point on an edge, or in overlapping bodies, is always assigned to the same cell. A point
    outside the mesh by less than `INSIDE` times the cell size is accepted. This margin covers
    circles approximated by parabolas, but not other approximated curves. Raises ValueError for the
    first point that is in no cell, with its distance from the boundary.
    """
    nodes = mesh.doflocs[:, np.asarray(mesh.dofs.element_dofs)]
    low, high = nodes.min(axis=1), nodes.max(axis=1)
    margin = (INSIDE + (BULGE if is_curved(mesh) else 0.0)) * (high - low).max(axis=0)
    low, high = low - margin, high + margin
    tree = cKDTree(((low + high) / 2).T)
    corners = mesh.elem.refdom.p.T
    starts = np.vstack([corners.mean(axis=0), mesh.elem.doflocs])
    cell, X = np.full(points.shape[1], -1), np.zeros(points.shape)

    def settle(point: Indices, tried: Indices, gap: float, starts: Array) -> None:
        """Assign each `point` to one of the cells `tried`: the cell in which the point is deepest.

        A point may be outside a cell by `gap` at most.
        """
        found, depth = _invert(mesh, nodes[:, :, tried], points[:, point], starts)
        order = np.lexsort((tried, -np.round(depth, ROUND_OFF_DIGITS), point))
        first = order[np.unique(point[order], return_index=True)[1]]
        best = first[depth[first] >= -gap]
        cell[point[best]], X[:, point[best]] = tried[best], found[:, best]

    for count, gap in TRIALS:
        count = min(count, mesh.nelements)
        left = np.flatnonzero(cell < 0)
        near = tree.query(points[:, left].T, count)[1].reshape(left.size, count)
        row, column = np.nonzero(_within(points[:, left, None], low[:, near], high[:, near]))
        settle(left[row], near[row, column], gap, starts[:1])
    left = np.flatnonzero(cell < 0)
    if not left.size:
        return cell, X
    for part in np.array_split(left, 1 + left.size * mesh.nelements // PAIRS):
        row, tried = np.nonzero(_within(points[:, part, None], low[:, None], high[:, None]))
        settle(part[row], tried, INSIDE, starts)
        if np.any(cell[part] < 0):
            x, y = outside = points[:, part[cell[part] < 0][0]]
            raise ValueError(
                f"the point ({x:.10g}, {y:.10g}) lies outside the mesh, "
                f"{_distance(mesh, outside):.3g} from its boundary"
            )
    return cell, X


def _within(x: Array, low: Array, high: Array) -> Array:
    return np.all((low <= x) & (x <= high), axis=0)


def _distance(mesh: Mesh2D, x: Array) -> float:
    """Distance of `x` (2,) from the boundary; each facet is approximated by eight chords."""
    ends = mesh.mapping().G(np.linspace(0, 1, 9)[None], find=mesh.boundary_facets())
    ends = ends - x[:, None, None]
    start, along = ends[..., :-1], np.diff(ends)
    share = np.clip(-(start * along).sum(axis=0) / (along**2).sum(axis=0), 0, 1)
    return float(np.hypot(*(start + share * along)).min())


def _invert(mesh: Mesh2D, nodes: Array, x: Array, starts: Array) -> tuple[Array, Array]:
    """Reference coordinates (2, m) of `x` (2, m) in cells with `nodes` (2, n, m), and depth (m,).

    Newton's method begins at each of `starts` (k, 2) in turn, until the result is inside the cell:
    near a distorted cell, a second point may also map to x. The depth is the distance to the
    nearest edge divided by the size of the cell, or minus infinity if no point near the cell maps
    to x.
    """
    corner = nodes[:, 0]
    nodes, x = nodes - corner[:, None], x - corner
    reach = NEWTON_REACH * INSIDE * np.ptp(nodes, axis=1).max(axis=0, initial=0)
    X, depth = np.zeros(x.shape), np.full(x.shape[1], -np.inf)
    for start in starts:
        left = np.flatnonzero(depth < 0)
        found, miss = _newton(mesh.elem(), nodes[:, :, left], x[:, left], start)
        beyond = [1 - found.sum(axis=0)] if isinstance(mesh, MeshTri1) else 1 - found
        inside = np.where(miss < reach[left], np.min([*found, *beyond], axis=0), -np.inf)
        deeper = inside > depth[left]
        X[:, left[deeper]], depth[left[deeper]] = found[:, deeper], inside[deeper]
    return X, depth


def _newton(elem: Element, nodes: Array, x: Array, start: Array) -> tuple[Array, Array]:
    """Reference coordinates (2, m) of `x` by iteration from `start`, and remaining distances."""
    X, at = np.repeat(start[:, None], x.shape[1], axis=1), np.arange(x.shape[1])
    for _ in range(NEWTON_STEPS):
        phi, slope = shapes(elem, X[:, at])
        gap = x[:, at] - np.einsum("inm,nm->im", nodes[:, :, at], phi)
        (a, b), (c, d) = np.einsum("inm,jnm->ijm", nodes[:, :, at], slope)
        change = np.array([d * gap[0] - b * gap[1], a * gap[1] - c * gap[0]])
        with np.errstate(divide="ignore", invalid="ignore"):  # far outside, cells may fold over
            moved = np.nan_to_num(X[:, at] + change / (a * d - b * c), nan=0.5)
        moved = np.clip(moved, -NEWTON_REACH, 1 + NEWTON_REACH)
        step, X[:, at] = np.abs(moved - X[:, at]).max(axis=0), moved
        at = at[step > NEWTON_DONE]
        if not at.size:
            break
    phi, _ = shapes(elem, X)
    return X, np.abs(x - np.einsum("inm,nm->im", nodes, phi)).max(axis=0)

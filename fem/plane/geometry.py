"""Maps from reference cells to the plane: shape functions, Jacobians, test for folded cells."""

import numpy as np
from numpy.typing import NDArray
from skfem import Element, ElementQuad1, ElementQuad2
from skfem.mesh import Mesh2D

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

TENSOR = {ElementQuad1: 1, ElementQuad2: 2}  # products of polynomials of this degree
FLAT = 1e-9  # relative to a cell's largest determinant: below, it vanishes to round-off


def shapes(elem: Element, X: Array) -> tuple[Array, Array]:
    """Shape functions (n, ...) of `elem` and their derivatives (2, n, ...) at `X` (2, ...)."""
    if degree := TENSOR.get(type(elem), 0):
        i, j = np.rint(degree * elem.doflocs.T).astype(int)
        (x, y), (dx, dy) = (np.moveaxis(a, 1, 0) for a in _on_line(X, degree))
        return x[i] * y[j], np.array([dx[i] * y[j], x[i] * dy[j]])
    pairs = [elem.lbasis(X, k) for k in range(len(elem.doflocs))]
    phi = np.array([np.broadcast_to(value, X.shape[1:]) for value, _ in pairs])
    slope = [[np.broadcast_to(d, X.shape[1:]) for d in slopes] for _, slopes in pairs]
    return phi, np.array(slope).swapaxes(0, 1)


def _on_line(x: Array, degree: int) -> tuple[Array, Array]:
    """Lagrange polynomials (degree + 1, ...) of equidistant nodes on [0, 1], and derivatives."""
    if degree == 1:
        return np.array([1 - x, x]), np.array([np.full(x.shape, -1.0), np.ones(x.shape)])
    values = np.array([(1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)])
    return values, np.array([4 * x - 3, 4 - 8 * x, 4 * x - 1])


def jacobians(mesh: Mesh2D, X: Array, cells: Indices | None = None) -> tuple[Array, Array]:
    """Jacobian matrices dx_i / dX_j (m, q, 2, 2) at reference points `X`, and determinants (m, q).

    For all cells, `X` is (2, q). For `cells` (m,), `X` may also be (2, m, q), with separate points
    in each cell. Coordinates are relative to a node of the cell. The round-off is therefore small
    relative to the cell at any distance from the origin.
    """
    t = np.asarray(mesh.dofs.element_dofs)
    nodes = mesh.doflocs[:, t if cells is None else t[:, cells]]
    nodes = nodes - nodes[:, :1]
    _, slope = shapes(mesh.elem(), X)
    if X.ndim == 3:
        J = np.einsum("inm,jnmq->mqij", nodes, slope)
    else:
        J = np.einsum("inm,jnq->mqij", nodes, slope, optimize=True)
    return J, J[..., 0, 0] * J[..., 1, 1] - J[..., 0, 1] * J[..., 1, 0]


def shapes_in(mesh: Mesh2D, cells: Indices, elem: Element, X: Array) -> tuple[Array, Array]:
    """Shape functions (n, m, q) of `elem` and their derivatives d/dx_i (2, n, m, q).

    The functions are evaluated in `cells` (m,) at reference points `X` (2, m, q) of each cell.
    """
    J, det = jacobians(mesh, X, cells)
    N, (along, across) = shapes(elem, X)
    (a, b), (c, d) = J.transpose(2, 3, 0, 1)
    return N, np.array([d * along - c * across, a * across - b * along]) / det


def check_unfolded(mesh: Mesh2D, quadrature: Array) -> None:
    """Raise ValueError if a cell is folded or flat, or overlaps its neighbour.

    The message states the number of the first such cell. The determinant must have one sign at the
    `quadrature` points (2, q) and at the nodes of the mesh. Two cells must lie on different sides
    of their common edge.
    """
    _, det = jacobians(mesh, np.hstack([quadrature, mesh.elem.doflocs.T]))
    low, high = det.min(axis=1), det.max(axis=1)
    least = FLAT * np.maximum(abs(low), abs(high))
    folded = np.flatnonzero(~((low > least) | (high < -least)))
    if folded.size:
        k = int(folded[0])
        x, y = mesh.p[:, mesh.t[:, k]].mean(axis=1)
        raise ValueError(
            f"cell {k} of {mesh.nelements}, about ({x:.10g}, {y:.10g}), is folded or flat: the "
            f"determinant of its map must keep its sign, but is {low[k]:.3g} to {high[k]:.3g}"
        )
    inner = mesh.f2t[1] >= 0
    start, end = (mesh.p[:, ends] for ends in mesh.facets[:, inner])
    along = end - start
    sides = []
    for cells in mesh.f2t[:, inner]:
        beside = mesh.p[:, mesh.t[:, cells]].mean(axis=1) - start
        sides.append(along[0] * beside[1] - along[1] * beside[0])
    if np.any(same := sides[0] * sides[1] > 0):
        first, second = mesh.f2t[:, inner][:, np.argmax(same)]
        x, y = (start + end)[:, np.argmax(same)] / 2
        raise ValueError(
            f"cells {first} and {second} of {mesh.nelements} lie on the same side of their common "
            f"edge about ({x:.10g}, {y:.10g}): one of the two cells is inverted"
        )

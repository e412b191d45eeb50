"""Maps of hexahedra into space, their faces, and test for folded cells."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from skfem import MeshHex
from skfem.mesh import Mesh3D

from fem.plane.geometry import FLAT, shapes

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

FACE_POINTS = 4  # of Gauss per direction: a load of degree 3 on a curved face costs no order


def degree(mesh: Mesh3D) -> int:
    """Degree of the cells: 2 for 27-node hexahedra, 1 for 8-node; otherwise raises ValueError."""
    if not isinstance(mesh, MeshHex):
        raise ValueError(f"solids require meshes of hexahedra, got {type(mesh).__name__}")
    return 2 if len(mesh.elem.doflocs) == 27 else 1


def cube_rule(points: tuple[int, ...]) -> tuple[Array, Array]:
    """Gauss points (d, q) in the unit cube, and weights (q,), for `points` along each direction."""
    rules = [np.polynomial.legendre.leggauss(n) for n in points]
    X = np.meshgrid(*[(t + 1) / 2 for t, _ in rules], indexing="ij")
    W = np.meshgrid(*[w / 2 for _, w in rules], indexing="ij")
    return np.array([x.ravel() for x in X]), np.prod(W, axis=0).ravel()


def jacobians(mesh: Mesh3D, X: Array, cells: Indices | None = None) -> tuple[Array, Array]:
    """Jacobian matrices dx_i / dX_j (m, q, 3, 3) of `cells`, and determinants (m, q).

    They are evaluated at reference points `X` (3, q). Coordinates are relative to a node of the
    cell. The round-off is therefore small relative to the cell at any distance from the origin.
    """
    chosen = slice(None) if cells is None else cells
    nodes = mesh.doflocs[:, np.asarray(mesh.dofs.element_dofs)[:, chosen]]
    nodes = nodes - nodes[:, :1]
    _, slope = shapes(mesh.elem(), X)
    J = np.einsum("inm,jnq->mqij", nodes, slope, optimize=True)
    return J, np.linalg.det(J)


def check_unfolded(mesh: Mesh3D) -> None:
    """Raise ValueError if a cell is folded or flat; the message states the first such cell.

    The determinant must have the same sign at three Gauss points per direction and at the nodes of
    the cell.
    """
    _, det = jacobians(mesh, np.hstack([cube_rule((3, 3, 3))[0], mesh.elem.doflocs.T]))
    low, high = det.min(axis=1), det.max(axis=1)
    least = FLAT * np.maximum(abs(low), abs(high))
    folded = np.flatnonzero(~((low > least) | (high < -least)))
    if folded.size:
        k = int(folded[0])
        x, y, z = mesh.p[:, mesh.t[:, k]].mean(axis=1)
        raise ValueError(
            f"cell {k} of {mesh.nelements}, about ({x:.10g}, {y:.10g}, {z:.10g}), is folded or "
            f"flat: the determinant of its map must keep its sign, but is {low[k]:.3g} to "
            f"{high[k]:.3g}"
        )


@dataclass(frozen=True)
class Faces:
    """Faces of several cells, all on one side of the reference cube, at Gauss points of the face.

    `nodes` (k, n) are the nodes of the cells, `N` (q, n) their shape functions, `x` (k, q, 3) the
    points. `area` (k, q, 3) are outward normals times weights. `on_face` (n,) is True for nodes on
    the face.
    """

    nodes: Indices
    N: Array
    x: Array
    area: Array
    on_face: NDArray[np.bool_]


def faces(mesh: Mesh3D, facets: Indices) -> list[Faces]:
    """Faces of the first cell at each of `facets`, grouped by side of the reference cube."""
    cells = mesh.f2t[0, facets]
    corner = mesh.t[:, cells]
    inside = np.any(corner[:, None] == mesh.facets[:, facets], axis=1)
    middle = np.einsum("cf,ci->if", inside, mesh.elem.refdom.p.T) / 4
    return [
        _faces(mesh, chosen, axis, end)
        for axis in range(3)
        for end in (0.0, 1.0)
        if (chosen := cells[middle[axis] == end]).size
    ]


def _faces(mesh: Mesh3D, cells: Indices, axis: int, end: float) -> Faces:
    X, weight = cube_rule((FACE_POINTS, FACE_POINTS))
    X = np.insert(X, axis, end, axis=0)
    J, det = jacobians(mesh, X, cells)
    first, second = J[..., (axis + 1) % 3], J[..., (axis + 2) % 3]
    outwards = np.sign(det) * (2 * end - 1) * weight
    nodes = np.asarray(mesh.dofs.element_dofs)[:, cells].T
    N = shapes(mesh.elem(), X)[0].T
    x = N @ mesh.doflocs.T[nodes]
    area = np.cross(first, second) * outwards[..., None]
    return Faces(nodes, N, x, area, mesh.elem.doflocs[:, axis] == end)

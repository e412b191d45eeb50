"""Surface mesh of the current gmsh model as arrays, in memory."""

from dataclasses import dataclass

import gmsh
import numpy as np
from numpy.typing import NDArray

Indices = NDArray[np.int64]
LINE3, QUAD9 = 8, 10  # gmsh's element types


@dataclass(frozen=True)
class ShellMesh:
    """Mesh of nine-node quadrilaterals in space.

    `points` is (n, 3), `cells` (m, 9): corners, middles of the edges, centre. `boundaries`
    contains named groups of edges (k, 3): both end nodes and the middle node. `nodes` contains
    named single nodes, and `bodies` contains named groups of cells.
    """

    points: NDArray[np.float64]
    cells: Indices
    boundaries: dict[str, Indices]
    nodes: dict[str, int]
    bodies: dict[str, Indices]


def shell_mesh() -> ShellMesh:
    """Mesh of the surfaces of the current gmsh model, with names of physical groups.

    Raises ValueError if no surface has a name, or if a surface has other cells than quadratic
    quadrilaterals.
    """
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    blocks, bodies, count = [], {}, 0
    for dim, group in gmsh.model.getPhysicalGroups(2):
        own = [_nodes(dim, e, QUAD9) for e in gmsh.model.getEntitiesForPhysicalGroup(dim, group)]
        blocks += own
        size = sum(map(len, own))
        bodies[gmsh.model.getPhysicalName(dim, group)] = np.arange(count, count + size)
        count += size
    if not blocks:
        raise ValueError("a shell mesh requires physical surfaces, but the model has none")
    used, cells = np.unique(np.concatenate(blocks), return_inverse=True)
    row = np.full(int(tags.max()) + 1, -1)
    row[used] = np.arange(used.size)
    place = np.zeros((row.size, 3))
    place[tags] = coordinates.reshape(-1, 3)
    boundaries = {
        gmsh.model.getPhysicalName(dim, group): np.concatenate([
            row[_nodes(dim, e, LINE3)] for e in gmsh.model.getEntitiesForPhysicalGroup(dim, group)
        ])
        for dim, group in gmsh.model.getPhysicalGroups(1)
    }  # fmt: skip
    nodes = {}
    for dim, group in gmsh.model.getPhysicalGroups(0):
        point = gmsh.model.getEntitiesForPhysicalGroup(dim, group)[0]
        nodes[gmsh.model.getPhysicalName(dim, group)] = int(
            row[gmsh.model.mesh.getNodes(0, point)[0][0]]
        )
    return ShellMesh(place[used], cells.reshape(-1, 9), boundaries, nodes, bodies)


def _nodes(dim: int, entity: int, kind: int) -> Indices:
    """Nodes of the elements (m, 3 or 9) on a curve or surface."""
    kinds, _, nodes = gmsh.model.mesh.getElements(dim, entity)
    if list(kinds) != [kind]:
        what = "curve" if dim == 1 else "surface"
        raise ValueError(
            f"{what} {entity} must have quadratic lines or nine-node quadrilaterals: set the mesh "
            "order to 2"
        )
    size = gmsh.model.mesh.getElementProperties(kind)[3]
    return nodes[0].reshape(-1, size).astype(np.int64)

"""Line mesh of the current gmsh model as arrays, in memory."""

from dataclasses import dataclass

import gmsh
import numpy as np
from numpy.typing import NDArray

LINE3 = 8  # gmsh's element type


@dataclass(frozen=True)
class LineMesh:
    """Quadratic line elements in the plane.

    `points` is (n, 2), `elements` (m, 3): both ends and the middle node. `nodes` names single
    nodes, `bodies` names groups of elements. Middle nodes follow all ends.
    """

    points: NDArray[np.float64]
    elements: NDArray[np.int64]
    nodes: dict[str, int]
    bodies: dict[str, NDArray[np.int64]]

    @property
    def chords(self) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """End points of the elements, and node pairs (m, 2), without the middle nodes."""
        count = int(self.elements[:, :2].max()) + 1
        return self.points[:count], self.elements[:, :2]


def line_mesh() -> LineMesh:
    """Mesh of the curves of the current gmsh model, with names of physical points and curves."""
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    place = dict(zip(tags.tolist(), coordinates.reshape(-1, 3)[:, :2], strict=True))
    blocks, bodies, count = [], {}, 0
    for dim, group in gmsh.model.getPhysicalGroups(1):
        own = [_quadratic(curve) for curve in gmsh.model.getEntitiesForPhysicalGroup(dim, group)]
        blocks += own
        size = sum(map(len, own))
        bodies[gmsh.model.getPhysicalName(dim, group)] = np.arange(count, count + size)
        count += size
    if not blocks:
        raise ValueError("a line mesh requires physical curves, but the model has none")
    cells = np.concatenate(blocks)
    order = np.concatenate([np.unique(cells[:, :2]), cells[:, 2]])  # ends first
    row = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    row[order] = np.arange(order.size)
    nodes = {}
    for dim, group in gmsh.model.getPhysicalGroups(0):
        point = gmsh.model.getEntitiesForPhysicalGroup(dim, group)[0]
        nodes[gmsh.model.getPhysicalName(dim, group)] = int(
            row[gmsh.model.mesh.getNodes(0, point)[0][0]]
        )
    return LineMesh(np.array([place[t] for t in order.tolist()]), row[cells], nodes, bodies)


def _quadratic(curve: int) -> NDArray[np.int64]:
    """Nodes (m, 3) of the elements on `curve`: ends and middle."""
    kinds, _, nodes = gmsh.model.mesh.getElements(1, curve)
    if list(kinds) != [LINE3]:
        raise ValueError(f"curve {curve} must have quadratic elements: set the mesh order to 2")
    return nodes[0].reshape(-1, 3).astype(np.int64)

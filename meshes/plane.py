"""Plane mesh of the current gmsh model for scikit-fem, in memory."""

from dataclasses import dataclass

import gmsh
import numpy as np
from numpy.typing import NDArray
from skfem import MeshQuad1, MeshQuad2, MeshTri1, MeshTri2
from skfem.mesh import Mesh2D

Indices = NDArray[np.int64]

# gmsh's element type -> scikit-fem mesh, nodes per cell, corners per cell
KINDS: dict[int, tuple[type[Mesh2D], int, int]] = {
    2: (MeshTri1, 3, 3),
    3: (MeshQuad1, 4, 4),
    9: (MeshTri2, 6, 3),
    10: (MeshQuad2, 9, 4),
}


def plane_mesh(*, straight: bool = False) -> Mesh2D:
    """Mesh of the current gmsh model for scikit-fem.

    Physical curves become `boundaries`, and physical surfaces become `subdomains`, with their
    names. Nodes are renumbered compactly, vertices first. With `straight`, only the corners of
    curved cells are used. Raises ValueError if the model mixes triangles and quadrilaterals or has
    no cells.
    """
    read = nodes_and_cells(straight=straight)
    mesh = read.shape(read.p, read.t)
    vertex = np.full(int(max(read.node_tags.max(), read.cell_nodes.max())) + 1, -1)
    # MeshTri1 sorts the corners of a cell, so vertices are matched by place, not by order in t
    corners = len(mesh.t)
    if len(read.t) == corners:
        vertex[read.node_tags] = np.arange(read.node_tags.size)
    else:
        vertex[read.cell_nodes[:, :corners].T] = mesh.t
    bodies = _bodies(read.kind, read.cell_tags)
    return mesh.with_boundaries(_boundaries(mesh, vertex)).with_subdomains(bodies)


@dataclass(frozen=True)
class Read:
    """Nodes `p` (2, n) and cells `t` (k, m) of the current gmsh model, with their gmsh tags."""

    shape: type[Mesh2D]
    kind: int
    p: NDArray[np.float64]
    t: Indices
    node_tags: Indices
    cell_tags: Indices
    cell_nodes: Indices


def nodes_and_cells(*, straight: bool = False) -> Read:
    """Nodes and cells of the current gmsh model. Raises ValueError unless cells are of one kind."""
    kinds = [k for k in gmsh.model.mesh.getElementTypes(2) if k in KINDS]
    if len(kinds) != 1:
        names = [gmsh.model.mesh.getElementProperties(k)[0] for k in kinds]
        raise ValueError(f"a plane mesh must have cells of one kind, got {names or 'none'}")
    kind = kinds[0]
    shape, nodes, corners = KINDS[kind]
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    row = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    row[tags] = np.arange(tags.size)
    cell_tags, cell_nodes = gmsh.model.mesh.getElementsByType(kind)
    cell_nodes = cell_nodes.reshape(-1, nodes)
    keep = corners if straight else nodes
    if straight:
        shape = MeshTri1 if corners == 3 else MeshQuad1
    used, t = np.unique(row[cell_nodes[:, :keep]], return_inverse=True)
    p = np.ascontiguousarray(coordinates.reshape(-1, 3)[used, :2].T)
    t = np.ascontiguousarray(t.reshape(-1, keep).T)
    return Read(shape, kind, p, t, tags[used], cell_tags, cell_nodes)


def _boundaries(mesh: Mesh2D, vertex: Indices) -> dict[str, Indices]:
    """Facets of every physical curve, identified by their two vertices."""
    n = mesh.p.shape[1]
    keys = _edge_keys(mesh.facets, n)
    order = np.argsort(keys)
    found: dict[str, Indices] = {}
    for dim, group in gmsh.model.getPhysicalGroups(1):
        ends = [
            nodes.reshape(-1, gmsh.model.mesh.getElementProperties(int(kind))[3])[:, :2]
            for curve in gmsh.model.getEntitiesForPhysicalGroup(dim, group)
            for kind, _, nodes in zip(*gmsh.model.mesh.getElements(1, curve), strict=True)
        ]
        name = gmsh.model.getPhysicalName(dim, group)
        wanted = _edge_keys(vertex[np.concatenate(ends)].T, n)
        place = np.minimum(np.searchsorted(keys, wanted, sorter=order), keys.size - 1)
        if np.any(keys[order[place]] != wanted):
            raise ValueError(f"the curve {name!r} must consist of edges of cells")
        found[name] = order[place]
    return found


def _edge_keys(ends: Indices, n: int) -> Indices:
    low, high = np.sort(ends.astype(np.int64), axis=0)
    return low * n + high


def _bodies(kind: int, cell_tags: Indices) -> dict[str, Indices]:
    """Cells of every physical surface, identified by their gmsh tags."""
    order = np.argsort(cell_tags)
    bodies: dict[str, Indices] = {}
    for dim, group in gmsh.model.getPhysicalGroups(2):
        own = np.concatenate([
            gmsh.model.mesh.getElementsByType(kind, int(surface))[0]
            for surface in gmsh.model.getEntitiesForPhysicalGroup(dim, group)
        ])  # fmt: skip
        bodies[gmsh.model.getPhysicalName(dim, group)] = order[
            np.searchsorted(cell_tags, own, sorter=order)
        ]
    return bodies

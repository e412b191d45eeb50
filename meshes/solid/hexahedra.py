"""Hexahedra of the current gmsh model for scikit-fem, in memory."""

from collections.abc import Iterator

import gmsh
import numpy as np
from numpy.typing import NDArray
from skfem import ElementHex1, ElementHex2, MeshHex, MeshHex2
from skfem.mesh import Mesh3D

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

CORNERS = 8
# gmsh's element type -> scikit-fem mesh and its element
KINDS = {5: (MeshHex, ElementHex1), 12: (MeshHex2, ElementHex2)}


def solid_mesh(*, straight: bool = False) -> Mesh3D:
    """Mesh of 8- or 27-node hexahedra for scikit-fem, from the current gmsh model.

    Physical surfaces become `boundaries`, and physical volumes become `subdomains`, with their
    names. `straight` moves the middle nodes of 27-node cells between their corners. Raises
    ValueError if the model has other cells, or none.
    """
    found = [int(k) for k in gmsh.model.mesh.getElementTypes(3)]
    if len(found) != 1 or found[0] not in KINDS:
        names = [gmsh.model.mesh.getElementProperties(k)[0] for k in found]
        raise ValueError(
            f"a solid mesh must have hexahedra of 8 or 27 nodes, got {names or 'none'}"
        )
    kind = found[0]
    shape, element = KINDS[kind]
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    cell_tags, cell_nodes = gmsh.model.mesh.getElementsByType(kind)
    rows = cell_nodes.reshape(cell_tags.size, -1)[:, _order(kind, element.doflocs)]
    used, t = np.unique(rows, return_inverse=True)
    t = t.reshape(rows.shape)
    place = np.argsort(tags)
    p = coordinates.reshape(-1, 3)[place[np.searchsorted(tags[place], used)]]
    if straight and kind != 5:
        _straighten(p, t, np.asarray(element.doflocs).T)
    mesh = shape(np.ascontiguousarray(p.T), np.ascontiguousarray(t.T))
    vertex = dict(zip(rows[:, :CORNERS].ravel().tolist(), mesh.t.T.ravel().tolist(), strict=True))
    bodies = {name: _cells(kind, cell_tags, volumes) for name, volumes in _named(3)}
    return mesh.with_boundaries(_boundaries(mesh, vertex)).with_subdomains(bodies)


def _order(kind: int, doflocs: Array) -> Indices:
    """For each node of scikit-fem's cell, the index of gmsh's node at the same position.

    Positions in both unit cubes are compared in the same axes; the first reference direction is
    therefore that of gmsh.
    """
    local = np.reshape(gmsh.model.mesh.getElementProperties(kind)[4], (-1, 3))
    return np.array([np.argmin(abs((local + 1) / 2 - x).sum(axis=1)) for x in doflocs])


def _straighten(p: Array, t: Indices, X: Array) -> None:
    """Move all nodes of each cell, at `X` (3, n) of the unit cube, to the trilinear map of `X`."""
    corner = ElementHex1()
    weight = np.array([corner.lbasis(X, k)[0] for k in range(CORNERS)])
    p[t] = np.einsum("mci,cn->mni", p[t[:, :CORNERS]], weight)


def _named(dim: int) -> Iterator[tuple[str, list[int]]]:
    """Names of the physical groups, and their entities."""
    for _, group in gmsh.model.getPhysicalGroups(dim):
        entities = gmsh.model.getEntitiesForPhysicalGroup(dim, group)
        yield gmsh.model.getPhysicalName(dim, group), [int(e) for e in entities]


def _cells(kind: int, cell_tags: Indices, volumes: list[int]) -> Indices:
    own = [gmsh.model.mesh.getElementsByType(kind, volume)[0] for volume in volumes]
    order = np.argsort(cell_tags)
    return np.asarray(order[np.searchsorted(cell_tags[order], np.concatenate(own))])


def _boundaries(mesh: Mesh3D, vertex: dict[int, int]) -> dict[str, Indices]:
    """Facets of every physical surface, identified by their four vertices."""
    facet = {tuple(corners): k for k, corners in enumerate(np.sort(mesh.facets, axis=0).T.tolist())}
    found = {}
    for name, surfaces in _named(2):
        corners = [
            nodes.reshape(-1, gmsh.model.mesh.getElementProperties(int(kind))[3])[:, :4]
            for surface in surfaces
            for kind, _, nodes in zip(*gmsh.model.mesh.getElements(2, surface), strict=True)
        ]
        wanted = np.sort(np.vectorize(vertex.__getitem__)(np.concatenate(corners)), axis=1)
        found[name] = np.array([facet[tuple(row)] for row in wanted.tolist()])
    return found

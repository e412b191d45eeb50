"""Combination of several meshes into one, with unchanged nodes, boundaries and bodies."""

from collections.abc import Mapping

import numpy as np
from skfem.generic_utils import OrientedBoundary
from skfem.mesh import Mesh2D


def join(meshes: Mapping[str, Mesh2D]) -> Mesh2D:
    """Mesh that contains all `meshes`; no nodes are merged, even if they coincide.

    A boundary "surface" of the mesh "disc" becomes "disc.surface", and a body "core" becomes
    "disc.core". The body "disc" is the complete mesh. Vertices, cells and facets have the order of
    the meshes. Raises ValueError without a mesh, or if the meshes have different kinds of cells.
    """
    kinds = {name: type(mesh) for name, mesh in meshes.items()}
    if len(set(kinds.values())) != 1:
        given = ", ".join(f"{name}: {kind.__name__}" for name, kind in kinds.items())
        raise ValueError(
            f"meshes to be joined must have the same kind of cells, got {given or 'none'}"
        )
    parts = list(meshes.values())
    starts = np.cumsum([0, *(mesh.doflocs.shape[1] for mesh in parts[:-1])])
    nodes = [mesh.dofs.element_dofs + at for mesh, at in zip(parts, starts, strict=True)]
    whole = type(parts[0])(np.hstack([mesh.doflocs for mesh in parts]), np.hstack(nodes))
    boundaries, bodies, first = {}, {}, 0
    for name, mesh in meshes.items():
        cells = np.arange(first, first + mesh.nelements)
        facet = np.empty(mesh.nfacets, dtype=np.int64)
        facet[mesh.t2f] = whole.t2f[:, cells]
        for label, facets in (mesh.boundaries or {}).items():
            moved = facet[facets]
            oriented = isinstance(facets, OrientedBoundary)
            boundaries[f"{name}.{label}"] = (
                OrientedBoundary(moved, facets.ori) if oriented else moved
            )
        bodies[name] = cells
        for label, chosen in (mesh.subdomains or {}).items():
            bodies[f"{name}.{label}"] = cells[chosen]
        first += mesh.nelements
    return whole.with_boundaries(boundaries).with_subdomains(bodies)

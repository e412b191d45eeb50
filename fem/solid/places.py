"""Places of loads and supports on a solid: a boundary, a node, or all nodes on a line or plane."""

import numpy as np
from skfem.mesh import Mesh3D

from fem.plane.discretisation import named_facets
from fem.solid.geometry import Indices, faces

Point = tuple[float | None, float | None, float | None]
Place = str | Point
NEAR = 1e-6  # relative to the mesh's extent


def nodes_at(mesh: Mesh3D, place: Place) -> Indices:
    """Nodes of the boundary of that name, or at the coordinates, None meaning all.

    (0.0, 0.0, None) is a line along z. ValueError if the name is unknown or no node is there.
    """
    if isinstance(place, str):
        parts = faces(mesh, named_facets(mesh, place))
        return np.unique(np.concatenate([part.nodes[:, part.on_face].ravel() for part in parts]))
    p = mesh.doflocs
    wanted = [i for i in range(3) if place[i] is not None]
    if len(place) != 3 or not wanted:
        raise ValueError(f"a point has x, y and z, one of them not None, got {place}")
    away = np.max([abs(p[i] - place[i]) for i in wanted], axis=0)
    if not away.min() <= NEAR * np.ptp(p, axis=1).max():
        raise ValueError(
            f"no node at {place}: the nearest is {away.min():.3g} away; give the mesh a node there"
        )
    return np.flatnonzero(away <= NEAR * np.ptp(p, axis=1).max())

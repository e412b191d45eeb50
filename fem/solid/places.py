"""Places of loads and supports on a solid: boundaries, nodes, or nodes on a line or plane."""

import numpy as np
from skfem.mesh import Mesh3D

from fem.plane.discretisation import named_facets
from fem.solid.geometry import Indices, faces

Point = tuple[float | None, float | None, float | None]
Place = str | Point
NEAR = 1e-6  # relative to the mesh's extent


def nodes_at(mesh: Mesh3D, place: Place) -> Indices:
    """Nodes of a named boundary, or nodes at given coordinates, where None means all values.

    (0.0, 0.0, None) is a line along z. Raises ValueError if the name is unknown or if there is no
    node.
    """
    if isinstance(place, str):
        parts = faces(mesh, named_facets(mesh, place))
        return np.unique(np.concatenate([part.nodes[:, part.on_face].ravel() for part in parts]))
    p = mesh.doflocs
    wanted = [i for i in range(3) if place[i] is not None]
    if len(place) != 3 or not wanted:
        raise ValueError(
            f"a point must have x, y and z, of which at least one is a number, got {place}"
        )
    away = np.max([abs(p[i] - place[i]) for i in wanted], axis=0)
    if not away.min() <= NEAR * np.ptp(p, axis=1).max():
        raise ValueError(
            f"no node at {place}: the distance to the nearest node is {away.min():.3g}; add a node "
            "to the mesh"
        )
    return np.flatnonzero(away <= NEAR * np.ptp(p, axis=1).max())

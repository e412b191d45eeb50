"""Topology of a mesh whose nodes move: cells, facets, boundaries, bodies, numbers of nodes.

The last few topologies are cached, with the structure and the cells of the mesh as the key. A
cached topology equals a new one, so that a mesh does not depend on earlier meshes.
"""

from collections.abc import Callable, Hashable
from copy import copy
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from skfem.mesh import Mesh2D

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

MOST = 96  # stored: a sweep over a ring's shape returns to some of three times thirty
NODES = 500_000  # of all that are stored, with 200 bytes each


@dataclass(frozen=True)
class Topology:
    """Mesh whose nodes can be moved.

    `source` (n,) is the index of each node of `mesh` among the nodes read from gmsh.
    """

    mesh: Mesh2D
    source: Indices

    @classmethod
    def of(cls, mesh: Mesh2D, t: Indices) -> "Topology":
        """Topology of `mesh`; `t` (k, m) are gmsh's nodes of its cells in scikit-fem's order."""
        own = np.asarray(mesh.dofs.element_dofs)
        source = np.empty(mesh.doflocs.shape[1], np.int64)
        source[own] = t
        _ = mesh.facets, mesh.f2t  # made once for all meshes
        return cls(mesh, source)

    def at(self, p: Array) -> Mesh2D:
        """Mesh with new positions `p` (2, n) of the nodes in gmsh's order."""
        mesh = copy(self.mesh)
        mesh.doflocs = np.ascontiguousarray(p[:, self.source])
        return mesh


class Topologies:
    """Cache of the last few topologies: at most `most`, with at most `nodes` nodes in total."""

    def __init__(self, most: int = MOST, nodes: int = NODES) -> None:
        self.most, self.nodes = most, nodes
        self.kept: dict[Hashable, Topology] = {}

    def get(self, key: Hashable, make: Callable[[], Topology]) -> Topology:
        """Stored topology for `key`, or a new topology from `make`."""
        found = self.kept.pop(key, None) or make()
        if found.source.size <= self.nodes:
            self.kept[key] = found
        while len(self.kept) > self.most or self._size > self.nodes:
            self.kept.pop(next(iter(self.kept)))
        return found

    @property
    def _size(self) -> int:
        return sum(topology.source.size for topology in self.kept.values())

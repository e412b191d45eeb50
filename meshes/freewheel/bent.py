"""Meshes whose nodes are moved by a map: bodies of a freewheel, mapped from the plane."""

from collections.abc import Mapping
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from skfem import MeshQuad1
from skfem.mesh import Mesh2D

from meshes.contact.blocks import Block, mesh_blocks

Places = NDArray[np.float64]  # (2, nodes)
CACHE_SIZE = 64  # meshes; a sweep over the clamping angle moves the same ones at every step


@lru_cache(CACHE_SIZE)
def flat_mesh(blocks: tuple[Block, ...], order: int) -> Mesh2D:
    """Mesh of `blocks` before mapping. It is stored for reuse and must not be changed."""
    return mesh_blocks(blocks, order=order)


def bent(mesh: Mesh2D, places: Places, names: Mapping[str, str], *, straight: bool) -> Mesh2D:
    """Mesh with the cells of `mesh`, nodes at `places`, and boundaries `names` (old: new name)."""
    bodies = dict(mesh.subdomains)
    boundaries = {new: mesh.boundaries[old] for old, new in names.items()}
    moved = type(mesh)(places, mesh.t)
    if straight:
        moved = MeshQuad1(moved.p[:, : moved.nvertices], moved.t)
    return moved.with_boundaries(boundaries).with_subdomains(bodies)

"""Meshes whose nodes a map moves: the bodies of a freewheel, bent from the plane."""

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
    """The mesh of `blocks` before it is bent. It is stored for reuse: never write into it."""
    return mesh_blocks(blocks, order=order)


def bent(mesh: Mesh2D, places: Places, names: Mapping[str, str], *, straight: bool) -> Mesh2D:
    """The cells of `mesh` on `places`, with the boundaries that have a name in `names`."""
    bodies = dict(mesh.subdomains)
    boundaries = {new: mesh.boundaries[old] for old, new in names.items()}
    moved = type(mesh)(places, mesh.t)
    if straight:
        moved = MeshQuad1(moved.p[:, : moved.nvertices], moved.t)
    return moved.with_boundaries(boundaries).with_subdomains(bodies)

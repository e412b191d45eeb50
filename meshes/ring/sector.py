"""Half a pitch of a ring under evenly spaced loads, as the conformal image of a block.

The exponential function maps the rectangle of angle and ln r to the ring and preserves angles.
Therefore, square cells of a block that is fine at the loaded patch remain square.
"""

import math
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from skfem import MeshQuad1
from skfem.mesh import Mesh2D

from meshes.contact.block import half_block

Wall = Literal["bore", "rim"]
NAMES = {"axis": "load cut", "side": "free cut"}


def half_sector(
    *,
    r_i: float,
    r_o: float,
    n: int,
    loaded: Wall,
    patch: float,
    refine: int,
    cells: int = 8,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """Mesh of the sector 0 <= theta <= pi/n of a ring, fine at a patch on one wall at theta = 0.

    Half the patch, 0 <= r theta <= `patch` [length along the arc], is on the wall `loaded` and has
    `cells` equal cells for `refine` 1; cells are larger outside. `refine` 2 halves all cells, and
    so on. Boundaries: "patch", "bore" and "rim" (the loaded wall includes the patch), "load cut"
    (theta = 0) and "free cut" (theta = pi/n). Body: "ring". `order` is 1 or 2; `straight` cells
    have straight edges. Raises ValueError unless 0 < r_i < r_o, n >= 2, and `patch` is at most a
    quarter of the pitch and at most about the thickness of the wall.
    """
    if not 0 < r_i < r_o < math.inf:
        raise ValueError(f"a ring must have 0 < r_i < r_o, got r_i={r_i:g} m, r_o={r_o:g} m")
    if loaded not in ("bore", "rim"):
        raise ValueError(f"loaded must be 'bore' or 'rim', got {loaded!r}")
    if n < 2:
        raise ValueError(f"balanced, evenly spaced loads require n >= 2, got n={n}")
    r = r_i if loaded == "bore" else r_o
    width, depth, zone = math.pi / n, math.log(r_o / r_i), patch / r
    if not 0 < zone <= min(width / 2, depth):
        raise ValueError(
            "the patch must be positive, at most a quarter of the pitch, and at most about the "
            f"thickness of the wall, got patch={patch:g} m, half of the pitch {width * r:g} m, "
            f"wall {r_o - r_i:g} m"
        )
    block = half_block(
        width=width, depth=depth, zone=zone, refine=refine, cells=cells, order=order,
        above=loaded == "rim",
    )  # fmt: skip
    theta, y = block.doflocs
    points = r * np.exp(-y) * np.array([np.cos(theta), np.sin(theta)])
    return _renamed(block, points, loaded, zone, straight)


def _renamed(
    block: Mesh2D, points: NDArray[np.float64], loaded: Wall, zone: float, straight: bool
) -> Mesh2D:
    """Mesh with the cells of `block`, nodes at `points` (2, n), and boundary names of a ring."""
    walls = {"surface": loaded, "bottom": "rim" if loaded == "bore" else "bore"}
    names = NAMES | walls
    boundaries = {names[name]: facets for name, facets in (block.boundaries or {}).items()}
    wall = boundaries[loaded]
    middle = block.p[0, block.facets[:, wall]].mean(axis=0)
    boundaries["patch"] = wall[middle < zone]
    mesh = type(block)(points, block.t)
    if straight:
        mesh = MeshQuad1(mesh.p[:, : mesh.nvertices], mesh.t)
    bodies = {"ring": np.arange(mesh.nelements)}
    return mesh.with_boundaries(boundaries).with_subdomains(bodies)

"""Complete rings and discs with equal cells around, for contact along a whole circle."""

import math
from dataclasses import replace

from skfem.mesh import Mesh2D

from meshes.contact.blocks import Block, Edge, mesh_blocks

CORE = 0.6  # radius of the corners of a disc's inner square, over the disc's


def full_ring(
    *,
    r_i: float,
    r_o: float,
    around: int,
    across: int,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """Mesh of a ring about the origin with equal cells along its circles.

    There are `around` cells on a circle and `across` cells through the wall. Boundaries: "bore" and
    "rim". Body: "ring". `order` is 1 or 2; `straight` cells have straight edges. Raises ValueError
    unless 0 < r_i < r_o, `around` is a multiple of 4 and `across` >= 1.
    """
    if not 0 < r_i < r_o < math.inf:
        raise ValueError(f"a ring must have 0 < r_i < r_o, got r_i={r_i:g} m, r_o={r_o:g} m")
    if around < 4 or around % 4 or across < 1:
        raise ValueError(
            "a ring requires a positive multiple of 4 cells around and at least one across, got "
            f"around={around}, across={across}"
        )
    bore, rim = (_circle(r, around // 4, name) for r, name in ((r_i, "bore"), (r_o, "rim")))
    return mesh_blocks(_between(bore, rim, across, "ring"), order=order, straight=straight)


def full_disc(*, R: float, around: int, order: int = 2, straight: bool = False) -> Mesh2D:
    """Mesh of a disc about the origin with `around` equal cells on its circle.

    The middle of the mesh is a square. Boundary: "rim". Body: "disc". `order` is 1 or 2; `straight`
    cells have straight edges. Raises ValueError unless R > 0 and `around` is a multiple of 8.
    """
    if not 0 < R < math.inf:
        raise ValueError(f"a disc must have R > 0, got R={R:g} m")
    if around < 8 or around % 8:
        raise ValueError(
            f"a disc requires a positive multiple of 8 cells around, got around={around}"
        )
    rim = _circle(R, around // 4, "rim")
    sides = [replace(arc, centre=None) for arc in _circle(CORE * R, around // 4, "")]
    a, b, c, d = sides
    blocks = [Block((a, b, c, d), "disc"), *_between(sides, rim, around // 8, "disc")]
    return mesh_blocks(blocks, order=order, straight=straight)


def _circle(r: float, cells: int, name: str) -> list[Edge]:
    """Four arcs about the origin, each from one axis to the next."""
    corners = [(r, 0.0), (0.0, r), (-r, 0.0), (0.0, -r)]
    return [Edge(corners[k - 1], corners[k], cells, centre=(0.0, 0.0), name=name) for k in range(4)]


def _between(inner: list[Edge], outer: list[Edge], across: int, body: str) -> list[Block]:
    """Four blocks between two closed chains of edges."""
    spokes = [Edge(a.start, b.start, across) for a, b in zip(inner, outer, strict=True)]
    return [Block((inner[k], spokes[(k + 1) % 4], outer[k], spokes[k]), body) for k in range(4)]

"""Rectangular blocks: graded about a contact at the origin, or with equal cells."""

import math
from typing import get_args

from skfem.mesh import Mesh2D

from meshes.contact.blocks import Block, Cells, Edge, mesh_blocks
from meshes.contact.fan import Outline, Zone, fan, strip_cells

SLIM = 1.5  # a longer rectangle is meshed as about a square and a strip of even cells


def half_block(
    *,
    width: float,
    depth: float,
    zone: float,
    refine: int,
    cells: int = 6,
    above: bool = False,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """Mesh of the block 0 <= x <= width, -depth <= y <= 0, fine at the origin.

    With `refine` 1, `cells` equal cells lie on 0 <= x <= `zone` [unit of width]; cells are larger
    outside. `refine` 2 halves all cells, and so on. Boundaries: "surface" (y = 0), "axis" (x = 0),
    "side" and "bottom" (y = -depth). Body: "block". With `above`, the block lies at 0 <= y <=
    depth. `order` is 1 or 2; `straight` cells have straight edges. Raises ValueError unless 0 <
    zone <= width/2 and zone <= depth.
    """
    half = _half(width, depth, Zone(zone, cells, refine), "side")
    blocks = [block.mirrored(1, -1 if above else 1) for block in half]
    return mesh_blocks(blocks, order=order, straight=straight)


def full_block(
    *,
    width: float,
    depth: float,
    zone: float,
    refine: int,
    cells: int = 6,
    above: bool = False,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """Mesh of the half block and its mirror image as one body, for loads without symmetry.

    The block covers -width <= x <= width. The boundaries "right" and "left" replace "side", and
    "axis" is inside the body. For all other properties, see `half_block`.
    """
    y = -1 if above else 1
    blocks = [
        block.mirrored(x, y)
        for x, side in ((1, "right"), (-1, "left"))
        for block in _half(width, depth, Zone(zone, cells, refine), side)
    ]
    return mesh_blocks(blocks, order=order, straight=straight)


def block(
    *,
    x: tuple[float, float],
    y: tuple[float, float],
    nx: int,
    ny: int,
    cells: Cells = "quad",
    order: int = 2,
) -> Mesh2D:
    """Mesh of a rectangle with `nx` by `ny` equal cells; "tri" divides each into two triangles.

    The rectangle lies between the two values of `x` and the two values of `y`. Boundaries: "left",
    "right", "bottom" and "top". Body: "block". `order` is 1 or 2. Raises ValueError unless the
    second values of x and y are above the first, and `nx`, `ny` are at least 1.
    """
    (left, right), (bottom, top) = x, y
    if cells not in get_args(Cells):
        raise ValueError(f"cells must be 'quad' or 'tri', got {cells!r}")
    growing = all(-math.inf < low < high < math.inf for low, high in (x, y))
    if not growing or min(nx, ny) < 1:
        raise ValueError(
            f"a block requires rising x and y and nx, ny > 0, got x={x}, y={y}, nx={nx}, ny={ny}"
        )
    a, b, c, d = (left, bottom), (right, bottom), (right, top), (left, top)
    edges = (
        Edge(a, b, nx, name="bottom"),
        Edge(b, c, ny, name="right"),
        Edge(d, c, nx, name="top"),
        Edge(a, d, ny, name="left"),
    )
    return mesh_blocks([Block(edges, "block")], cells=cells, order=order)


def _half(width: float, depth: float, zone: Zone, side: str) -> list[Block]:
    if not (0 < zone.width <= min(width / 2, depth) and max(width, depth) < math.inf):
        raise ValueError(
            "the fine zone of a block must have 0 < zone <= width/2 and zone <= depth, got "
            f"zone={zone.width:g} m, width={width:g} m, depth={depth:g} m"
        )
    beside = zone.width - zone.depth  # the core's, so that the diagonal runs at half a right angle
    w = depth + beside if width > SLIM * depth else width
    d = width - beside if depth > SLIM * width else depth
    names = ("surface", side if w == width else "", "bottom" if d == depth else "")
    blocks = fan(Outline((w, 0.0), (w, -d), (0.0, -d), names), zone, "block")
    if w < width:
        blocks.append(_beside(blocks[1], zone, width, side))
    if d < depth:
        blocks.append(_under(blocks[2], zone, depth, side))
    return blocks


def _beside(fanned: Block, zone: Zone, width: float, side: str) -> Block:
    """Strip with equal cells from the end of the fan to x = `width`."""
    surface, end, *_ = fanned.edges
    n = strip_cells(surface, zone, length=width - end.start[0])
    a, b = (width, end.start[1]), (width, end.end[1])
    edges = (
        Edge(end.start, a, n, name="surface"),
        Edge(a, b, end.cells, name=side),
        Edge(end.end, b, n, name="bottom"),
        end,
    )
    return Block(edges, fanned.body)


def _under(fanned: Block, zone: Zone, depth: float, side: str) -> Block:
    """Strip with equal cells from the lower end of the fan to y = -`depth`."""
    *_, last, axis = fanned.edges
    n = strip_cells(axis, zone, length=depth + last.start[1])
    far, foot = (last.end[0], -depth), (0.0, -depth)
    edges = (
        Edge(last.start, foot, n, name="axis"),
        Edge(far, foot, last.cells, name="bottom"),
        Edge(last.end, far, n, name=side),
        last,
    )
    return Block(edges, fanned.body)

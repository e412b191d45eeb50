"""Discs that touch at the origin, down to the cut through their centre."""

import math

from skfem.mesh import Mesh2D

from meshes.contact.blocks import Block, Point, mesh_blocks
from meshes.contact.fan import Outline, Zone, fan


def quarter_disc(
    *,
    R: float,
    zone: float,
    refine: int,
    cells: int = 6,
    below: bool = False,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """The quarter x >= 0 of the disc about (0, R) that lies next to the origin.

    On `refine` 1 `cells` even cells lie on the arc over 0 <= x <= `zone` [unit of R] and grow
    outside; 2 halves them all, and so on. Boundaries "surface" (the arc), "axis" (x = 0) and
    "middle" (the cut y = R); body "disc". The disc `below` lies about (0, -R) instead. `order` 1
    or 2; `straight` cells keep straight edges. Raises ValueError unless 0 < zone <= R/2.
    """
    blocks = [block.mirrored(1, 1 if below else -1) for block in _quarter(R, zone, cells, refine)]
    return mesh_blocks(blocks, order=order, straight=straight)


def half_disc(
    *,
    R: float,
    zone: float,
    refine: int,
    cells: int = 6,
    below: bool = False,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """The quarter disc and its mirror image as one body, for loads without symmetry.

    Fine cells lie over -zone <= x <= zone; the boundary "axis" is inside the body. Otherwise as
    `quarter_disc`.
    """
    quarter = _quarter(R, zone, cells, refine)
    y = 1 if below else -1
    blocks = [block.mirrored(x, y) for x in (1, -1) for block in quarter]
    return mesh_blocks(blocks, order=order, straight=straight)


def _quarter(R: float, zone: float, cells: int, refine: int) -> list[Block]:
    """Blocks of the quarter about (0, -R)."""
    if not 0 < zone <= R / 2 < math.inf:
        raise ValueError(
            f"the fine zone of a disc needs 0 < zone <= R/2, got zone={zone:g} m, R={R:g} m"
        )
    core = Zone(zone, cells, refine)
    names = ("surface", "middle", "middle")
    corner = Outline((R, -R), (R, -R), (0.0, -R), names, centre=-R).edge_of(core)[1]
    bend, far = _diagonal(R, corner)
    return fan(Outline((R, -R), far, (0.0, -R), names, centre=-R), core, "disc", bend)


def _diagonal(R: float, corner: Point) -> tuple[Point, Point]:
    """Centre and end of the circle from `corner` that meets the cut at a right angle.

    It goes through the points where the axis meets the disc's circle: with that circle and the
    axis it is one of the circles of bipolar coordinates, which part the disc at even angles.
    """
    x, y = corner
    c = (-y * R - (x**2 + y**2) / 2) / x
    return (-c, -R), (math.hypot(c, R) - c, -R)

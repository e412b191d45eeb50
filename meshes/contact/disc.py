"""Quarters and halves of discs, with the contact at the origin."""

import math

from skfem.mesh import Mesh2D

from meshes.contact.blocks import Block, Point, mesh_blocks
from meshes.contact.fan import Outline, Zone, core, fan


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
    """Mesh of the quarter x >= 0, y <= R of the disc about (0, R), fine at the origin.

    With `refine` 1, `cells` equal cells lie on the arc over 0 <= x <= `zone` [unit of R]; cells are
    larger outside. `refine` 2 halves all cells, and so on. Boundaries: "surface" (the arc), "axis"
    (x = 0) and "middle" (the section y = R). Body: "disc". With `below`, the disc is about (0, -R).
    `order` is 1 or 2; `straight` cells have straight edges. Raises ValueError unless 0 < zone <=
    R/2.
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
    """Mesh of the quarter disc and its mirror image as one body, for loads without symmetry.

    Fine cells lie over -zone <= x <= zone; the boundary "axis" is inside the body. For all other
    properties, see `quarter_disc`.
    """
    quarter = _quarter(R, zone, cells, refine)
    y = 1 if below else -1
    blocks = [block.mirrored(x, y) for x in (1, -1) for block in quarter]
    return mesh_blocks(blocks, order=order, straight=straight)


def _quarter(R: float, zone: float, cells: int, refine: int) -> list[Block]:
    """Blocks of the quarter disc about (0, -R)."""
    if not 0 < zone <= R / 2 < math.inf:
        raise ValueError(
            f"the fine zone of a disc must have 0 < zone <= R/2, got zone={zone:g} m, R={R:g} m"
        )
    fine = Zone(zone, cells, refine)
    bend, far = diagonal(core(fine, -R)[1], math.pi / 4 + math.asin(zone / R), R)
    names = ("surface", "middle", "middle")
    return fan(Outline((R, -R), far, (0.0, -R), names, centre=-R), fine, "disc", bend)


def diagonal(corner: Point, slope: float, R: float) -> tuple[Point, Point]:
    """Centre and end of an arc that starts at `corner` and ends normal to the line y = -R.

    At the corner, the arc descends at the angle `slope` [rad].
    """
    x, y = corner
    radius = (R + y) / math.cos(slope)
    x -= radius * math.sin(slope)
    return (x, -R), (x + radius, -R)

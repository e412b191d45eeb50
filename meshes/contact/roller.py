"""Half a roller that is compressed at both ends of a diameter."""

import math
from collections.abc import Sequence
from dataclasses import replace

from skfem.mesh import Mesh2D

from meshes.contact.blocks import Block, Place, Point, mesh_blocks
from meshes.contact.disc import diagonal
from meshes.contact.fan import Outline, Zone, core, fan

BODY = "roller"


def half_roller(
    *,
    R: float,
    zones: tuple[float, float],
    refine: int,
    cells: int = 6,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """Mesh of the half y >= 0 of the disc about the origin, fine at (-R, 0) and (R, 0).

    With `refine` 1, `cells` equal cells lie on the arc over 0 <= y <= zone [unit of R] at each end.
    `zones` are the values of zone at (-R, 0), "near", and at (R, 0), "far". Cells are larger
    outside. `refine` 2 halves all cells, and so on. Boundaries: "near" (the arc in x <= 0), "far"
    (the arc in x >= 0) and "cut" (y = 0). Body: "roller". `order` is 1 or 2; `straight` cells have
    straight edges. Raises ValueError unless 0 < zone <= R/2 at both ends.
    """
    for zone in zones:
        if not 0 < zone <= R / 2 < math.inf:
            raise ValueError(
                f"the fine zones of a roller must have 0 < zone <= R/2, got {zone:g} m, R={R:g} m"
            )
    blocks = half_blocks(R, [Zone(zone, cells, refine) for zone in zones])
    return mesh_blocks(blocks, order=order, straight=straight)


def half_blocks(R: float, fine: Sequence[Zone]) -> list[Block]:
    """Blocks of the half roller, with the fine zones `fine` at (-R, 0) and (R, 0)."""
    wide = max(fine, key=lambda zone: zone.width)
    # both quarters end on one cut, and their diagonals in one point of it
    _, far = diagonal(core(wide, -R)[1], math.pi / 4 + math.asin(wide.width / R), R)
    return [
        block.placed(place)
        for name, place, zone in zip(("near", "far"), _places(R), fine, strict=True)
        for block in _quarter(R, zone, far, name)
    ]


def _places(R: float) -> tuple[Place, Place]:
    """Maps from the frame of the quarter (contact at the origin, body below) to each end."""
    return (lambda point: (-R - point[1], point[0])), (lambda point: (R + point[1], point[0]))


def _quarter(R: float, zone: Zone, far: Point, name: str) -> list[Block]:
    """Blocks of the quarter about (0, -R); the diagonal is normal to y = -R at `far`."""
    x, y = core(zone, -R)[1]
    bend = (far[0] ** 2 - x**2 - (y + R) ** 2) / (2 * (far[0] - x)), -R
    outline = Outline((R, -R), far, (0.0, -R), (name, "", ""), centre=-R)
    return [_cut(block) for block in fan(outline, zone, BODY, bend)]


def _cut(block: Block) -> Block:
    """Block with the axis of the fan named as the section "cut" of the roller."""
    a, b, c, d = (replace(e, name="cut") if e.name == "axis" else e for e in block.edges)
    return replace(block, edges=(a, b, c, d))

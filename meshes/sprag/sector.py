"""One pitch of a sprag clutch: inner race, sprag and outer race about the axis (0, 0)."""

import math

from skfem.mesh import Mesh2D

from meshes.contact.blocks import Point
from meshes.contact.fan import Zone
from meshes.freewheel.races import RoundRace
from meshes.join import join
from meshes.sprag.column import column_mesh, reaches
from meshes.sprag.limits import check_beside, check_flank, check_place, check_radii, check_zone
from meshes.sprag.profile import Placed, Sprag


def sprag_sector(
    *,
    R_id: float,
    R_i: float,
    R_e: float,
    R_ed: float,
    z: int,
    sprag: Sprag,
    pole: Point,
    turn: float,
    zones: tuple[float, float],
    cells: int = 6,
    refine: int = 1,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """Mesh of the races `R_id`..`R_i` and `R_e`..`R_ed`, and of one of `z` sprags between them.

    The pole of the sprag is at `pole`, above the axis. The sprag is rotated clockwise by `turn`
    [rad]. Sprag and races may overlap or have a gap.

    The `zones` [unit of the radii] are half-widths of the fine zones at the inner and the outer
    contact. With `refine` 1, each half of a zone has `cells` equal cells on both bodies; cells are
    larger outside. `refine` 2 halves all cells, and so on. Bodies: "inner", "sprag" and "outer".
    Boundaries of the races: "inner.bore", "inner.rim", "outer.bore", "outer.rim", and the sections
    "left" and "right" of both races. Boundaries of the sprag: "sprag.inner" (the spiral),
    "sprag.outer" (the arc), and the flanks "sprag.left" and "sprag.right". Each race is centred on
    its contact. Its "right" is the section at larger x; rotated anticlockwise by 2 pi/z, its nodes
    coincide with those of "left". `order` is 1 or 2; `straight` cells have straight edges.

    Raises ValueError, in metres, for impossible bodies, and if a fine zone is too wide.
    """
    check_radii((R_id, R_i, R_e, R_ed), z)
    at, pitch = Placed(sprag, pole, turn), 2 * math.pi / z
    check_place(at, R_i, R_e)
    check_beside(at, pitch)
    inner = RoundRace(R_i, R_id, pitch, math.atan2(*at.inner), ("rim", "bore", "inner"))
    outer = RoundRace(R_e, R_ed, pitch, math.atan2(*at.outer), ("bore", "rim", "outer"))
    for where, race, reach, zone in zip(
        ("inner", "outer"), (inner, outer), reaches(at), zones, strict=True
    ):
        check_flank(where, reach)
        check_zone(where, race, reach.least, zone)
    low, high = fine = Zone(zones[0], cells, refine), Zone(zones[1], cells, refine)
    return join(
        {
            "inner": inner.mesh(low, order=order, straight=straight),
            "sprag": column_mesh(at, fine, order=order, straight=straight),
            "outer": outer.mesh(high, order=order, straight=straight),
        }
    )

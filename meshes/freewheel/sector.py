"""One pitch of a roller freewheel: the cam with flats, a roller and the round race.

The origin is on the axis. The flat is normal to the y axis; the centre of the roller is at x >= 0,
at the angle psi from the y axis.
"""

import math

from skfem.mesh import Mesh2D

from meshes.contact.blocks import Point
from meshes.contact.fan import Zone
from meshes.freewheel.limits import check_radii, check_roller, check_zones
from meshes.freewheel.races import FlatRace, RoundRace
from meshes.freewheel.roller import bent_roller
from meshes.join import join

CLEARANCE = 0.2  # relative to the roller's radius, between the tip of a star and the ring


def inner_cam_sector(
    *,
    R: float,
    R_a: float,
    X: float,
    r_b: float,
    r: float,
    z: int,
    centre: Point,
    zones: tuple[float, float],
    cells: int = 6,
    refine: int = 1,
    clearance: float | None = None,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """Mesh of a star with the flat y = `X`, a roller of radius `r` about `centre`, and the ring.

    The star has `z` flats and the bore radius `r_b`, the ring the bore radius `R` and the outer
    radius `R_a`. All lengths have the same unit. Roller and races may overlap or have a gap. If the
    distance of a tip of the star from the ring is less than half of the `clearance` (by default
    r/5), the tip is cut by the circle at this clearance.

    The `zones` are half-widths of the fine zones at the contacts of the star and of the ring. With
    `refine` 1, `cells` equal cells lie on each half on both bodies; cells are larger outside.
    `refine` 2 halves all cells, and so on. Bodies: "star", "roller" and "ring". Boundaries of the
    star: "star.flat", "star.bore", "star.left", "star.right" and, if cut, "star.tip". Boundaries of
    the roller: "roller.inner" and "roller.outer", the halves of its rim at the contacts of the star
    and of the ring. Boundaries of the ring: "ring.bore", "ring.rim", "ring.left" and "ring.right".
    "right" is the section at larger x; rotated anticlockwise by 2 pi/z, its nodes coincide with
    those of "left". A vertex of the roller is at `centre`. `order` is 1 or 2; `straight` cells have
    straight edges.

    Raises ValueError, in metres, for impossible bodies, and if a fine zone is too wide.
    """
    check_radii("r_b < X < R < R_a", (r_b, X, R, R_a), z)
    gap = CLEARANCE * r if clearance is None else clearance
    if not 0 < gap < R - X:
        raise ValueError(
            f"the clearance of a star must be between 0 and R - X = {R - X:g} m, got {gap:g} m"
        )
    pitch, psi = 2 * math.pi / z, math.atan2(*centre)
    tip = R - gap if X / math.cos(pitch / 2) > R - gap / 2 else math.inf
    star = FlatRace(X, r_b, pitch, centre[0], ("flat", "bore", "star"), tip)
    ring = RoundRace(R, R_a, pitch, psi, ("bore", "rim", "ring"))
    check_roller(r, centre, z, flat=centre[1] - X, circle=R - math.hypot(*centre))
    check_zones(r, star, ring, flat=zones[0], circle=zones[1])
    inner, outer = fine = Zone(zones[0], cells, refine), Zone(zones[1], cells, refine)
    roller = bent_roller(
        r=r, centre=centre, rays=(math.pi, psi), zones=fine, order=order, straight=straight
    )
    return join(
        {
            "star": star.mesh(inner, order=order, straight=straight),
            "roller": roller,
            "ring": ring.mesh(outer, order=order, straight=straight),
        }
    )


def outer_cam_sector(
    *,
    R_s: float,
    r_b: float,
    X_o: float,
    R_a: float,
    r: float,
    z: int,
    centre: Point,
    zones: tuple[float, float],
    cells: int = 6,
    refine: int = 1,
    order: int = 2,
    straight: bool = False,
) -> Mesh2D:
    """Mesh of a shaft of radius `R_s`, a roller about `centre`, and a cup with the flat y = `X_o`.

    The roller has the radius `r`, the shaft the bore radius `r_b`, the cup `z` inner flats and the
    outer radius `R_a`. The `zones` are the half-widths of the fine zones at the contacts of the
    shaft and of the cup. Bodies: "shaft", "roller" and "cup". Boundaries: "shaft.rim",
    "shaft.bore", "cup.flat", "cup.rim", and the sections "left" and "right" of shaft and cup;
    "roller.inner" is at the contact of the shaft, "roller.outer" at the contact of the cup. For all
    other properties, see `inner_cam_sector`.
    """
    check_radii("r_b < R_s < X_o < R_a cos(pi/z)", (r_b, R_s, X_o, R_a * math.cos(math.pi / z)), z)
    pitch, psi = 2 * math.pi / z, math.atan2(*centre)
    shaft = RoundRace(R_s, r_b, pitch, psi, ("rim", "bore", "shaft"))
    cup = FlatRace(X_o, R_a, pitch, centre[0], ("flat", "rim", "cup"))
    check_roller(r, centre, z, flat=X_o - centre[1], circle=math.hypot(*centre) - R_s)
    check_zones(r, cup, shaft, flat=zones[1], circle=zones[0])
    inner, outer = fine = Zone(zones[0], cells, refine), Zone(zones[1], cells, refine)
    roller = bent_roller(
        r=r, centre=centre, rays=(math.pi + psi, 0.0), zones=fine, order=order, straight=straight
    )
    return join(
        {
            "shaft": shaft.mesh(inner, order=order, straight=straight),
            "roller": roller,
            "cup": cup.mesh(outer, order=order, straight=straight),
        }
    )
